// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/hand_grip.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/study/tuning/tuning.hpp"

namespace sonde::ui::test {
namespace {

TEST(HandGrip, the_usual_one_leaves_a_device_as_it_is_simulated_without_a_choice) {
  const SimulatedDeviceParameters as_is;
  const SimulatedDeviceParameters held_so = held(as_is, {});
  EXPECT_EQ(held_so.translation.hand_stiffness, as_is.translation.hand_stiffness);
  EXPECT_EQ(held_so.translation.hand_damping, as_is.translation.hand_damping);
  EXPECT_EQ(held_so.translation.inertia, as_is.translation.inertia);
  EXPECT_EQ(held_so.rotation.hand_stiffness, as_is.rotation.hand_stiffness);
  EXPECT_EQ(held_so.rotation.hand_damping, as_is.rotation.hand_damping);
  EXPECT_EQ(held_so.rotation.inertia, as_is.rotation.inertia);
}

TEST(HandGrip, light_and_firm_are_the_hands_of_a_study) {
  ASSERT_EQ(named_grips().size(), 3u);
  EXPECT_EQ(named_grips()[0].grip.stiffness, hand_grips[0].stiffness);
  EXPECT_EQ(named_grips()[0].grip.damping, hand_grips[0].damping);
  EXPECT_EQ(named_grips()[2].grip.stiffness, hand_grips[1].stiffness);
  EXPECT_EQ(named_grips()[2].grip.damping, hand_grips[1].damping);
}

/// Newton's law at the handle: m ẍ + (b + b_h) ẋ + k_h x = k_h x_h has the undamped swing
/// √(k_h/m). With the dampings at nothing, the time between two crossings is π√(m/k_h).
TEST(HandGrip, the_mass_slows_the_swing_down) {
  SimulatedDeviceParameters device;
  device.translation = {.inertia = 0.1};
  const auto half_swing = [&](double mass) {
    SimulatedDeviceParameters p = held(device, {300, 0, mass});
    p.translation.hand_damping = 0;
    SimulatedDevice handle(p, 1e-4);
    const Pose wanted{Quat::Identity(), Vec3(0.01, 0, 0)};
    handle.reset(Pose{}, wanted);
    int steps = 0;
    do {
      handle.step({}, wanted);
      ++steps;
    } while (handle.state().velocity.x() > 0);
    return 1e-4 * steps;
  };
  for (const double mass : {0.0, 0.3})
    EXPECT_NEAR(half_swing(mass), std::numbers::pi * std::sqrt((0.1 + mass) / 300), 2e-4) << mass;
}

}  // namespace
}  // namespace sonde::ui::test
