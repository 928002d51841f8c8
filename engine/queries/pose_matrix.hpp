// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <span>

#include "engine/base/error.hpp"
#include "engine/geometry/pose.hpp"

namespace sonde {

/// The pose X_BA of a homogeneous matrix, by rows: x_B = M x_A with x = (x, y, z, 1), lengths in
/// metres. Rounding errors of the rotation are removed (orthogonalised).
/// @throws InputError if a number is not finite, the last row is not 0, 0, 0, 1 (to 1e-9), or the
/// upper left is no rotation (to 1e-3).
Pose pose_of_matrix(std::span<const double, 16> by_rows);

/// As pose_of_matrix().
inline Pose pose_of(const Eigen::Matrix4d& M_BA) {
  double by_rows[16];
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) by_rows[4 * i + j] = M_BA(i, j);
  return pose_of_matrix(by_rows);
}
/// As pose_of_matrix().
inline Pose pose_of(const Eigen::Isometry3d& X_BA) {
  return pose_of(Eigen::Matrix4d(X_BA.matrix()));
}

/// The homogeneous matrix of a pose: x_B = M x_A with x = (x, y, z, 1).
/// @pre X_BA.q has length 1.
inline Eigen::Matrix4d matrix_of(const Pose& X_BA) {
  Eigen::Matrix4d M = Eigen::Matrix4d::Identity();
  M.topLeftCorner<3, 3>() = X_BA.q.toRotationMatrix();
  M.topRightCorner<3, 1>() = X_BA.p;
  return M;
}
/// The pose as Eigen's isometry.
/// @pre X_BA.q has length 1.
inline Eigen::Isometry3d isometry_of(const Pose& X_BA) {
  return Eigen::Isometry3d(matrix_of(X_BA));
}

}  // namespace sonde
