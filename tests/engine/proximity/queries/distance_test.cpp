// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/queries/distance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "engine/proximity/queries/intersect.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/queries/point_distance.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/pairs.hpp"

namespace sonde {
namespace {

/// The largest coordinate there is at X.
double size_of_all(const test::BodyPair& pair, const Transform& X) {
  return extent(*pair.a) + extent(*pair.b) + X.p.cwiseAbs().maxCoeff();
}

// Reference: closest_points (itself tested in long double) on every pair of triangles.
TEST(Distance, is_the_least_over_all_pairs_whatever_the_hint) {
  std::mt19937_64 random(1);
  for (const auto& pair : test::body_pairs(21)) {
    int apart = 0;
    for (int i = 0; i < 60; ++i) {
      const Transform X(test::random_pose(random, *pair.a, *pair.b, 1.5));
      const Distance d = triangle_distance(*pair.a, *pair.b, X);
      const double expected = test::least_distance_of_pairs(*pair.a, *pair.b, X);
      const double rounding = 1e-14 * size_of_all(pair, X);
      EXPECT_NEAR(d.distance, expected, rounding) << pair.name << i;
      EXPECT_NEAR((d.on_a - d.on_b).norm(), d.distance, rounding) << pair.name;
      const Corners ta = place(X, corners(surface(*pair.a), d.triangle_a)),
                    tb = corners(surface(*pair.b), d.triangle_b);
      EXPECT_NEAR(closest_points(ta, tb).distance, d.distance, rounding) << pair.name;
      EXPECT_EQ(d.overlapping, d.distance <= 0) << pair.name;
      const DistanceHint hint{
          static_cast<std::uint32_t>(random() % surface(*pair.a).triangles.size()),
          static_cast<std::uint32_t>(random() % surface(*pair.b).triangles.size())};
      EXPECT_NEAR(triangle_distance(*pair.a, *pair.b, X, hint).distance, d.distance, rounding);
      const DistanceHint nonsense{1u << 30, 1u << 30};
      EXPECT_NEAR(triangle_distance(*pair.a, *pair.b, X, nonsense).distance, d.distance, rounding);
      apart += d.distance > 0;
    }
    EXPECT_GT(apart, 20) << pair.name;
  }
}

// Moved apart by the distance along the closest direction two convex bodies touch; by hand here.
TEST(Distance, by_hand_and_inside_a_solid) {
  const auto cube = test::body(test::box({1, 1, 1})), dot = test::body(test::box({0.1, 0.1, 0.1}));
  const auto at = [](double x, double y, double z) {
    Transform X;
    X.p = Vec3(x, y, z);
    return X;
  };
  EXPECT_DOUBLE_EQ(distance(*dot, *cube, at(0, 0, 1.05)).distance, 0.5);
  EXPECT_DOUBLE_EQ(distance(*dot, *cube, at(0.85, 0.95, 0)).distance, 0.5);
  const Distance contained = distance(*dot, *cube, at(0.125, 0.25, -0.0625));
  EXPECT_TRUE(contained.overlapping);
  EXPECT_EQ(contained.distance, 0);
  EXPECT_NEAR((contained.on_a - contained.on_b).norm(), 0.2, 1e-15);
  EXPECT_NEAR(triangle_distance(*dot, *cube, at(0.125, 0.25, -0.0625)).distance, 0.2, 1e-15);
  EXPECT_TRUE(distance(*cube, *dot, at(0.125, 0.25, -0.0625)).overlapping);
}

// Reference: the point as a triangle of no size, against every triangle, in long double.
TEST(Distance, of_a_point) {
  std::mt19937_64 random(2);
  for (const auto& pair : test::body_pairs(22)) {
    const auto triangles = test::placed_triangles(*pair.b, {});
    for (int i = 0; i < 25; ++i) {
      const Vec3 x = pair.b->mass.com + test::random_in_ball(random, 2 * pair.b->mass.radius);
      double lower = 1e300, upper = 1e300;
      for (const Corners& t : triangles) {
        const auto bounds = test::triangle_distance_bounds({x, x, x}, t);
        lower = std::min(lower, bounds.lower), upper = std::min(upper, bounds.upper);
      }
      const double rounding = 1e-14 * (extent(*pair.b) + x.cwiseAbs().maxCoeff());
      const double d = point_distance(*pair.b, x);
      EXPECT_GE(d, lower - rounding) << pair.name;
      EXPECT_LE(d, upper + rounding) << pair.name;
      // Stopping early: still a distance to some triangle, and below `enough`.
      const double early = point_distance(*pair.b, x, 1.5 * d);
      EXPECT_GE(early, d);
      EXPECT_LT(early, 1.5 * d + rounding);
      EXPECT_EQ(point_distance(*pair.b, x, 0.5 * d), d);
    }
  }
}

// Reference: as above. Radii between two distances, so that rounding decides nothing.
TEST(Distance, triangles_within_a_radius_are_all_that_are_no_further) {
  std::mt19937_64 random(4);
  for (const auto& pair : test::body_pairs(24)) {
    const auto triangles = test::placed_triangles(*pair.b, {});
    for (int i = 0; i < 25; ++i) {
      const Vec3 x = pair.b->mass.com + test::random_in_ball(random, 1.5 * pair.b->mass.radius);
      std::vector<std::pair<double, std::uint32_t>> by_distance;
      for (std::uint32_t t = 0; t < triangles.size(); ++t)
        by_distance.emplace_back(test::triangle_distance_bounds({x, x, x}, triangles[t]).lower, t);
      std::ranges::sort(by_distance);
      const std::size_t count = 1 + random() % 8;
      const double last = by_distance[count - 1].first, next = by_distance[count].first;
      if (next - last < 1e-9 * next) continue;
      std::vector<std::uint32_t> found(triangles.size()), expected;
      found.resize(triangles_within(*pair.b, x, 0.5 * (last + next), found));
      for (std::size_t k = 0; k < count; ++k) expected.push_back(by_distance[k].second);
      std::ranges::sort(found);
      std::ranges::sort(expected);
      EXPECT_EQ(found, expected) << pair.name << i;
      std::array<std::uint32_t, 1> one;
      EXPECT_EQ(triangles_within(*pair.b, x, 0.5 * (last + next), one), 1U);
    }
  }
}

TEST(Distance, does_not_allocate) {
  std::mt19937_64 random(3);
  const auto pairs = test::body_pairs(23);
  double sum = 0;
  test::AllocationCounter counter;
  for (const auto& pair : pairs)
    for (int i = 0; i < 20; ++i) {
      const Transform X(test::random_pose(random, *pair.a, *pair.b, 1.5));
      sum += triangle_distance(*pair.a, *pair.b, X).distance;
      sum += distance(*pair.a, *pair.b, X).distance;
      sum += point_distance(*pair.b, X.p);
      std::array<std::uint32_t, 8> near;
      sum += static_cast<double>(triangles_within(*pair.b, X.p, 0.1, near));
    }
  counter.stop();
  EXPECT_EQ(counter.allocations(), 0u) << sum;
}

// A triangle so small that the squares of its edges vanish is a point, not a face that all goes
// through.
TEST(Distance, a_minute_triangle_is_nowhere_else) {
  for (const double size : {1e-30, 1e-50, 1e-65, 1e-67, 1e-69, 1e-90}) {
    PolygonSoup with_it{
        {{-size, 0, -size}, {size, 0, -size}, {0, 0, size}, {-3, 0, 0}, {-4, 0, 0}, {-3, 1, 0}},
        {{0, 1, 2}, {3, 4, 5}}};
    PolygonSoup beside{{{1, -1, 0}, {2, -1, 0}, {1, 1, 0}}, {{0, 1, 2}}};
    const auto a = test::body(with_it, Model::surface), b = test::body(beside, Model::surface);
    EXPECT_NEAR(distance(*a, *b, {}).distance, surface(*a).triangles.size() == 2 ? 1 : 4, 1e-14)
        << size;
  }
}

}  // namespace
}  // namespace sonde
