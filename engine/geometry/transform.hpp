// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/pose.hpp"

namespace sonde {

/// A pose as a rotation matrix and a translation, as the geometric kernels need it. Every kernel
/// and every test for a free pose uses this one conversion, so all of them see the same transformed
/// vertices, to the bit.
struct Transform {
  Mat3 R = Mat3::Identity();
  Vec3 p = Vec3::Zero();
  Transform() = default;
  Transform(const Mat3& R_BA, const Vec3& p_BA) : R(R_BA), p(p_BA) {}
  explicit Transform(const Pose& X) : R(X.q.toRotationMatrix()), p(X.p) {}
  Vec3 operator*(const Vec3& x) const { return R * x + p; }
};

}  // namespace sonde
