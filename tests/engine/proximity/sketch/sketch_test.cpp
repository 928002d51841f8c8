// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/sketch/sketch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "engine/proximity/queries/point_distance.hpp"
#include "tests/support/pairs.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

// Reference: the triangles themselves.
TEST(Sketch, points_lie_on_the_surface_and_leave_no_part_of_it_out) {
  std::mt19937_64 random(1);
  for (const PolygonSoup& soup :
       {test::box({0.1, 0.2, 0.15}), test::torus(0.08, 0.03, 40, 30), test::sphere(0.1, 40, 60)}) {
    const auto body = test::body(soup);
    const std::vector<Vec3> points = spread_points(*body, 200);
    ASSERT_EQ(points.size(), 200U);
    for (const Vec3& x : points) EXPECT_LT(point_distance(*body, x), 1e-12);
    for (int i = 0; i < 500; ++i) {
      const Vec3 near = body->mass.com + test::random_in_ball(random, body->mass.radius);
      const Vec3 x = nearest_point(*body, near, 0).point;
      const double away =
          (*std::ranges::min_element(points, {}, [&](const Vec3& p) { return (p - x).norm(); }) - x)
              .norm();
      EXPECT_LT(away, 0.35 * body->mass.radius);
    }
  }
}

TEST(Sketch, groups_hold_their_points) {
  const auto body = test::body(test::torus_knot(2, 3, 0.06, 0.025, 0.015, 30, 8));
  const auto sketch = make_sketch(*body);
  ASSERT_TRUE(sketch);
  std::size_t points = 0;
  for (const PointGroup& group : sketch->more)
    for (const Quad& x : group.points) {
      EXPECT_LE((vec3(x) - vec3(group.center)).norm(), group.radius * (1 + 1e-6) + 1e-7);
      // Of the surface, in principal axes.
      const Vec3 in_mesh = body->mass.R_MP * vec3(x) + body->mass.com;
      EXPECT_LT(point_distance(*body, in_mesh), 1e-7);
      ++points;
    }
  EXPECT_GT(points, 100U);
}

// A surface keeps out of a solid by its points, and lets any point of the other through.
TEST(Sketch, of_a_surface_is_its_points) {
  std::mt19937_64 random(2);
  const auto soup = test::body(test::random_soup(random, 30, 0.1));
  const auto cube = test::body(test::box({0.1, 0.1, 0.1}));
  const auto sketch = make_sketch(*soup);
  std::size_t points = 0;
  for (const PointGroup& group : sketch->more) {
    for (const Quad& x : group.points)
      EXPECT_LT(point_distance(*soup, soup->mass.R_MP * vec3(x) + soup->mass.com), 1e-7);
    points += group.points.size();
  }
  EXPECT_GE(points, 90U);  // all corners
  EXPECT_EQ(sketch->field.at_least(quad(Vec3::Zero())), std::numeric_limits<float>::infinity());
  EXPECT_TRUE(make_sketches(*soup, *cube));
  EXPECT_TRUE(make_sketches(*cube, *soup));
  EXPECT_TRUE(make_sketches(*cube, *cube));
  EXPECT_FALSE(make_sketches(*soup, *soup));
}

}  // namespace
}  // namespace sonde
