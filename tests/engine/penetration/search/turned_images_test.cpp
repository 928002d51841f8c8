// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/turned_images.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

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

// Reference: the nearest of seats that are all alike, in closed form: a plug with n teeth that is
// turned about its axis is as well off in any of its n seats.
TEST(TurnedImages, the_nearest_of_seats_that_are_alike_is_found) {
  int missed = 0;
  for (const int teeth : {3, 5, 6}) {
    const test::Section section = test::toothed_section(teeth, 6 * mm, 9 * mm);
    const double room = 0.05 * mm;
    const Pair pair(test::body(test::fitted_plug(section, 20 * mm, {})),
                    test::body(test::fitted_socket(test::grown(section, room), 2, 16 * mm, {})));
    for (const double part : {0.25, 1.3, 2.2})
      for (const std::uint64_t seed : {1U, 2U}) {
        const double seat = 2 * std::numbers::pi / teeth;
        const double aside = (part - std::round(part)) * seat;
        const Pose device = turned_about_z(part * seat);
        const Chart chart(pair.probe().mass, device);
        const double back = chart.coordinates(turned_about_z(std::round(part) * seat)).norm();
        const Separation got = separate_static(pair, device, {.seed = seed});
        ASSERT_EQ(got.status, Status::penetrating) << teeth << ' ' << part << ' ' << aside;
        missed += got.depth > 1.001 * back;
      }
  }
  EXPECT_EQ(missed, 0);
}

}  // namespace
}  // namespace sonde
