// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/mass.hpp"
#include "engine/geometry/pose.hpp"

namespace sonde {

/// Virtual coupling between the device pose O and the separated pose Q.
struct Coupling {
  /// - object: the gradient of U = ½ k σ, one gain for translation and rotation.
  /// - classic: a spring and a damper for the translation, and one each for the rotation.
  enum class Mode { object, classic };
  Mode mode = Mode::object;  ///< which of the gains below count
  double k = 500;            ///< N/m, object-norm mode: U = ½ k σ
  double k_t = 500;          ///< N/m, classic: translation
  double k_r = 1;            ///< N·m/rad, classic: rotation
  double b_t = 0;            ///< N·s/m, classic: damping of the separation
  double b_r = 0;            ///< N·m·s/rad
  double max_force = 10;     ///< device limit on |F|, N
  double max_torque = 0.5;   ///< device limit on |τ|, N·m
};

/// Force (N) and torque (N·m, about the probe's centre of mass at the device pose), in the fixed
/// body's mesh frame, acting on the hand.
struct Wrench {
  Vec3 force = Vec3::Zero();   ///< N
  Vec3 torque = Vec3::Zero();  ///< N·m, about the probe's centre of mass
  bool saturated = false;      ///< a device limit acted
};

// Not of the public face from here on (engine/sonde.hpp).

/// The separation from O to Q as the classic coupling uses it.
struct SeparationMotion {
  Vec3 t = Vec3::Zero();      ///< displacement of the centre of mass, fixed frame, m
  Vec3 theta = Vec3::Zero();  ///< rotation vector from O to Q, fixed frame, rad
};
SeparationMotion separation_motion(const MassProperties& mass, const Pose& X_FO, const Pose& X_FQ);

/// F = k t; τ = R_BO 2k (wÎv + v×Îv), before device limits.
Wrench object_norm_wrench(const MassProperties& mass, const Pose& X_FO, const Pose& X_FQ, double k);

/// F = k_t t + b_t ṫ, τ = k_r θ + b_r θ̇ with the rates of the separation, before device limits.
Wrench classic_wrench(const SeparationMotion& now, const Vec3& t_rate, const Vec3& theta_rate,
                      const Coupling& coupling);

/// Scales force and torque separately down to the device's limits, and keeps their directions.
Wrench limit(const Wrench& wrench, double max_force, double max_torque);

}  // namespace sonde
