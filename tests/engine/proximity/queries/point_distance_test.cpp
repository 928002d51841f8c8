// SPDX-License-Identifier: GPL-3.0-or-later
// Distances, and the triangles within one, are tested with those of bodies (distance_test.cpp).
#include "engine/proximity/queries/point_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/proximity/queries/placement.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/pairs.hpp"

namespace sonde {
namespace {

// Reference: by hand, beside a face, an edge and a corner of a box, and within it.
TEST(PointDistance, the_nearest_point_of_a_box_is_that_with_clamped_coordinates) {
  const auto box = test::body(test::box({2, 4, 6}));
  for (const Vec3& x : {Vec3(0.25, 0.5, 5), Vec3(3, 4, 0.5), Vec3(-3, 4, -7)}) {
    const Vec3 wanted = x.cwiseMin(Vec3(1, 2, 3)).cwiseMax(-Vec3(1, 2, 3));
    const NearestPoint found = nearest_point(*box, x, 0);
    EXPECT_LT((found.point - wanted).norm(), 1e-15);
    EXPECT_NEAR(found.distance, (x - wanted).norm(), 1e-15);
  }
  const NearestPoint within = nearest_point(*box, {0.75, 0.5, 1}, 0);
  EXPECT_LT((within.point - Vec3(1, 0.5, 1)).norm(), 1e-15);
  EXPECT_NEAR(within.distance, 0.25, 1e-15);
}

// Reference: the triangle that is named, in long double. The point lies on it, at that distance.
TEST(PointDistance, the_nearest_point_lies_on_the_triangle_that_is_named) {
  std::mt19937_64 random(1);
  for (const auto& pair : test::body_pairs(23))
    for (int i = 0; i < 40; ++i) {
      const Body& body = *pair.b;
      const Vec3 x = body.mass.com + test::random_in_ball(random, 2 * body.mass.radius);
      const NearestPoint found = nearest_point(body, x, 0);
      const Corners t = corners(surface(body), found.triangle);
      const double rounding = 1e-14 * (extent(body) + x.cwiseAbs().maxCoeff());
      const Vec3& p = found.point;
      EXPECT_LE(test::triangle_distance_bounds({p, p, p}, t).lower, rounding) << pair.name;
      EXPECT_NEAR((x - p).norm(), found.distance, rounding) << pair.name;
      const auto bounds = test::triangle_distance_bounds({x, x, x}, t);
      EXPECT_GE(found.distance, bounds.lower - rounding) << pair.name;
      EXPECT_LE(found.distance, bounds.upper + rounding) << pair.name;
      EXPECT_EQ(point_distance(body, x), found.distance);
    }
}

// Reference: by hand. Of a needle of 1e-9 m, the nearest point is half-way along.
TEST(PointDistance, the_nearest_point_of_a_needle_is_not_its_end) {
  const auto needle = test::body({{{0, 0, 0}, {1, 0, 0}, {0.5, 1e-9, 0}}, {{0, 1, 2}}});
  const NearestPoint found = nearest_point(*needle, {0.25, 0.5, 0.125}, 0);
  EXPECT_LT((found.point - Vec3(0.25, 0, 0)).norm(), 2e-9);
  EXPECT_NEAR(found.distance, std::hypot(0.5, 0.125), 2e-9);
}

}  // namespace
}  // namespace sonde
