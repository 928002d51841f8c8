// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/device_sample.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace sonde::test {
namespace {

using namespace std::chrono_literals;

DeviceSample ready_at(DeviceClock::time_point time) {
  DeviceSample sample;
  sample.state = DeviceState::ready;
  sample.time = time;
  sample.stale_after = 200ms;
  return sample;
}

TEST(DeviceSample, an_old_deflection_is_none) {
  const auto start = DeviceClock::now();
  DeviceSample sample = ready_at(start);
  sample.deflection[2] = 0.5;
  EXPECT_EQ(aged(sample, start + 200ms).state, DeviceState::ready);
  EXPECT_EQ(aged(sample, start + 200ms).deflection[2], 0.5);
  EXPECT_EQ(aged(sample, start + 201ms).state, DeviceState::silent);
  EXPECT_EQ(aged(sample, start + 201ms).deflection, SixAxes::Zero());
}

TEST(DeviceSample, a_puck_at_rest_may_be_silent_and_a_pose_may_not) {
  const auto start = DeviceClock::now();
  DeviceSample sample = ready_at(start);
  EXPECT_EQ(aged(sample, start + 1h).state, DeviceState::ready);
  sample.position = true;
  EXPECT_EQ(aged(sample, start + 1h).state, DeviceState::silent);
}

TEST(DeviceSample, age_does_not_hide_a_fault) {
  const auto start = DeviceClock::now();
  DeviceSample sample = ready_at(start);
  sample.position = true;
  for (const DeviceState state : {DeviceState::absent, DeviceState::refused, DeviceState::faulty}) {
    sample.state = state;
    EXPECT_EQ(aged(sample, start + 1h).state, state);
  }
}

TEST(DeviceSample, a_wrench_is_scaled_to_the_limits_and_keeps_its_direction) {
  const DeviceCapabilities can{.force = true, .max_force = 5, .max_torque = 0.1};
  const DeviceWrench wrench{{6, 0, 8}, {0.03, 0.04, 0}};
  const DeviceWrench within = limited(wrench, can);
  EXPECT_LT((within.force - Vec3(3, 0, 4)).norm(), 1e-15);
  EXPECT_EQ(within.torque, wrench.torque);
  EXPECT_EQ(limited(wrench, {}).force, Vec3::Zero()) << "a device without force";
}

TEST(DeviceSample, a_wrench_that_is_no_number_is_no_wrench) {
  const DeviceCapabilities can{.force = true, .max_force = 5, .max_torque = 0.1};
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const DeviceWrench within = limited({{1, 2, 3}, {0, bad, 0}}, can);
    EXPECT_EQ(within.force, Vec3::Zero());
    EXPECT_EQ(within.torque, Vec3::Zero());
  }
  const double huge = std::numeric_limits<double>::max();
  EXPECT_NEAR(limited({{huge, huge, 0}, Vec3::Zero()}, can).force.norm(), 5, 1e-14);
}

}  // namespace
}  // namespace sonde::test
