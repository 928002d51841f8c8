// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "engine/haptics/coupling/coupling.hpp"
#include "engine/settings/device_profile.hpp"

namespace sonde {

/// Limits of the pulses.
struct PulseLimits {
  /// N, the largest force, further limited to half of what the device can give. A hand near the
  /// handle feels 2 N and is not hurt by it. With less, friction hides more of the motion.
  double force = 2;
  double torque = 0.05;  ///< N·m, the same
  /// m, excursion of the handle in the largest pulse, if the profile's mass is right: far above the
  /// step of any encoder, and small within any workspace.
  double travel = 0.01;
  double turn = 0.3;  ///< rad, the same
};

/// A pulse along one axis: one part with this force, two with the opposite force, and one with this
/// force again. So its mean is zero, and a handle without friction ends at rest where it began.
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

/// The largest limits that a user may set for a device: half of what it can give, and a travel that
/// stays within an ordinary workspace.
PulseLimits most_allowed(const DeviceProfile& device);

/// Pulses for a device, the smallest first. Their amplitudes differ, because Coulomb friction takes
/// the same force from each and viscous damping a proportional one, and because the steps of the
/// encoder then occur at other places in each. They go to both sides, because gravity acts to one.
/// Throws std::invalid_argument for limits or a sample time that are not above zero.
PulsePlan plan_pulses(const DeviceProfile& device, const PulseLimits& limits, double sample_time);

/// The command at each sample.
std::vector<Wrench> commands_of(const PulsePlan& plan);
double time_of(const PulsePlan& plan);  ///< s

}  // namespace sonde
