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

/// A disc whose radius swings so many times, in a number of corners that has its symmetry.
test::Section lobed_section(int lobes, double radius, double swing) {
  test::Section out;
  const int corners = 8 * lobes;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    const double r = radius + swing * std::cos(lobes * angle);
    out.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  return out;
}

// Reference: the seats are alike and free, so the distance of the nearest, at any height that the
// socket leaves, is an upper bound of the depth.
TEST(TurnedImages, the_nearest_of_seats_that_are_alike_is_found) {
  constexpr int lobes = 7;
  const test::Section section = lobed_section(lobes, 5 * mm, 0.75 * mm);
  const Pair pair(
      test::body(test::fitted_plug(section, 8 * mm, {})),
      test::body(test::fitted_socket(test::grown(section, 0.03 * mm), 2, 7.5 * mm, {}, 3 * mm)));
  int missed = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    Random random(seed);
    const Vec3 axis{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const Pose device{
        rotation_about(axis.normalized(), random.uniform(0.8, 1.6)),
        {random.uniform(-3, 3) * mm, random.uniform(-3, 3) * mm, random.uniform(3, 7) * mm}};
    const Chart chart(pair.probe().mass, device);
    double back = std::numeric_limits<double>::infinity();
    for (int k = 0; k < lobes; ++k)
      for (const double height : {4 * mm, 5 * mm, 6 * mm})
        back = std::min(
            back,
            chart.coordinates(turned_about_z(2 * std::numbers::pi * k / lobes, height)).norm());
    for (const std::uint64_t of_search : {1U, 2U, 3U}) {
      const Separation got = separate_static(pair, device, {.seed = of_search});
      ASSERT_EQ(got.status, Status::penetrating) << seed;
      missed += got.depth > 1.01 * back;
    }
  }
  EXPECT_EQ(missed, 0) << "of 24; 2 without the images";
}

}  // namespace
}  // namespace sonde
