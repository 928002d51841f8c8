// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/queries/checked_pose.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace sonde {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(CheckedPose, has_a_unit_quaternion_of_the_same_direction_and_the_same_place) {
  for (const auto check : {checked_pose, checked_pose_of_motion}) {
    const Pose X = check({Quat(0, 0, 3, 4), Vec3(1, -2, 1e150)});
    EXPECT_EQ(X.q.coeffs(), Quat(0, 0, 0.6, 0.8).coeffs());
    EXPECT_EQ(X.p, Vec3(1, -2, 1e150));
  }
}

TEST(CheckedPose, what_is_no_pose_is_refused) {
  for (const auto check : {checked_pose, checked_pose_of_motion}) {
    for (const double bad : {std::nan(""), infinite, -infinite}) {
      EXPECT_THROW(check({Quat::Identity(), Vec3(0, bad, 0)}), InputError) << bad;
      EXPECT_THROW(check({Quat(1, 0, bad, 0), Vec3::Zero()}), InputError) << bad;
    }
    EXPECT_THROW(check({Quat(0, 0, 0, 0), Vec3::Zero()}), InputError);
    EXPECT_THROW(check({Quat(1e-170, 0, 0, 0), Vec3::Zero()}), InputError);
    EXPECT_THROW(check({Quat(1e170, 0, 0, 0), Vec3::Zero()}), InputError);
  }
}

TEST(CheckedPose, only_a_motion_has_a_farthest_coordinate) {
  for (const double far : {1.001e150, -1.001e150}) {
    const Pose X{Quat::Identity(), Vec3(0, 0, far)};
    EXPECT_EQ(checked_pose(X).p.z(), far);
    EXPECT_THROW(checked_pose_of_motion(X), InputError) << far;
  }
}

}  // namespace
}  // namespace sonde
