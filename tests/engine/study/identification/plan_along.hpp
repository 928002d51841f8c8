// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "engine/study/identification/pulse_plan.hpp"

namespace sonde::test {

inline DeviceProfile device_of_mass(double mass) {
  DeviceProfile device;
  device.max_force.value = 10;
  device.mass.value = mass;
  return device;
}

/// A handle of 0.1 kg whose motors give no more than this (N and N·m).
inline DeviceProfile device_of_force(double max_force = 10, double max_torque = 0.3) {
  DeviceProfile p;
  p.max_force.value = max_force;
  p.max_torque.value = max_torque;
  p.mass.value = 0.1;
  p.inertia.value = 1e-4;
  return p;
}

/// Pulses along one axis, for a device that may differ from the one that answers.
inline PulsePlan plan_along(std::size_t axis, const DeviceProfile& device,
                            const PulseLimits& limits = {}) {
  PulsePlan plan = plan_pulses(device, limits, 1e-3);
  std::erase_if(plan.pulses, [&](const Pulse& p) { return p.axis != axis; });
  return plan;
}

}  // namespace sonde::test
