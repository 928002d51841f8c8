// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/bound/witness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/penetration/bound/deep_points.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/triangles/triangle_pair.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/pairs.hpp"

namespace sonde {
namespace {

/// Depth of a point by all triangles and by the sum of solid angles.
double depth_of(const Body& body, const Vec3& x) {
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < body.soup.triangles.size(); ++i)
    least = std::min(least, closest_points({x, x, x}, corners(body.soup, i)).distance);
  const bool in = body.solid && std::abs(test::solid_angle_winding(body, x)) > 0.5;
  return in ? least : -least;
}

double size_of(const Body& a, const Body& b, const Pose& X) {
  return extent(a) + extent(b) + X.p.cwiseAbs().maxCoeff();
}

// Reference: every triangle, and solid angles.
TEST(CommonDepth, is_the_distance_from_the_triangles_with_the_side_as_its_sign) {
  std::mt19937_64 random(1);
  for (const auto& pair : test::body_pairs(71)) {
    const Pose O = test::random_pose(random, *pair.a, *pair.b, 0.5);
    const CommonDepth depth(*pair.a, *pair.b, O);
    const double guard = 1e-12 * size_of(*pair.a, *pair.b, O), R = pair.a->mass.radius;
    for (int i = 0; i < 100; ++i) {
      const Mat3 turn = test::random_rotation(random).toRotationMatrix();
      const Vec3 x = test::random_in_ball(random, R);
      const CommonPoint s = depth.at(turn, x);
      EXPECT_LT((turn * s.r - x).norm(), 1e-14 * R);
      const double a = depth_of(*pair.a, depth.X_MW() * s.r);
      const double b = depth_of(*pair.b, depth.X_FW() * x);
      EXPECT_LE(s.a, a) << pair.name;
      EXPECT_GE(s.a, a - guard) << pair.name;
      EXPECT_LE(s.b, b) << pair.name;
      EXPECT_GE(s.b, b - guard) << pair.name;
      // From a neighbour: the same bits, whatever it saved.
      const Vec3 near = x + test::random_in_ball(random, 0.1 * R);
      const CommonPoint fresh = depth.at(turn, near), known = depth.at(turn, near, s);
      EXPECT_EQ(fresh.a, known.a) << pair.name;
      EXPECT_EQ(fresh.b, known.b) << pair.name;
    }
  }
}

TEST(CommonDepth, grows_uphill_and_ascents_never_fall) {
  std::mt19937_64 random(2);
  const auto torus = test::body(test::torus(0.08, 0.03, 20, 12));
  const CommonDepth depth(*torus, *torus, {test::random_rotation(random), Vec3(0.03, 0, 0.02)});
  int risen = 0, starts = 0;
  for (int i = 0; i < 100; ++i) {
    const Mat3 turn = test::random_rotation(random).toRotationMatrix();
    const CommonPoint s = depth.at(turn, test::random_in_ball(random, 0.1));
    const Vec3 a_little = 1e-7 * s.up_a, b_little = 1e-7 * s.up_b;
    EXPECT_NEAR(depth.at(turn, s.x + a_little).a - s.a, 1e-7, 1e-10);
    EXPECT_NEAR(depth.at(turn, s.x + b_little).b - s.b, 1e-7, 1e-10);
    const CommonPoint top = depth.ascend(turn, s, 0.01, 20);
    EXPECT_GE(top.depth(), s.depth());
    ++starts, risen += top.depth() > s.depth() + 0.01;
  }
  EXPECT_GT(risen, starts / 2);
}

// Moving both bodies together changes nothing at a point of them.
TEST(CommonDepth, is_the_same_wherever_both_bodies_are) {
  std::mt19937_64 random(3);
  PolygonSoup soup = test::torus(0.08, 0.03, 20, 12);
  const auto probe = test::body(test::box({0.05, 0.08, 0.1})), fixed = test::body(soup);
  for (int i = 0; i < 20; ++i) {
    const Pose O{test::random_rotation(random), test::random_in_ball(random, 0.1)};
    const Pose moved{test::random_rotation(random), test::random_in_ball(random, 1)};
    PolygonSoup there = soup;
    for (Vec3& p : there.points) p = moved * p;
    const auto elsewhere = test::body(there);
    const Vec3 x = test::random_in_ball(random, 0.08);
    const Mat3 still = Mat3::Identity();
    const double here = CommonDepth(*probe, *fixed, O).at(still, x).depth();
    const double away = CommonDepth(*probe, *elsewhere, moved * O).at(still, x).depth();
    EXPECT_NEAR(away, here, 1e-9 * std::abs(here) + 1e-13);
  }
}

// By hand: two square bars, an edge of the one across an edge of the other, d deep. On the way
// between the edges a point is as deep in both together as d/√2, and nowhere deeper. No corner of
// either is near.
TEST(DeepPoints, are_found_where_only_edges_cross) {
  const auto bar = test::body(test::box({1, 0.1, 0.1}));
  const Quat on_edge(Eigen::AngleAxisd(std::acos(-1.0) / 4, Vec3::UnitX()));
  PolygonSoup turned = test::box({1, 0.1, 0.1});
  for (Vec3& p : turned.points) p = on_edge * p;
  const auto fixed = test::body(turned);
  const Quat across(Eigen::AngleAxisd(std::acos(0.0), Vec3::UnitZ()));
  for (const double d : {0.05, 1e-3, 1e-6}) {
    const Pose O{across * on_edge, Vec3(0.013, 0.021, 0.1 * std::sqrt(2.0) - d)};
    const CommonDepth depth(*bar, *fixed, O);
    double deepest = 0;
    for (const CommonPoint& s : deep_points(depth, 20'000, {}))
      deepest = std::max(deepest, s.depth());
    EXPECT_LE(deepest, d / std::sqrt(2.0));
    EXPECT_GE(deepest, 0.6 * d / std::sqrt(2.0)) << d;
  }
}

}  // namespace
}  // namespace sonde
