// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/bound/deep_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/penetration/bound/bound_tuning.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/pairs.hpp"

namespace sonde {
namespace {

constexpr int usual_work = 20'000;

double deepest_of(const std::vector<CommonPoint>& points) {
  double deepest = 0;
  for (const CommonPoint& p : points) deepest = std::max(deepest, p.depth());
  return deepest;
}

/// Of a point in the mesh frame, by all triangles and by the sum of solid angles.
double brute_depth(const Body& body, const Vec3& x) {
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < body.soup.triangles.size(); ++i)
    least = std::min(least, closest_points({x, x, x}, corners(body.soup, i)).distance);
  return body.solid && std::abs(test::solid_angle_winding(body, x)) > 0.5 ? least : -least;
}

// Reference: every triangle, and solid angles.
TEST(DeepPoints, are_no_deeper_than_all_triangles_say_and_few) {
  std::mt19937_64 random(11);
  int pairs_with_points = 0;
  for (const auto& pair : test::body_pairs(72))
    for (int i = 0; i < 8; ++i) {
      const Pose O = test::random_pose(random, *pair.a, *pair.b, 0.3);
      const CommonDepth depth(*pair.a, *pair.b, O);
      const std::vector<CommonPoint> points = deep_points(depth, usual_work, {});
      // Those kept, each risen further once, and each of these as often inwards.
      EXPECT_LE(points.size(), bound_tuning.most_points * (2 + std::size(bound_tuning.inwards)));
      pairs_with_points += !points.empty();
      for (const CommonPoint& p : points) {
        EXPECT_GT(p.depth(), 0) << pair.name;
        EXPECT_EQ(p.r, p.x) << pair.name;  // the probe is not turned
        EXPECT_LE(p.a, brute_depth(*pair.a, depth.X_MW() * p.r)) << pair.name;
        EXPECT_LE(p.b, brute_depth(*pair.b, depth.X_FW() * p.x)) << pair.name;
      }
      if (!pair.a->solid && !pair.b->solid) {
        EXPECT_TRUE(points.empty()) << pair.name;
      }
    }
  EXPECT_GT(pairs_with_points, 20);
}

// Reference: a closed form. Both depths of a cube about the middle of a larger one are greatest
// there, where they add up to both half sides; out of the middle by less than the difference of
// these, still at the middle of the small one, whose depth falls as fast as the other rises.
TEST(DeepPoints, of_a_cube_in_a_cube_is_its_middle) {
  const auto small = test::body(test::box({0.2, 0.2, 0.2}));
  const auto large = test::body(test::box({1, 1, 1}));
  for (const double off : {0.0, 0.05, 0.3}) {
    const CommonDepth depth(*small, *large, {Quat::Identity(), Vec3(off, 0.02, 0.01)});
    const double most = 0.1 + 0.5 - std::max(off, 0.02);
    const double found = deepest_of(deep_points(depth, usual_work, {}));
    EXPECT_LE(found, most);
    EXPECT_GT(found, 0.97 * most) << off;
    // The other way round the same overlap is as deep.
    const CommonDepth swapped(*large, *small, {Quat::Identity(), Vec3(-off, -0.02, -0.01)});
    EXPECT_GT(deepest_of(deep_points(swapped, usual_work, {})), 0.97 * most) << off;
  }
}

// Reference: a closed form. On a sheet through the middle of a cube, the middle is as deep as half
// its side. None of the sheet's corners is in the cube.
TEST(DeepPoints, of_a_sheet_through_a_cube_lie_on_the_sheet) {
  const PolygonSoup square{{{-3, -3.1, 0}, {3, -2.9, 0}, {3.2, 3, 0}, {-3, 3, 0}}, {{0, 1, 2, 3}}};
  const auto sheet = test::body(square);
  const auto cube = test::body(test::box({1, 1, 1}));
  ASSERT_FALSE(sheet->solid);
  for (const bool sheet_moves : {true, false}) {
    const Body& probe = sheet_moves ? *sheet : *cube;
    const Body& fixed = sheet_moves ? *cube : *sheet;
    const CommonDepth depth(probe, fixed, {Quat::Identity(), Vec3(0.1, 0.07, 0.01)});
    const double found = deepest_of(deep_points(depth, usual_work, {}));
    EXPECT_LE(found, 0.49);
    EXPECT_GT(found, 0.9 * 0.49) << sheet_moves;
  }
}

// Reference: a closed form. A bar goes through two blocks of different size: at the middle of each
// it is as deep as half its thickness and half the block's side.
TEST(DeepPoints, lie_in_each_of_two_overlaps) {
  const auto bar = test::body(test::box({4, 0.1, 0.1}));
  PolygonSoup blocks = test::box({0.4, 0.4, 0.4});
  const PolygonSoup other = test::scaled_and_moved(test::box({1, 1, 1}), 0.5, {1.5, 0, 0});
  for (const auto& polygon : other.polygons) {
    blocks.polygons.push_back(polygon);
    for (std::size_t& corner : blocks.polygons.back()) corner += blocks.points.size();
  }
  blocks.points.insert(blocks.points.end(), other.points.begin(), other.points.end());
  const auto fixed = test::body(blocks);
  const CommonDepth depth(*bar, *fixed, {Quat::Identity(), Vec3(0.7, 0, 0)});
  double at_first = 0, at_second = 0;
  for (const CommonPoint& p : deep_points(depth, usual_work, {})) {
    const double x = (depth.X_FW() * p.x).x();
    double& deepest = x < 0.7 ? at_first : at_second;
    deepest = std::max(deepest, p.depth());
  }
  EXPECT_LE(at_first, 0.25);
  EXPECT_GT(at_first, 0.9 * 0.25);
  EXPECT_LE(at_second, 0.3);
  EXPECT_GT(at_second, 0.9 * 0.3);
}

// Reference: a closed form. Across a layer in which two blocks overlap, the two depths add up to
// its thickness.
TEST(DeepPoints, none_are_there_where_bodies_are_apart_and_some_where_they_hardly_meet) {
  const auto cube = test::body(test::box({1, 1, 1}));
  for (const double gap : {1e-3, -1e-5}) {
    const CommonDepth depth(*cube, *cube, {Quat::Identity(), Vec3(0.1, 0.2, 1 + gap)});
    const std::vector<CommonPoint> points = deep_points(depth, usual_work, {});
    EXPECT_EQ(points.empty(), gap > 0);
    if (points.empty()) continue;
    EXPECT_LE(deepest_of(points), -gap);  // the sum of what either side of the layer is deep
    EXPECT_GT(deepest_of(points), -0.5 * gap);
  }
}

}  // namespace
}  // namespace sonde
