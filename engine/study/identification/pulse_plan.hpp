// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "engine/haptics/coupling/coupling.hpp"
#include "engine/settings/device_profile.hpp"

namespace sonde {

/// The most that pulses may do.
struct PulseLimits {
  /// N, the largest force; also half of what the device can. A hand that rests near the handle
  /// feels 2 N and is not hurt by it. With less, friction hides more of the motion.
  double force = 2;
  double torque = 0.05;  ///< N·m, the same
  /// m, how far the largest pulse moves the handle, if the profile's mass is right: far beyond a
  /// step of any encoder, and small within any workspace.
  double travel = 0.01;
  double turn = 0.3;  ///< rad, the same
};

/// A pulse along one axis: a part with this force, two with the opposite one, and a part with it
/// again. So its mean is zero, and a handle without friction ends at rest where it was.
struct Pulse {
  std::size_t axis = 0;   ///< 0 to 2: force along x, y, z; 3 to 5: torque about them
  double amplitude = 0;   ///< N | N·m, with the sign of its first part
  std::size_t part = 10;  ///< samples
};

/// Small pulses along every axis that has motors, one at a time, with rests between them.
struct PulsePlan {
  double sample_time = 1e-3;  ///< s
  std::size_t rest = 250;     ///< samples before each pulse and after the last
  std::vector<Pulse> pulses;
};

/// The most that a person may ask of a device: half of what it can, and a travel that leaves it
/// within an ordinary workspace.
PulseLimits most_allowed(const DeviceProfile& device);

/// Pulses for a device, the smallest first. Their amplitudes differ, because Coulomb friction takes
/// the same of each and viscous damping takes in proportion, and because the steps of the encoder
/// then fall elsewhere in each. They go to both sides, because gravity has one. Throws
/// std::invalid_argument for limits or a sample time that are not above zero.
PulsePlan plan_pulses(const DeviceProfile& device, const PulseLimits& limits, double sample_time);

/// The command at each sample.
std::vector<Wrench> commands_of(const PulsePlan& plan);
double time_of(const PulsePlan& plan);  ///< s

}  // namespace sonde
