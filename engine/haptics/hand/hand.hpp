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
  /// Largest ratio of the probe's displacement to the hand's; 0: there is no hand to throw.
  double ratio = 1;
  double turn_ratio = 1;  ///< the same for rotation
  // The largest virtual damping that its driver allows; 0: not known.
  double max_damping = 0;             ///< N·s/m
  double max_rotational_damping = 0;  ///< N·m·s/rad
  double rotational_damping = 0;      ///< N·m·s/rad, of the mechanism; 0 where no motor turns it
  // The largest stiffness that it holds by its maker's word; 0: not known.
  double max_stiffness = 0;             ///< N/m
  double max_rotational_stiffness = 0;  ///< N·m/rad
  // What its motors can give; 0: not known, or nothing.
  double max_force = 0;   ///< N
  double max_torque = 0;  ///< N·m
  // What moves with the handle; 0: not known.
  double mass = 0;     ///< kg
  double inertia = 0;  ///< kg·m²
  /// False: it has no motors, so that no force moves it.
  bool force = true;
};

/// What a hand asks of the probe at one tick.
struct HandSample {
  Pose X_FM;             ///< the probe's mesh frame in the fixed body's
  bool held = true;      ///< false: the clutch is open; the probe stays, and there is no force
  bool trusted = true;   ///< false: the pose is old or impossible; there is no force
  bool changed = false;  ///< another hand, or other axes of the same: no force in this tick
  std::optional<DeviceTraits> device = {};  ///< none: unknown device
  /// Of a hand that is being measured, valid until its next sample: the loop renders this in place
  /// of the contact's wrench. None for every other hand.
  HandTrial* trial = nullptr;
};

/// What the servo follows and pushes back: a mouse, a device, a simulated one, a recorded path.
/// Both functions are called on the servo thread alone, once in each tick and in this order, and
/// neither allocates, locks, logs, throws or waits. When the servo stops, render gets a zero wrench
/// once more, even if there was no tick.
struct Hand {
  /// dt: s since the sample before; 0 for the first.
  std::function<HandSample(double dt)> sample;
  /// The wrench on the hand, about the probe's centre of mass at the sampled pose, in the fixed
  /// frame, after every limit. May be empty.
  std::function<void(const Wrench&)> render;
};

}  // namespace sonde
