// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/queries/placement.hpp"

#include <gtest/gtest.h>

#include "engine/proximity/queries/distance.hpp"
#include "engine/proximity/queries/inside.hpp"
#include "engine/proximity/queries/point_distance.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

/// Pairs of triangles whose boxes are within the distance of the bodies.
int pairs_left(const Body& a, const Body& b, const Transform& X) {
  const double distance = triangle_distance(a, b, X).distance;
  const Placement at(a, b, X);
  PairStack<SlotPair> stack;
  SlotPairs found;
  int left = 0;
  for (stack.push(at.roots()); !stack.empty();) {
    const SlotPair p = stack.pop();
    if (at.is_leaf(p)) {
      ++left;
      continue;
    }
    at.open_near(p, at.to_unit_rounded_up(distance), found);
    for (const SlotPair& q : found) stack.push(q);
  }
  return left;
}

PolygonSoup with_far_triangle(PolygonSoup soup, double away) {
  const std::size_t first = soup.points.size();
  for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)})
    soup.points.push_back(corner + Vec3(away, -0.5 * away, 0.25 * away));
  soup.polygons.push_back({first, first + 1, first + 2});
  return soup;
}

// Reference: the same bodies without what is far away. (A guard for rounding that went with the
// size of all would be three times the gap, and leave thousands.)
TEST(Placement, what_is_far_away_costs_boxes_nearby_no_precision) {
  const PolygonSoup near = test::sphere(1, 60, 120), far = with_far_triangle(near, 4096);
  const auto body = test::body(near), large = test::body(far);
  const Transform X(Pose{Quat(Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized())), {2.01, 0, 0}});
  const int left = pairs_left(*body, *body, X);
  EXPECT_GE(left, 1);
  EXPECT_LE(pairs_left(*body, *large, X), 2 * left + 10);
  EXPECT_LE(pairs_left(*large, *body, X), 2 * left + 10);
}

PolygonSoup joined(PolygonSoup a, const PolygonSoup& b, const Vec3& by) {
  const std::size_t first = a.points.size();
  for (const Vec3& x : b.points) a.points.push_back(x + by);
  for (std::vector<std::size_t> polygon : b.polygons) {
    for (std::size_t& i : polygon) i += first;
    a.polygons.push_back(polygon);
  }
  return a;
}

/// The least distance of all pairs of triangles.
double least_distance(const Body& a, const Body& b, const Transform& X) {
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < a.soup.triangles.size(); ++i)
    for (std::uint32_t j = 0; j < b.soup.triangles.size(); ++j)
      least = std::min(least,
                       closest_points(place(X, corners(a.soup, i)), corners(b.soup, j)).distance);
  return least;
}

// Reference: all triangles, in double precision. What single precision rounds off a coordinate of 1
// is larger than the smallest of these features: it must be kept beside it.
TEST(Placement, small_features_far_from_the_middle_lose_nothing) {
  std::mt19937_64 random(1);
  for (const double size : {1e-3, 1e-5, 1e-6, 1e-7, 1e-8})
    for (int i = 0; i < 12; ++i) {
      const Vec3 at = test::random_in_ball(random, 0.4) + Vec3(1.2, 0.1, 0.3);
      const auto body =
          test::body(joined(test::box({1, 1, 1}), test::sphere(size / 2, 12, 16), at));
      ASSERT_TRUE(body->solid);
      for (int k = 0; k < 10; ++k) {
        const Vec3 x = at + test::random_in_ball(random, 0.45 * size);
        EXPECT_TRUE(winds_around(*body, x)) << size;
        double least = std::numeric_limits<double>::infinity();
        for (std::uint32_t t = 0; t < body->soup.triangles.size(); ++t)
          least = std::min(least, closest_points({x, x, x}, corners(body->soup, t)).distance);
        EXPECT_LE(point_distance(*body, x), least * (1 + 1e-9) + 1e-15) << size;
      }
      const auto probe = test::body(test::sphere(size / 2, 6, 8));
      const Transform X(Pose{test::random_rotation(random),
                             at + 1.05 * size * test::random_in_ball(random, 1).normalized()});
      EXPECT_LE(triangle_distance(*probe, *body, X).distance,
                least_distance(*probe, *body, X) * (1 + 1e-9) + 1e-15)
          << size;
    }
}

TEST(Placement, a_point_is_kept_whole) {
  std::mt19937_64 random(2);
  const auto body = test::body(test::box({1, 2, 3}));
  for (int i = 0; i < 1000; ++i) {
    const Vec3 x = test::random_in_ball(random, 5);
    const PointFrame frame(*body, x);
    for (int k = 0; k < 3; ++k) {
      const double kept =
          static_cast<double>(frame.point.origin[k]) + static_cast<double>(frame.point.rest[k]);
      EXPECT_NEAR(kept, (x - body->tree.origin)[k] * frame.per_unit, 1e-13);
    }
  }
}

// Reference: two boxes with sides 2 a along the axes, by hand. The balls about them have the radius
// a √3, and where their gap is no more than rounding they do not count as apart.
TEST(Placement, balls_are_apart_where_the_sum_of_radii_is_passed) {
  for (const double a : {1e-9, 1.0, 1e9})
    for (const double away : {0.0, 10.0, 1e6}) {
      PolygonSoup box = test::box({2 * a, 2 * a, 2 * a});
      for (Vec3& x : box.points) x += a * Vec3(away, -away, 0);
      const auto body = test::body(box);
      for (const Vec3& along : {Vec3(1, 0, 0), Vec3(Vec3(1, -2, 3).normalized())}) {
        const auto at = [&](double gaps) {
          return Transform(Pose{Quat::Identity(), 2 * std::sqrt(3.0) * a * gaps * along});
        };
        EXPECT_FALSE(balls_are_apart(*body, *body, at(0))) << a << ", " << away;
        EXPECT_FALSE(balls_are_apart(*body, *body, at(1))) << a << ", " << away;
        EXPECT_TRUE(balls_are_apart(*body, *body, at(1 + 1e-6))) << a << ", " << away;
      }
    }
}

}  // namespace
}  // namespace sonde
