// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/bound/lower_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/geometry/chart.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "engine/proximity/queries/point_distance.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/half_space.hpp"
#include "tests/support/pairs.hpp"

namespace sonde {
namespace {

Pose at(double x, double y, double z) { return {Quat::Identity(), Vec3(x, y, z)}; }

// By hand: the centre of a ball lies 0.5 − z under the face of a cube, and must come out, whatever
// the turn; so must the whole ball: its depth is 0.5 − z + 0.1. The bound lies between what the
// vertices near the centre give and that.
TEST(LowerBound, a_ball_in_a_box) {
  const auto ball = test::body(test::sphere(0.1, 10, 16)), box = test::body(test::box({1, 1, 1}));
  for (const double z : {0.0, 0.2, 0.35, 0.45, 0.55}) {
    const auto bound = depth_lower_bound(*ball, *box, at(0.01, 0.02, z));
    ASSERT_TRUE(bound.has_value());
    EXPECT_LE(*bound, 0.6 - z);
    // The lowest vertex, as deep as 0.6 − z (or as the other faces are far); μ of r = radius for a
    // full ball is r²/Î = 2.5.
    const double deepest = std::min(0.6 - z, 0.48);
    EXPECT_GE(*bound, 0.95 * deepest / std::sqrt(1 + 2.5)) << z;
  }
}

// By hand: two cubes that overlap by d. A point of the overlap is a deep in the one and d − a in
// the other, seen along the overlap, and no deeper: d in all. The bound is the same with it.
TEST(LowerBound, has_a_witness_as_deep_as_two_cubes_overlap) {
  const auto cube = test::body(test::box({0.1, 0.1, 0.1}));
  for (const double d : {0.002, 0.01, 0.03}) {
    const Pose X_FM = at(0.1 - d, 0.01, -0.005);
    const auto bound = witnessed_lower_bound(*cube, *cube, X_FM);
    ASSERT_TRUE(bound && bound->witness);
    EXPECT_EQ(bound->depth, depth_lower_bound(*cube, *cube, X_FM).value());
    EXPECT_LE(bound->witness->depth, d * (1 + 1e-6));
    EXPECT_GE(bound->witness->depth, 0.9 * d);
    // Outside the one cube it is as much deeper in the other.
    const Vec3& x = bound->witness->at;
    ASSERT_GE(x.x(), 0.05 - d) << "inside the probe";
    const double b = point_distance(*cube, x);
    EXPECT_NEAR(point_distance(*cube, inverse(X_FM) * x) + (x.x() > 0.05 ? -b : b),
                bound->witness->depth, 1e-6);
  }
  EXPECT_FALSE(witnessed_lower_bound(*cube, *cube, at(0.2, 0, 0))->witness);
}

// By hand, from below. A point x of both solids, ball of radius e about it in A and of d − e in B,
// must be displaced by d in all; Î = 0.1²/6 about every axis, so μ = r²/Î, and the best x is the
// highest, on the axis: e = d, r = 0.05 − d. From above: the search over rotations against a
// half-space, which the face is to the small box.
TEST(LowerBound, a_box_sunk_into_a_face) {
  const auto probe = test::body(test::box({0.1, 0.1, 0.1})), box = test::body(test::box({4, 4, 4}));
  const double d = 0.03;
  const auto bound = depth_lower_bound(*probe, *box, at(0, 0, 2.05 - d));
  ASSERT_TRUE(bound.has_value());
  const double arm = 0.05 - d, best = d / std::sqrt(1 + arm * arm * 600);
  EXPECT_LE(*bound, test::half_space_depth(*probe, at(0, 0, 2.05 - d), 2, 1));
  EXPECT_GE(*bound, 0.9 * best);
}

// By hand: the centres of two balls must come as far apart as the radii together, whatever the
// turn. The meshes lie between the balls in them and the balls about them.
TEST(LowerBound, two_balls) {
  const auto probe = test::body(test::sphere(0.1, 16, 24)),
             fixed = test::body(test::sphere(0.15, 20, 30));
  for (const double depth : {0.003, 0.03, 0.1, 0.2}) {
    const double bound = depth_lower_bound(*probe, *fixed, at(0, 0, 0.25 - depth)).value();
    EXPECT_LE(bound, depth) << depth;
    EXPECT_GE(bound, 0.8 * (depth - 2e-3)) << depth;  // what the meshes lack of the balls
  }
}

// Reference: a search over rotations against a half-space, an upper bound of the truth.
TEST(LowerBound, solids_sunk_into_a_half_space) {
  std::mt19937_64 random(3);
  const auto ground = test::body(test::box({4, 4, 4}));
  PolygonSoup wedge = test::tetrahedron(0.1);
  wedge.points[0] += Vec3(0.1, 0.03, -0.02);
  std::vector<double> ratios;
  for (const auto& probe : {test::body(test::box({0.05, 0.1, 0.15})), test::body(wedge),
                            test::body(test::torus(0.08, 0.02, 16, 8)),
                            test::body(test::torus_knot(2, 3, 0.06, 0.025, 0.012, 40, 6))})
    for (const double fraction : {0.02, 0.2, 0.6}) {
      const Quat q = test::random_rotation(random);
      double lowest = 0;
      for (const Vec3& v : probe->soup.vertices) lowest = std::min(lowest, (q * v).z());
      const Pose O{q, Vec3(0, 0, 2 - lowest - fraction * probe->mass.radius)};
      const double reference = test::half_space_depth(*probe, O, 2, 1);
      ratios.push_back(depth_lower_bound(*probe, *ground, O).value() / reference);
      EXPECT_LE(ratios.back(), 1) << fraction;
      EXPECT_GT(ratios.back(), 0.3) << fraction;
    }
  std::sort(ratios.begin(), ratios.end());
  EXPECT_GT(ratios[ratios.size() / 2], 0.7);
}

// The roles swapped: a point of the fixed body inside a solid probe.
TEST(LowerBound, a_fixed_corner_in_a_solid_probe) {
  const auto probe = test::body(test::box({1, 1, 1}));
  const auto needle = test::body({{{0, 0, 0.3}, {0.001, 0, 2}, {0, 0.001, 2}}, {{0, 1, 2}}});
  const auto bound = depth_lower_bound(*probe, *needle, Pose{});
  ASSERT_TRUE(bound.has_value());
  // The tip is 0.2 deep at r = (0, 0, 0.3), Î = 1/6: μ = 0.09 · 6. And 0.2 is a way out.
  EXPECT_GE(*bound, 0.2 / std::sqrt(1 + 0.54) * (1 - 1e-6));
  EXPECT_LE(*bound, 0.2);
}

TEST(LowerBound, none_for_surfaces_and_zero_where_nothing_is_inside) {
  const auto sheet = test::body({{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  const auto box = test::body(test::box({1, 1, 1}));
  EXPECT_FALSE(depth_lower_bound(*sheet, *sheet, Pose{}).has_value());
  EXPECT_EQ(depth_lower_bound(*box, *sheet, at(0, 0, 5)).value(), 0);
  EXPECT_EQ(depth_lower_bound(*sheet, *box, at(0, 0, 5)).value(), 0);
  EXPECT_EQ(depth_lower_bound(*box, *box, at(1, 0, 0)).value(), 0);  // touching
}

// A probe on a line can turn about it for nothing: points on the line still count, at the price of
// the other turns alone.
TEST(LowerBound, a_line_like_probe) {
  const auto needle = test::body({{{-0.1, 0, 0}, {0.1, 0, 0}, {0.1, 1e-10, 0}}, {{0, 1, 2}}});
  const auto box = test::body(test::box({1, 1, 1}));
  ASSERT_EQ(needle->mass.inertia[0], 0);
  const auto bound = depth_lower_bound(*needle, *box, at(0, 0, 0.4));
  ASSERT_TRUE(bound.has_value());
  EXPECT_LE(*bound, 0.1);
  EXPECT_GE(*bound, 0);
}

/// Poses of two tori, and what is said of them.
struct Tori {
  std::shared_ptr<const Body> probe = test::body(test::torus(0.08, 0.03, 24, 12));
  std::shared_ptr<const Body> fixed = test::body(test::torus(0.07, 0.02, 20, 10));
  std::vector<Pose> poses;
  Tori() {
    std::mt19937_64 random(7);
    while (poses.size() < 8) {
      const Pose O = test::random_pose(random, *probe, *fixed, 0.6);
      if (overlap(*probe, *fixed, Transform(O), Doubt::exact)) poses.push_back(O);
    }
  }
};

TEST(LowerBound, the_same_bits_again_and_no_less_for_more_work) {
  const Tori tori;
  for (const Pose& O : tori.poses) {
    double last = 0;
    for (const int work : {0, 4000, 8000, 30000}) {
      const auto bound = depth_lower_bound(*tori.probe, *tori.fixed, O, {}, {.work = work});
      EXPECT_EQ(bound, depth_lower_bound(*tori.probe, *tori.fixed, O, {}, {.work = work}));
      EXPECT_GE(*bound, last);
      last = *bound;
    }
    EXPECT_GT(last, 0);
  }
}

TEST(LowerBound, scales_exactly_by_powers_of_two) {
  const Tori tori;
  for (const double scale : {0x1p-10, 0x1p7}) {
    PolygonSoup probe = test::torus(0.08, 0.03, 24, 12), fixed = test::torus(0.07, 0.02, 20, 10);
    for (Vec3& p : probe.points) p *= scale;
    for (Vec3& p : fixed.points) p *= scale;
    const auto a = test::body(probe), b = test::body(fixed);
    for (const Pose& O : tori.poses)
      EXPECT_EQ(*depth_lower_bound(*a, *b, {O.q, scale * O.p}),
                scale * *depth_lower_bound(*tori.probe, *tori.fixed, O));
  }
}

// Or this would take hours: the work asked for is too much, but the time is up.
TEST(LowerBound, ends_at_the_deadline) {
  const Tori tori;
  const Deadline passed{.microseconds = 1, .started = now_us() - 1e6};
  for (const Pose& O : tori.poses) {
    const auto bound =
        depth_lower_bound(*tori.probe, *tori.fixed, O, passed, {.work = 2'000'000'000});
    EXPECT_EQ(bound, depth_lower_bound(*tori.probe, *tori.fixed, O, passed, {.work = 0}));
    EXPECT_LE(*bound, *depth_lower_bound(*tori.probe, *tori.fixed, O));
  }
}

// Reference: free poses found at random, with exact predicates; each is an upper bound.
void compare_with_free_poses(std::uint64_t seed, int poses) {
  std::mt19937_64 random(seed);
  for (const auto& pair : test::body_pairs(60 + seed)) {
    if (!pair.a->solid && !pair.b->solid) continue;
    int compared = 0, positive = 0;
    double closest = 0;
    for (int i = 0; i < poses; ++i) {
      const Pose O = test::random_pose(random, *pair.a, *pair.b, 0.7);
      if (!overlap(*pair.a, *pair.b, Transform(O), Doubt::exact)) continue;
      const double bound = depth_lower_bound(*pair.a, *pair.b, O).value();
      EXPECT_GE(bound, 0);
      positive += bound > 0;
      const Chart chart(pair.a->mass, O);
      for (int k = 0; k < 100; ++k) {
        Vec6 y;
        for (int m = 0; m < 6; ++m) y[m] = test::uniform(random, -1, 1);
        y *= test::uniform(random, 0.01, 0.6) * pair.a->mass.radius / y.norm();
        if (chart.v(y).norm() > 0.99) continue;
        if (overlap(*pair.a, *pair.b, Transform(chart.pose(y)), Doubt::exact)) continue;
        EXPECT_LE(bound, y.norm()) << pair.name;
        closest = std::max(closest, bound / y.norm());
        ++compared;
      }
    }
    EXPECT_GT(compared, 50) << pair.name;
    EXPECT_GT(positive, 3) << pair.name;
    EXPECT_GT(closest, 0.2) << pair.name;  // else the comparison would show little
  }
}

TEST(LowerBound, is_never_above_a_free_pose) { compare_with_free_poses(1, 40); }
TEST(LowerBound, Full_is_never_above_a_free_pose_of_many) {
  for (std::uint64_t seed = 2; seed < 8; ++seed) compare_with_free_poses(seed, 150);
}

}  // namespace
}  // namespace sonde
