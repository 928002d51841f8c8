// SPDX-License-Identifier: GPL-3.0-or-later
// Reference: the simulated device, and what a spring would do.
#include "engine/study/identification/released_device.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/allocation_counter.hpp"

namespace sonde {
namespace {

SimulatedDeviceParameters usual() {
  SimulatedDeviceParameters device;  // with a hand of 300 N/m
  device.translation.inertia = 0.1;
  return device;
}

TEST(ReleasedDevice, nobody_holds_it) {
  ReleasedDevice device(usual(), 1e-3);
  Wrench push;
  push.force.x() = 0.1;
  for (int i = 0; i < 1000; ++i) device.step(push);
  EXPECT_NEAR(device.measured().p.x(), 0.5 * 0.1 / 0.1, 1e-9) << "½ F/m t², with no spring";
}

TEST(ReleasedDevice, steps_are_longer_where_its_delay_would_be_too_many_of_them) {
  SimulatedDeviceParameters late = usual();
  late.delay = 0.03;
  ReleasedDevice device(late, 1e-3);
  Wrench push;
  push.force.x() = 1;
  for (int i = 0; i < 29; ++i) device.step(push);
  EXPECT_EQ(device.measured().p.x(), 0);
  for (int i = 0; i < 3; ++i) device.step(push);
  EXPECT_GT(device.measured().p.x(), 0);
}

TEST(ReleasedDevice, a_step_does_not_allocate) {
  ReleasedDevice device(usual(), 1e-3);
  test::AllocationCounter counter;
  for (int i = 0; i < 100; ++i) device.step({});
  counter.stop();
  EXPECT_EQ(counter.allocations() + counter.frees(), 0U);
}

TEST(ReleasedDevice, refuses_what_no_device_has) {
  SimulatedDeviceParameters none = usual();
  none.translation.inertia = 0;
  EXPECT_THROW(ReleasedDevice(none, 1e-3), std::invalid_argument);
}

}  // namespace
}  // namespace sonde
