// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/mass.hpp"
#include "engine/haptics/coupling/coupling.hpp"

namespace sonde {

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

/// N/m: the error of the force per unit of the probe's lag in y. The error of the torque counts as
/// the force that moves the largest radius of gyration: that is its size in the object norm.
double stiffness_of_lag(const Coupling& c, const MassProperties& mass) noexcept;

/// Moves from `last` towards `wanted`, by at most `most`; `*limited` becomes true where that is
/// less than all.
Vec3 towards(const Vec3& wanted, const Vec3& last, double most, bool* limited = nullptr) noexcept;

}  // namespace sonde
