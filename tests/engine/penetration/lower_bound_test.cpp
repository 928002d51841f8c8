// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/lower_bound.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/proximity/intersect.hpp"
#include "engine/proximity/motion.hpp"
#include "tests/support/brute_force.hpp"
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

// By hand. A point x of both solids, ball of radius e about it in A and of d − e in B, must be
// displaced by d in all; Î = 0.1²/6 about every axis, so μ = r²/Î, and the best x is the highest,
// on the axis: e = d, r = 0.05 − d. The search looks at some points, and may find a worse one.
TEST(LowerBound, a_box_sunk_into_a_face) {
  const auto probe = test::body(test::box({0.1, 0.1, 0.1})), box = test::body(test::box({4, 4, 4}));
  const double d = 0.03;
  const auto bound = depth_lower_bound(*probe, *box, at(0, 0, 2.05 - d));
  ASSERT_TRUE(bound.has_value());
  const double arm = 0.05 - d, best = d / std::sqrt(1 + arm * arm * 600);
  EXPECT_LE(*bound, best);
  EXPECT_GE(*bound, 0.9 * best);
}

// The roles swapped: a point of the fixed body inside a solid probe.
TEST(LowerBound, a_fixed_corner_in_a_solid_probe) {
  const auto probe = test::body(test::box({1, 1, 1}));
  const auto needle = test::body({{{0, 0, 0.3}, {0.001, 0, 2}, {0, 0.001, 2}}, {{0, 1, 2}}});
  const auto bound = depth_lower_bound(*probe, *needle, Pose{});
  ASSERT_TRUE(bound.has_value());
  // The tip is 0.2 deep at r = (0, 0, 0.3), Î = 1/6: μ = 0.09 · 6.
  EXPECT_NEAR(*bound, 0.2 / std::sqrt(1 + 0.54), 1e-6);
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

// Reference: free poses found at random, with exact predicates; each is an upper bound.
TEST(LowerBound, is_never_above_a_free_pose) {
  std::mt19937_64 random(1);
  for (const auto& pair : test::body_pairs(61)) {
    if (!pair.a->solid && !pair.b->solid) continue;
    int compared = 0, positive = 0;
    double closest = 0;
    for (int i = 0; i < 40; ++i) {
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

}  // namespace
}  // namespace sonde
