// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/pose.hpp"

namespace sonde {

/// Virtual coupling between the device pose O and the separated pose Q.
struct Coupling {
  /// - object: the gradient of U = ½ k σ, one gain for translation and rotation.
  /// - classic: a spring and a damper for the translation, and one each for the rotation.
  /// - damped: that of object, with a damper for the rate of the separation (ObjectDamper).
  enum class Mode { object, classic, damped };
  Mode mode = Mode::object;  ///< selects the gains below
  double k = 500;            ///< N/m, object and damped: U = ½ k σ
  double k_t = 500;          ///< N/m, classic: translation
  double k_r = 1;            ///< N·m/rad, classic: rotation
  double b_t = 0;            ///< N·s/m, classic and damped: damping of the separation
  double b_r = 0;            ///< N·m·s/rad
  double max_force = 10;     ///< device limit on |F|, N
  double max_torque = 0.5;   ///< device limit on |τ|, N·m
};

/// Whether the spring is the gradient of U = ½ k σ.
constexpr bool in_object_norm(Coupling::Mode mode) { return mode != Coupling::Mode::classic; }

/// Force (N) and torque (N·m, about the probe's centre of mass at the device pose), in the fixed
/// body's mesh frame, acting on the hand.
struct Wrench {
  Vec3 force = Vec3::Zero();   ///< N
  Vec3 torque = Vec3::Zero();  ///< N·m, about the probe's centre of mass
  bool saturated = false;      ///< a device limit acted
};

}  // namespace sonde
