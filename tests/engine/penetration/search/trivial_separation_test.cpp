// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/trivial_separation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/pairs.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

TEST(WithoutSearch, nothing_is_said_where_bodies_overlap) {
  const auto cube = test::body(test::box({1, 1, 1}));
  Pose X;
  for (const double x : {0.0, 0.5, 1.0}) {  // the last one touches
    X.p.x() = x;
    EXPECT_FALSE(trivial_separation(*cube, *cube, X)) << x;
  }
  X.p.x() = 1.001;
  const auto beside = trivial_separation(*cube, *cube, X);
  ASSERT_TRUE(beside);
  EXPECT_EQ(beside->status, Status::separated);
  EXPECT_EQ(beside->separated.p, X.p);
  EXPECT_EQ(beside->depth, 0);
}

TEST(WithoutSearch, what_is_not_finite_is_refused) {
  const auto cube = test::body(test::box({1, 1, 1}));
  Pose bad;
  bad.p.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(trivial_separation(*cube, *cube, bad).value().status, Status::failed);
  bad = {};
  bad.q.w() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(trivial_separation(*cube, *cube, bad).value().status, Status::failed);
  bad.q.coeffs().setZero();
  EXPECT_EQ(trivial_separation(*cube, *cube, bad).value().status, Status::failed);
}

// Reference: the bodies themselves. Where coordinates are rounded by more than a body is large,
// only what is plain can be said.
TEST(WithoutSearch, far_poses_are_separated_or_refused) {
  const auto cube = test::body(test::box({1, 1, 1}));
  Pose away;
  for (const double distance : {1e9, 1e13, 1e100, 1e300}) {
    away.p = Vec3(distance, -distance, 0.5 * distance);
    EXPECT_EQ(trivial_separation(*cube, *cube, away).value().status, Status::separated) << distance;
  }
  const auto far = test::body(test::scaled_and_moved(test::box({1, 1, 1}), 1, Vec3(1e14, 0, 0)));
  away.p = Vec3(1e14, 0, 0);
  const Separation refused = trivial_separation(*cube, *far, away).value();
  EXPECT_EQ(refused.status, Status::failed);
  EXPECT_STRNE(refused.reason, "");
}

// Reference: by hand, 64 ε (extents + largest coordinate) against 1 % of half the cube's diagonal.
TEST(WithoutSearch, coordinates_are_rough_where_they_are_rounded_by_a_hundredth_of_the_probe) {
  const auto cube = test::body(test::box({1, 1, 1})), block = test::body(test::box({6, 6, 6}));
  const double limit = 0.01 * std::sqrt(0.75) / (64 * 0x1p-52) - 0.5 - 3;
  for (const double sign : {-1, 1}) {
    EXPECT_FALSE(is_rough(*cube, *block, Vec3(0, 0.999 * sign * limit, 0)));
    EXPECT_TRUE(is_rough(*cube, *block, Vec3(0, 0, 1.001 * sign * limit)));
  }
  EXPECT_FALSE(is_rough(*block, *cube, Vec3(1.001 * limit, 0, 0))) << "a larger probe";
}

}  // namespace
}  // namespace sonde
