// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/queries/pose_matrix.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

// Reference: Eigen's isometry moves points.
TEST(PoseMatrix, matrices_and_isometries_move_points_as_the_pose_does) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20; ++i) {
    const Pose X{test::random_rotation(random), test::random_in_ball(random, 3)};
    const Vec3 x = test::random_in_ball(random, 1);
    EXPECT_LT((isometry_of(X) * x - X * x).norm(), 1e-15 * 8);
    EXPECT_LT(((matrix_of(X) * x.homogeneous()).head<3>() - X * x).norm(), 1e-15 * 8);
    for (const Pose& back : {pose_of(isometry_of(X)), pose_of(matrix_of(X))}) {
      EXPECT_LT(back.q.angularDistance(X.q), 1e-7);
      EXPECT_EQ(back.p, X.p);
    }
  }
}

TEST(PoseMatrix, what_is_no_rigid_motion_is_refused) {
  const Eigen::Matrix4d identity = Eigen::Matrix4d::Identity();
  const auto refused = [](const Eigen::Matrix4d& M) { EXPECT_THROW(pose_of(M), InputError) << M; };
  Eigen::Matrix4d M = identity;
  M(0, 0) = -1;  // mirrors
  refused(M);
  M = identity;
  M.topLeftCorner<3, 3>() *= 1.01;
  refused(M);
  M = identity;
  M(3, 0) = 0.1;  // as if written by columns
  refused(M);
  M = identity;
  M(1, 3) = std::numeric_limits<double>::quiet_NaN();
  refused(M);
}

}  // namespace
}  // namespace sonde
