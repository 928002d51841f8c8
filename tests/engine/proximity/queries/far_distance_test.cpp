// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/queries/far_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/triangles/triangle_pair.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/pairs.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

double least_of_all_pairs(const Body& a, const Body& b, const Transform& X) {
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < surface(a).triangles.size(); ++i) {
    const Corners at = place(X, corners(surface(a), i));
    for (std::uint32_t j = 0; j < surface(b).triangles.size(); ++j)
      least = std::min(least, closest_points(at, corners(surface(b), j)).distance);
  }
  return least;
}

Vec3 direction(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random), z = normal(random);
  return Vec3(x, y, z).normalized();
}

// Reference: every pair of triangles.
TEST(FarDistance, is_the_least_of_all_pairs_of_triangles_and_its_points_have_it) {
  std::mt19937_64 random(5);
  const std::vector<PolygonSoup> shapes{
      test::box({0.1, 0.2, 0.3}), test::icosphere(0.2, 2), test::torus(5, 1.2, 20, 10),
      test::torus_knot(2, 3, 0.1, 0.04, 0.03, 30, 6), test::box({40, 1e-3, 7})};
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    const auto a = test::body(shapes[s]), b = test::body(shapes[(s + 2) % shapes.size()]);
    const double size = (a->tree.high - a->tree.low).norm() + (b->tree.high - b->tree.low).norm();
    for (const double far : {1e3, 3e4, 1e7, 1e12, 1e20})
      for (const bool turned : {false, true}) {
        // Not turned, faces are square to the way.
        const Vec3 way = turned ? direction(random) : Vec3::UnitX().eval();
        const Mat3 R =
            turned ? Quat::FromTwoVectors(Vec3::UnitX(), direction(random)).toRotationMatrix()
                   : Mat3::Identity().eval();
        const Transform X(R, 1.5 * far * size * way);
        const auto found = far_distance(*a, *b, X);
        ASSERT_TRUE(found) << far;
        const double least = least_of_all_pairs(*a, *b, X), promised = 1e-14 * X.p.norm();
        EXPECT_NEAR(found->distance, least, promised) << s << " " << far;
        EXPECT_NEAR((found->on_a - found->on_b).norm(), found->distance, promised);
        EXPECT_EQ(triangle_distance(*a, *b, X).distance, found->distance);
      }
    EXPECT_FALSE(far_distance(*a, *b, Transform(Mat3::Identity(), 280 * size * Vec3::UnitX())));
  }
}

// Reference: every pair of triangles. Two grids that are nearly flat face each other: of so many
// triangles there is no room for all that come equally far.
TEST(FarDistance, of_grids_that_face_each_other_is_the_least_of_all_pairs) {
  PolygonSoup grid;
  constexpr std::size_t n = 24;
  for (std::size_t i = 0; i <= n; ++i)
    for (std::size_t j = 0; j <= n; ++j)
      grid.points.emplace_back(1e-5 * double((7 * i * i + 5 * j * j + 3 * i * j) % 11),
                               double(i) / n, double(j) / n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const std::size_t at = i * (n + 1) + j;
      grid.polygons.push_back({at, at + 1, at + n + 2});
      grid.polygons.push_back({at, at + n + 2, at + n + 1});
    }
  const auto sheet = test::body(grid);
  ASSERT_GT(surface(*sheet).triangles.size(), 1100u);
  for (const double aside : {0.3, 2.5}) {
    const Transform X(Mat3::Identity(), Vec3(1e3, aside, 0));
    const auto found = far_distance(*sheet, *sheet, X);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->distance, least_of_all_pairs(*sheet, *sheet, X), 1e-14 * 1e3);
  }
}

}  // namespace
}  // namespace sonde
