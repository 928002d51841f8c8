// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/haptics/hand/simulated_device.hpp"

namespace sonde {

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
  double period = 0;  ///< s, between its reports by its own statement; 0: unknown
  /// False: its damping, and possibly its delay and inertia, are assumed values, or 0 where nothing
  /// is assumed.
  bool known = true;
};

/// The properties of a simulated device, at its handle.
DeviceTraits traits_of(const SimulatedDeviceParameters& parameters) noexcept;

/// Properties at a handle as they are felt at the probe, which moves `ratio` times as far and turns
/// `turn_ratio` times as much (both above zero): the power is the same at both ends. The ratios are
/// those of the result too.
DeviceTraits traits_at_probe(const DeviceTraits& at_handle, double ratio,
                             double turn_ratio) noexcept;

}  // namespace sonde
