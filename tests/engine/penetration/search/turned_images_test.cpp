// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/turned_images.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/geometry/random.hpp"
#include "engine/geometry/rotation.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "tests/support/fitted_parts.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

constexpr double mm = 1e-3;

Pose turned_about_z(double angle, double height = 0) {
  return {rotation_about(Vec3::UnitZ(), angle), {0, 0, height}};
}

// References: the fractions m/n below 1 with n up to 12, of which there are 45 (sums of Euler's
// totient), so the six axes have 270; and the group of a seven-toothed section, whose images of the
// seat are seats.
TEST(TurnedImages, are_all_parts_of_a_round_about_the_axes_of_both_bodies) {
  const auto plug =
      test::body(test::fitted_plug(test::toothed_section(7, 12 * mm, 18 * mm), 9 * mm, {}));
  const auto socket = test::body(test::box({0.1, 0.06, 0.02}));
  const double angle = 0.3;
  const Chart chart(plug->mass, turned_about_z(angle));
  const Vec6 end = chart.coordinates(Pose{});
  const double anywhere = std::numeric_limits<double>::infinity();
  const std::vector<Vec6> all = turned_images(chart, socket->mass, end, anywhere);
  // Of turns near half a round about a tilted axis, some leave the chart.
  EXPECT_LE(all.size(), 270U);
  EXPECT_GE(all.size(), 200U);
  for (std::size_t k = 1; k < all.size(); ++k) EXPECT_LE(all[k - 1].norm(), all[k].norm());

  double nearest = anywhere;
  for (int n = 2; n <= 12; ++n)
    for (int m = 1 - n; m < n; ++m)
      if (m != 0) nearest = std::min(nearest, std::abs(2 * std::numbers::pi * m / n - angle));
  const double root = std::sqrt(plug->mass.inertia[2]);
  EXPECT_NEAR(all.front().norm(), 2 * root * std::sin(nearest / 2), 1e-12);

  const double limit = all[9].norm();
  const auto below = std::ranges::count_if(all, [&](const Vec6& y) { return y.norm() < limit; });
  EXPECT_EQ(std::ssize(turned_images(chart, socket->mass, end, limit)), below);
}

// Reference: the nearest of seats that are all alike is free, so its distance is an upper bound of
// the depth.
TEST(TurnedImages, the_nearest_of_seats_that_are_alike_is_found) {
  int found = 0, all = 0;
  for (const int teeth : {5, 6, 8}) {
    const test::Section section = test::toothed_section(teeth, 7 * mm, 8.5 * mm);
    const Pair pair(
        test::body(test::fitted_plug(section, 12 * mm, {})),
        test::body(test::fitted_socket(test::grown(section, 0.03 * mm), 2, 9 * mm, {}, 4 * mm)));
    for (std::uint64_t seed = 0; seed < 4; ++seed, ++all) {
      Random random(seed);
      const double seat = 2 * std::numbers::pi / teeth, height = 7.2 * mm;
      Pose device = turned_about_z(random.uniform(-1, 1) * 1.5, height);
      device.p += 7 * mm * Vec3(random.uniform(-1, 1), random.uniform(-1, 1), 0);
      device.p.z() -= 6 * mm * random.uniform(0, 1);
      const Chart chart(pair.probe().mass, device);
      double back = std::numeric_limits<double>::infinity();
      for (int k = 0; k < teeth; ++k)
        back = std::min(back, chart.coordinates(turned_about_z(k * seat, height)).norm());
      const Separation got = separate_static(pair, device);
      ASSERT_EQ(got.status, Status::penetrating) << teeth << ' ' << seed;
      found += got.depth <= 1.01 * back;
    }
  }
  EXPECT_GE(found, all - 1) << "of " << all;
}

}  // namespace
}  // namespace sonde
