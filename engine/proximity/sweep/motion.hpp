// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/chart.hpp"
#include "engine/geometry/transform.hpp"

namespace sonde {

/// A rigid motion of the probe, 0 ≤ s ≤ 1, with the bounds that a sweep needs.
class Motion {
 public:
  static constexpr double least_w2 = 1e-12;

  /// The straight path y(s) = from + s (to − from) of a chart. 1 − |v|² must stay above least_w2:
  /// nearer to a half turn, the bounds are not valid.
  Motion(const Chart& chart, const Vec6& from, const Vec6& to);
  /// From one pose X_FM to another: the centre of mass moves on a straight line, and the probe
  /// turns about one axis in the shorter sense (at most half a turn), both with constant speed.
  Motion(const MassProperties& mass, const Pose& from, const Pose& to);

  Transform at(double s) const;  ///< X_FM
  Pose pose_at(double s) const;  ///< the same as a pose
  struct Velocity {
    Vec3 linear;   ///< of the centre of mass, per unit of s, fixed frame
    Vec3 angular;  ///< fixed frame
  };
  Velocity velocity(double s) const;
  /// Bound of the acceleration of a point anywhere on the path, per unit of s squared and per
  /// distance from the centre of mass.
  double acceleration_per_radius() const { return acceleration_; }
  /// Anywhere on the path, the acceleration of a point with the arm r from the centre of mass (mesh
  /// frame) is bend() r, in the fixed frame, with an error of at most bend_error() |r|: the size
  /// and the direction of the curvature that a turn causes, up to third order.
  const Mat3& bend() const { return bend_; }
  double bend_error() const { return bend_error_; }
  /// Length of the path of the centre of mass, m, and a bound of the total angle turned through on
  /// the path, rad (not only between its ends): a point at distance r from the centre of mass
  /// travels at most linear_distance() + r turn_bound().
  double linear_distance() const { return com_step_.norm(); }
  double turn_bound() const { return turn_; }
  double farthest(double radius) const { return linear_distance() + radius * turn_bound(); }
  /// The centre of mass in the mesh frame.
  const Vec3& com() const { return com_M_; }

 private:
  Quat relative(double s) const;
  Quat q_FP_, q_PM_;
  Vec3 com_M_, com_from_, com_step_, v_from_, v_step_;
  double acceleration_;
  double turn_;
  Mat3 bend_;
  double bend_error_;
  double steady_ = 0;         // rad per unit of s about one axis; 0: the turn follows v(s)
  Vec3 axis_ = Vec3::Zero();  // of a turn with constant speed, unit, in principal axes at s = 0
};

}  // namespace sonde
