// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/queries/inside.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/brute_force.hpp"
#include "tests/support/pairs.hpp"

namespace sonde {
namespace {

/// Closed tubes that run through themselves: points of several winding numbers.
std::vector<std::pair<const char*, std::shared_ptr<const Body>>> closed_bodies() {
  const Vec3 far(1e6, -7e5, 3e5);
  const PolygonSoup fat_knot = test::torus_knot(2, 3, 0.06, 0.03, 0.048, 24, 6);
  return {{"box", test::body(test::box({0.1, 0.2, 0.15}))},
          {"sphere", test::body(test::sphere(0.1, 8, 12))},
          {"torus", test::body(test::torus(0.08, 0.03, 12, 8))},
          {"self-crossing knot", test::body(fat_knot)},
          {"tiny", test::body(test::scaled_and_moved(fat_knot, 1e-6, Vec3::Zero()))},
          {"huge", test::body(test::scaled_and_moved(fat_knot, 1e6, Vec3::Zero()))},
          {"far", test::body(test::scaled_and_moved(fat_knot, 1, far))}};
}

// Reference: the sum of solid angles over all triangles; trusted where it is within 0.01 of a
// whole number, as it must be off the surface.
TEST(Inside, winding_number_is_the_sum_of_solid_angles) {
  std::mt19937_64 random(1);
  for (const auto& [name, body] : closed_bodies()) {
    ASSERT_TRUE(body->solid) << name << body->why;
    int inside_points = 0, many_times = 0;
    for (int i = 0; i < 2000; ++i) {
      const Vec3 x = body->mass.com + test::random_in_ball(random, 1.1 * body->mass.radius);
      const double angles = test::solid_angle_winding(*body, x);
      ASSERT_LT(std::abs(angles - std::round(angles)), 0.01) << name;
      const auto expected = static_cast<int>(std::lround(angles));
      EXPECT_EQ(winding_number(*body, x), expected) << name << i;
      EXPECT_EQ(winds_around(*body, x), expected != 0) << name << i;
      inside_points += expected != 0;
      many_times += std::abs(expected) > 1;
    }
    EXPECT_GT(inside_points, 50) << name;
    if (std::string(name).find("knot") != std::string::npos) {
      EXPECT_GT(many_times, 20) << name;
    }
  }
}

// Points from which every coordinate direction, and every line to a vertex, runs along an edge or
// through a corner.
TEST(Inside, points_in_line_with_corners_and_edges) {
  const auto cube = test::body(test::box({1, 1, 1}));
  for (int i = -3; i <= 3; ++i)
    for (int j = -3; j <= 3; ++j)
      for (int k = -3; k <= 3; ++k) {
        if (std::abs(i) == 2 || std::abs(j) == 2 || std::abs(k) == 2) continue;
        const bool expected = std::abs(i) < 2 && std::abs(j) < 2 && std::abs(k) < 2;
        EXPECT_EQ(winds_around(*cube, 0.25 * Vec3(i, j, k)), expected) << i << j << k;
      }
}

// On a line through a vertex, an edge's middle and a face's centre along every direction: the rays
// the engine shoots are some of them, whatever they are; so points are placed behind the corner as
// seen along the directions of many rays. Reference: solid angles.
TEST(Inside, rays_through_corners_do_not_count_twice) {
  const auto ball = test::body(test::sphere(0.1, 6, 8));
  std::mt19937_64 random(2);
  // The engine's rays have components of four decimals.
  const std::vector<Vec3> rays = {{0.2113, 0.3719, 0.9039},  {-0.4127, 0.2371, 0.8795},
                                  {0.3317, -0.5923, 0.7343}, {-0.1931, -0.4409, -0.8765},
                                  {0.6113, 0.1297, -0.7807}, {-0.5479, 0.6151, -0.5669}};
  for (const Triangle& t : ball->soup.triangles)
    for (const Vec3& ray : rays)
      for (const double back : {0.01, 0.05, 0.3}) {
        const Vec3 corner = ball->soup.vertices[t[0]];
        const Vec3 middle = 0.5 * (corner + ball->soup.vertices[t[1]]);
        for (const Vec3& target : {corner, middle}) {
          const Vec3 x = target - back * ray;
          const double angles = test::solid_angle_winding(*ball, x);
          if (std::abs(angles - std::round(angles)) > 0.01) continue;
          EXPECT_EQ(winding_number(*ball, x), std::lround(angles));
        }
      }
}

// Reference: a corner of each triangle, asked one by one. So many loose triangles are walked by
// their boxes, some of which the surface of the ring cuts through.
TEST(Inside, one_of_many_loose_triangles) {
  std::mt19937_64 random(5);
  const auto ring = test::body(test::torus(0.1, 0.04, 30, 16));
  PolygonSoup crumbs;  // so small that none of them meets the ring
  for (std::size_t i = 0; i < 3000; ++i) {
    const Vec3 at = test::random_in_ball(random, 0.03);
    for (int k = 0; k < 3; ++k) crumbs.points.push_back(at + test::random_in_ball(random, 1e-7));
    crumbs.polygons.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const auto soup = test::body(crumbs);
  ASSERT_EQ(soup->component_triangle.size(), 3000U);
  int in = 0, out = 0;
  for (int i = 0; i < 60; ++i) {
    const Transform at(test::random_pose(random, *soup, *ring, 1.0));
    bool expected = false;
    for (const Triangle& t : soup->soup.triangles)
      expected = expected || winds_around(*ring, at * soup->soup.vertices[t[0]]);
    EXPECT_EQ(component_inside(*soup, *ring, at), expected) << i;
    (expected ? in : out) += 1;
  }
  EXPECT_GT(in, 5);
  EXPECT_GT(out, 5);
}

}  // namespace
}  // namespace sonde
