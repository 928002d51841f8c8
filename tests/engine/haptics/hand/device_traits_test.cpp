// SPDX-License-Identifier: GPL-3.0-or-later
// Reference: the power at the handle is that at the probe, whose velocity is `ratio` times as
// large.
#include "engine/haptics/hand/device_traits.hpp"

#include <gtest/gtest.h>

namespace sonde {
namespace {

SimulatedDeviceParameters some() {
  SimulatedDeviceParameters p;
  p.translation.inertia = 0.3;
  p.translation.damping = 2;
  p.translation.limit = 12;
  p.translation.most_virtual_damping = 30;
  p.translation.most_stiffness = 4000;
  p.rotation.inertia = 2e-4;
  p.rotation.damping = 5e-4;
  p.rotation.limit = 0.4;
  p.rotation.most_virtual_damping = 0.07;
  p.rotation.most_stiffness = 8;
  p.delay = 1e-3;
  return p;
}

TEST(DeviceTraits, of_a_simulated_device_are_its_parameters) {
  const DeviceTraits traits = traits_of(some());
  EXPECT_EQ(traits.damping, 2);
  EXPECT_EQ(traits.rotational_damping, 5e-4);
  EXPECT_EQ(traits.mass, 0.3);
  EXPECT_EQ(traits.inertia, 2e-4);
  EXPECT_EQ(traits.delay, 1e-3);
  EXPECT_EQ(traits.max_force, 12);
  EXPECT_EQ(traits.max_rotational_stiffness, 8);
  EXPECT_TRUE(traits.known && traits.force);
  SimulatedDeviceParameters no_torque = some();
  no_torque.rotation.limit = 0;
  EXPECT_EQ(traits_of(no_torque).rotational_damping, 0) << "no motor turns it";
}

TEST(DeviceTraits, at_the_probe_take_the_same_power) {
  const double ratio = 4, turn_ratio = 3, v = 0.1, w = 2;
  const DeviceTraits handle = traits_of(some()), probe = traits_at_probe(handle, ratio, turn_ratio);
  EXPECT_DOUBLE_EQ(probe.damping * (ratio * v) * (ratio * v), handle.damping * v * v);
  EXPECT_DOUBLE_EQ(probe.mass * (ratio * v) * (ratio * v), handle.mass * v * v);
  EXPECT_DOUBLE_EQ(probe.max_stiffness * (ratio * v) * (ratio * v), handle.max_stiffness * v * v);
  EXPECT_DOUBLE_EQ(probe.max_force * ratio * v, handle.max_force * v);
  EXPECT_DOUBLE_EQ(probe.max_torque * turn_ratio * w, handle.max_torque * w);
  EXPECT_DOUBLE_EQ(probe.rotational_damping * (turn_ratio * w) * (turn_ratio * w),
                   handle.rotational_damping * w * w);
  EXPECT_DOUBLE_EQ(probe.inertia * (turn_ratio * w) * (turn_ratio * w), handle.inertia * w * w);
  EXPECT_EQ(probe.delay, handle.delay);
  EXPECT_EQ(probe.ratio, ratio);
  EXPECT_EQ(probe.turn_ratio, turn_ratio);
}

}  // namespace
}  // namespace sonde
