// SPDX-License-Identifier: GPL-3.0-or-later
// The device's traits that DeviceMotion tells the loop.
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/devices/device_motion.hpp"
#include "tests/engine/devices/motion_samples.hpp"

namespace sonde {
namespace {

using test::along;
using test::com;
using test::handle_at;
using test::in_scene;
using test::pushed;
using test::start;

// The reference is damping by definition, felt force by velocity of the handle, with the probe's
// velocity from differences of its pose.
TEST(DeviceMotion, the_damping_a_probe_may_have_is_in_the_hand_what_a_device_bears) {
  constexpr double bears = 4, bears_turning = 0.004;
  for (const double scaling : {0.1, 1.0, 8.0}) {
    DeviceSettings settings = in_scene();
    settings.scaling = scaling;
    settings.axes.axes[1].gain = 2;
    settings.axes.axes[5].gain = 3;
    DeviceMotion motion(settings, Vec3::Zero(), start);
    motion.move(handle_at({0, 0, 0}), 0);
    double most = 0, most_turning = 0;
    for (int axis = 0; axis < 3; ++axis) {
      constexpr double step = 1e-6, dt = 1e-3;
      const Vec3 along = step * Vec3::Unit(axis);
      const Quat turn(Eigen::AngleAxisd(step, Vec3::Unit(axis)));
      DeviceSample moved = handle_at(along);
      moved.X_BH.q = turn;
      const Pose before = motion.move(handle_at({0, 0, 0}), dt).X_FM;
      const HandSample after = motion.move(moved, dt);
      ASSERT_TRUE(after.device);
      const Vec3 way = after.X_FM.p - before.p;
      const Eigen::AngleAxisd spin(after.X_FM.q * before.q.conjugate());
      const DeviceWrench felt = motion.on_handle(
          {.force = -after.device->max_damping * way,
           .torque = -after.device->max_rotational_damping * spin.angle() * spin.axis()});
      most = std::max(most, felt.force.norm() / step);
      most_turning = std::max(most_turning, felt.torque.norm() / step);
    }
    EXPECT_NEAR(most, bears, 1e-6 * bears) << scaling;
    EXPECT_NEAR(most_turning, bears_turning, 1e-4 * bears_turning) << scaling;
  }
  DeviceMotion puck(in_scene(), com, start);
  EXPECT_FALSE(puck.move(pushed(along(0, 1)), 0.001).device) << "it feels nothing";
}

/// A device with force, at rest.
DeviceSample with_force() {
  DeviceSample sample = handle_at({0, 0, 0});
  sample.max_force = 12;
  return sample;
}

DeviceTraits of_a_profile() {
  DeviceTraits handle;
  handle.damping = 2;
  handle.delay = 1e-3;
  handle.rotational_damping = 5e-4;
  handle.mass = 0.3;
  handle.inertia = 2e-4;
  handle.max_force = 20;
  handle.max_torque = 0.4;
  handle.max_stiffness = 4000;
  handle.max_rotational_stiffness = 8;
  handle.max_damping = 30;
  return handle;
}

TEST(DeviceMotion, without_a_profile_it_is_an_unknown_device) {
  DeviceMotion motion(in_scene(), com, start);
  const auto traits = motion.move(with_force(), 0).device;
  ASSERT_TRUE(traits);
  EXPECT_FALSE(traits->known);
  EXPECT_EQ(traits->damping, 0);
  EXPECT_EQ(traits->mass, 0);
  EXPECT_EQ(traits->max_force, 12);
}

TEST(DeviceMotion, its_profile_says_how_the_handle_moves) {
  DeviceSettings settings = in_scene();
  settings.scaling = 2;
  DeviceMotion motion(settings, com, start);
  motion.set_profile(of_a_profile());
  DeviceSample sample = with_force();
  sample.rate_hz = 500;
  sample.max_torque = 0.2;
  const auto traits = motion.move(sample, 0).device;
  ASSERT_TRUE(traits);
  EXPECT_TRUE(traits->known);
  EXPECT_DOUBLE_EQ(traits->damping, 2. / 4);
  EXPECT_DOUBLE_EQ(traits->mass, 0.3 / 4);
  EXPECT_DOUBLE_EQ(traits->max_stiffness, 4000. / 4);
  EXPECT_DOUBLE_EQ(traits->max_damping, 30. / 4);
  EXPECT_EQ(traits->delay, 1e-3);
  EXPECT_EQ(traits->period, 2e-3);
  EXPECT_DOUBLE_EQ(traits->rotational_damping, 5e-4);
  EXPECT_DOUBLE_EQ(traits->max_rotational_stiffness, 8);
  motion.set_profile({});
  EXPECT_FALSE(motion.move(sample, 1e-3).device->known);
}

TEST(DeviceMotion, its_own_word_counts_more_than_its_profile) {
  DeviceMotion motion(in_scene(), com, start);
  motion.set_profile(of_a_profile());
  DeviceSample sample = with_force();
  sample.max_stiffness = 1500;
  sample.max_damping = 5;
  const auto traits = motion.move(sample, 0).device;
  ASSERT_TRUE(traits);
  EXPECT_EQ(traits->max_force, 12);
  EXPECT_EQ(traits->max_stiffness, 1500);
  EXPECT_EQ(traits->max_damping, 5);
  EXPECT_EQ(traits->max_torque, 0) << "this one has no motors for it";
  EXPECT_EQ(traits->rotational_damping, 0);
}

}  // namespace
}  // namespace sonde
