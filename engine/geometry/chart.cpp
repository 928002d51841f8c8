// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/chart.hpp"

#include <algorithm>
#include <cmath>

namespace sonde {

Chart::Chart(const MassProperties& mass, const Pose& X_FO)
    : mass_(mass),
      device_(X_FO),
      q_MP_(mass.R_MP),
      q_FP_((X_FO.q * q_MP_).normalized()),
      com_(X_FO * mass.com) {
  for (int i = 0; i < 3; ++i) {
    root_[i] = 2 * std::sqrt(mass.inertia[i]);
    per_root_[i] = root_[i] > 0 ? 1 / root_[i] : 0;
  }
}

void Chart::absorb_free_spin(const Pose& X_FM) {
  for (int i = 0; i < 3; ++i) {
    if (root_[i] > 0) continue;
    // The twist about the axis, from the swing-twist decomposition of the relative rotation.
    const Quat turn = q_FP_.conjugate() * (X_FM.q * q_MP_);
    Quat twist(turn.w(), 0, 0, 0);
    twist.coeffs()[i] = turn.coeffs()[i];
    if (twist.norm() > 0) q_FP_ = (q_FP_ * twist.normalized()).normalized();
  }
}

Pose Chart::pose(const Vec6& y) const {
  const Vec3 u = v(y);
  const Quat turn(std::sqrt(std::max(0.0, 1 - u.squaredNorm())), u.x(), u.y(), u.z());
  const Quat q = (q_FP_ * turn * q_MP_.conjugate()).normalized();
  return {q, com_ + y.tail<3>() - q * mass_.com};
}

Vec6 Chart::coordinates(const Pose& X_FM) const {
  Quat turn = q_FP_.conjugate() * (X_FM.q * q_MP_);
  // The turn about an axis without mass comes first, where it does nothing: the rest has no part
  // about that axis (swing-twist decomposition).
  for (int i = 0; i < 3; ++i) {
    Quat twist(turn.w(), 0, 0, 0);
    twist.coeffs()[i] = turn.coeffs()[i];
    if (!(root_[i] > 0) && twist.coeffs()[i] != 0) turn = turn * twist.normalized().conjugate();
  }
  if (turn.w() < 0) turn.coeffs() = -turn.coeffs();
  Vec6 y;
  y.head<3>() = root_.cwiseProduct(turn.vec());
  y.tail<3>() = X_FM * mass_.com - com_;
  return y;
}

Vec6 Chart::row(const Vec6& y, const Vec3& a, const Vec3& n) const {
  const Vec3 u = v(y);
  const double w = std::sqrt(std::max(1e-12, 1 - u.squaredNorm()));
  const Quat turn(w, u.x(), u.y(), u.z());
  const Mat3 R = (q_FP_ * turn).toRotationMatrix();
  const Vec3 r = a - (com_ + y.tail<3>());
  // m is the moment of n about the centre of mass in principal axes at Q. The body's angular
  // velocity is ω = 2 (w + v vᵀ/w − [v]×) v̇, so the row in v̇ is the transpose of this applied to
  // m.
  const Vec3 m = R.transpose() * r.cross(n);
  const Vec3 in_v = 2 * (w * m + u * (u.dot(m) / w) + u.cross(m));
  Vec6 row;
  row.head<3>() = in_v.cwiseProduct(per_root_);
  row.tail<3>() = n;
  return row;
}

}  // namespace sonde
