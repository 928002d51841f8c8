// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/mass.hpp"
#include "engine/geometry/pose.hpp"

namespace sonde {

using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

/// Motions of the probe from its device pose O in the coordinates in which the object norm is
/// Euclidean: y = (2√Î₁ v₁, 2√Î₂ v₂, 2√Î₃ v₃, t), σ = |y|². v is the vector part of the relative
/// unit quaternion in principal axes (w ≥ 0), and t the displacement of the centre of mass in the
/// fixed frame, m. An axis about which a turn moves no mass (Î = 0) is left out: its coordinate is
/// 0.
class Chart {
 public:
  Chart(const MassProperties& mass, const Pose& X_FO);

  /// If a turn about an axis moves no mass (Î = 0), O may be turned about it by any angle. This
  /// chooses the angle at which X_FM is reached without such a turn, so that coordinates(X_FM) is
  /// complete.
  void absorb_free_spin(const Pose& X_FM);

  /// The pose X_FM at y. |v| must be below 1.
  Pose pose(const Vec6& y) const;
  /// y of a pose. A turn about an axis with Î = 0 is dropped.
  Vec6 coordinates(const Pose& X_FM) const;
  Vec3 v(const Vec6& y) const { return y.head<3>().cwiseProduct(per_root_); }
  /// The rotational part of y for a covector of v.
  Vec3 in_v(const Vec3& covector) const { return covector.cwiseProduct(per_root_); }
  /// The |v| at which descents leave the chart: beyond it, ∂w/∂v becomes too large (w is 0.31
  /// there, the turn 144°).
  static constexpr double largest_v = 0.95;

  /// The row J of a contact at point a with normal n (fixed frame), at y: n·ȧ = J·ẏ.
  Vec6 row(const Vec6& y, const Vec3& a, const Vec3& n) const;

  const MassProperties& mass() const { return mass_; }
  const Pose& device() const { return device_; }
  const Quat& principal() const { return q_FP_; }
  const Vec3& com() const { return com_; }

 private:
  const MassProperties& mass_;
  Pose device_;
  Quat q_MP_;
  Quat q_FP_;      // principal axes at O in the fixed frame
  Vec3 com_;       // centre of mass at O, fixed frame
  Vec3 root_;      // 2√Î
  Vec3 per_root_;  // 1 / (2√Î), 0 where Î is 0
};

}  // namespace sonde
