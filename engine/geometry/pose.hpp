// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

namespace sonde {

using Vec3 = Eigen::Vector3d;  ///< a point, m, or a direction; the variable's name gives the frame
/// A rotation R_BA or a tensor. By columns, whatever a program lets Eigen do without being told.
using Mat3 = Eigen::Matrix<double, 3, 3, Eigen::ColMajor>;
/// A rotation q_BA, of length 1. It is not aligned, so that its offset in a struct does not depend
/// on a program's compiler flags.
using Quat = Eigen::Quaternion<double, Eigen::DontAlign>;

/// A rigid pose X_BA of frame A in frame B: x_B = q x_A + p. Lengths in metres; q is unit.
struct Pose {
  Quat q = Quat::Identity();  ///< rotation q_BA, unit
  Vec3 p = Vec3::Zero();      ///< the origin of A in B, m
};

/// X_CA = X_CB * X_BA.
inline Pose operator*(const Pose& X_CB, const Pose& X_BA) {
  return {(X_CB.q * X_BA.q).normalized(), X_CB.q * X_BA.p + X_CB.p};
}

/// The point x_B = X_BA x_A, m.
inline Vec3 operator*(const Pose& X_BA, const Vec3& x_A) { return X_BA.q * x_A + X_BA.p; }

/// X_AB from X_BA.
inline Pose inverse(const Pose& X_BA) {
  const Quat q = X_BA.q.conjugate();
  return {q, -(q * X_BA.p)};
}

}  // namespace sonde
