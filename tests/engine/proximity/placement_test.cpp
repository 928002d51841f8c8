// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/placement.hpp"

#include <gtest/gtest.h>

#include "engine/proximity/distance.hpp"
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
    at.open_near(p, at.above(distance), found);
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

}  // namespace
}  // namespace sonde
