// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/hand/device_traits.hpp"

namespace sonde {

DeviceTraits traits_of(const SimulatedDeviceParameters& parameters) noexcept {
  const HandleMotion &moving = parameters.translation, &turning = parameters.rotation;
  return {.damping = moving.damping,
          .delay = parameters.delay,
          .ratio = 1,
          .turn_ratio = 1,
          .max_damping = moving.most_virtual_damping,
          .max_rotational_damping = turning.most_virtual_damping,
          .rotational_damping = turning.limit > 0 ? turning.damping : 0,
          .max_stiffness = moving.most_stiffness,
          .max_rotational_stiffness = turning.most_stiffness,
          .max_force = moving.limit,
          .max_torque = turning.limit,
          .mass = moving.inertia,
          .inertia = turning.inertia,
          .force = true,
          .period = 0,
          .known = true};
}

DeviceTraits traits_at_probe(const DeviceTraits& at_handle, double ratio,
                             double turn_ratio) noexcept {
  DeviceTraits out = at_handle;
  out.ratio = ratio;
  out.turn_ratio = turn_ratio;
  for (double DeviceTraits::*value : {&DeviceTraits::damping, &DeviceTraits::max_damping,
                                      &DeviceTraits::max_stiffness, &DeviceTraits::mass})
    out.*value /= ratio * ratio;
  for (double DeviceTraits::*value :
       {&DeviceTraits::rotational_damping, &DeviceTraits::max_rotational_damping,
        &DeviceTraits::max_rotational_stiffness, &DeviceTraits::inertia})
    out.*value /= turn_ratio * turn_ratio;
  out.max_force /= ratio;
  out.max_torque /= turn_ratio;
  return out;
}

}  // namespace sonde
