// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "engine/geometry/pose.hpp"
#include "engine/haptics/coupling/coupling.hpp"

namespace sonde {

struct HandTrial;

/// Known properties of the device in the hand, as felt at the probe.
struct DeviceTraits {
  double damping = 0;  ///< N·s/m, of the mechanism
  double delay = 0;    ///< s, from command to motors
  /// Largest ratio of the probe's displacement to the hand's; 0: no force can make this hand run
  /// away (Runaway).
  double ratio = 1;
  double turn_ratio = 1;  ///< the same for rotation
  // Largest virtual damping that its driver allows; 0: unknown.
  double max_damping = 0;             ///< N·s/m
  double max_rotational_damping = 0;  ///< N·m·s/rad
  double rotational_damping = 0;      ///< N·m·s/rad, of the mechanism; 0 if no motor turns it
  // Largest stiffness that its maker states; 0: unknown.
  double max_stiffness = 0;             ///< N/m
  double max_rotational_stiffness = 0;  ///< N·m/rad
  // Largest output of its motors; 0: unknown, or none.
  double max_force = 0;   ///< N
  double max_torque = 0;  ///< N·m
  // Inertia that moves with the handle; 0: unknown.
  double mass = 0;     ///< kg
  double inertia = 0;  ///< kg·m²
  /// False: the device has no motors, so no force moves it.
  bool force = true;
};

/// The input of the hand in one tick.
struct HandSample {
  Pose X_FM;             ///< the probe's mesh frame in the fixed body's
  bool held = true;      ///< false: the clutch is open; the probe stays, and there is no force
  bool trusted = true;   ///< false: the pose is old or impossible; there is no force
  bool changed = false;  ///< another hand, or the same with new axes: no force in this tick
  std::optional<DeviceTraits> device = {};  ///< none: unknown device
  /// For a hand that is being measured, valid until its next sample: the loop renders this instead
  /// of the contact's wrench. Null for every other hand.
  HandTrial* trial = nullptr;
  /// s: of the device, between the report before and that of this pose; 0: no longer than a tick.
  double since = 0;
};

/// The source of the probe's pose and the receiver of the force: a mouse, a device, a simulated
/// one, or a recorded path. Both functions are called on the servo thread only, once in each tick
/// and in this order, and neither allocates, locks, logs, throws or waits. When the servo stops,
/// render gets a zero wrench once more, even if there was no tick.
struct Hand {
  /// dt: s since the sample before; 0 for the first.
  std::function<HandSample(double dt)> sample;
  /// Receives the wrench on the hand, about the probe's centre of mass at the sampled pose, in the
  /// fixed frame, after every limit. May be empty.
  std::function<void(const Wrench&)> render;
};

}  // namespace sonde
