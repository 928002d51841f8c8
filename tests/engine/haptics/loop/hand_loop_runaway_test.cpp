// SPDX-License-Identifier: GPL-3.0-or-later
// The loop of the hand where the hand is thrown: no force until it has left the contact.
#include <gtest/gtest.h>

#include "tests/engine/haptics/loop/hand_loop_bench.hpp"

namespace sonde::test {
namespace {

using Bench = HandLoopBench;

/// A device that slides along the block's top at 3 m/s, pressed into it.
const HandTick& throw_hand(Bench& bench, const DeviceTraits& traits) {
  for (int i = -40; i < 40; ++i) {
    Pose X = at_depth(0.002);
    X.p.x() = 0.003 * i;
    bench.tick({.X_FM = X, .changed = i == -40, .device = traits});
  }
  return bench.loop.last();
}

TEST(HandLoop, a_hand_that_is_thrown_gets_nothing_until_it_has_left_the_contact) {
  Bench bench;
  const DeviceTraits device{.damping = 1};
  bench.tick({.X_FM = at_depth(0.002), .device = device});
  const HandTick& thrown = throw_hand(bench, device);
  EXPECT_EQ(thrown.hand.withheld, Withheld::diverged);
  EXPECT_EQ(thrown.wrench.force, Vec3::Zero());
  Pose rest = at_depth(0.002);
  rest.p.x() = 0.117;
  for (int i = 0; i < 200; ++i) bench.tick({.X_FM = rest, .device = device});
  EXPECT_EQ(bench.loop.last().hand.withheld, Withheld::diverged) << "still in contact";
  for (int i = 0; i < 50; ++i) bench.tick({.X_FM = at_depth(-0.001), .device = device});
  for (int i = 0; i < 3; ++i) bench.tick({.X_FM = at_depth(0.002), .device = device});
  EXPECT_EQ(bench.loop.last().hand.withheld, Withheld::nothing);
  EXPECT_GT(bench.loop.last().wrench.force.z(), 0.9);
}

TEST(HandLoop, a_thrown_hand_that_is_not_to_be_trusted_for_a_tick_still_gets_nothing) {
  const DeviceTraits device{.damping = 1};
  Pose rest = at_depth(0.002);
  rest.p.x() = 0.117;
  for (const bool changed : {false, true}) {
    Bench bench;
    bench.tick({.X_FM = at_depth(0.002), .device = device});
    throw_hand(bench, device);
    bench.tick({.X_FM = rest, .trusted = changed, .changed = changed, .device = device});
    for (int i = 0; i < 200; ++i) bench.tick({.X_FM = rest, .device = device});
    EXPECT_EQ(bench.loop.last().hand.withheld, Withheld::diverged) << changed;
  }
}

/// Pressed into the block, it spins about the block's normal through its own centre of mass, which
/// so stands still.
const HandTick& spin_hand(Bench& bench, const DeviceTraits& traits, double speed) {
  const Vec3& com = bench.probe->mass.com;
  const Vec3 there = at_depth(0.002) * com;
  for (int i = 0; i < 60; ++i) {
    Pose X = at_depth(0.002);
    X.q = (Quat(Eigen::AngleAxisd(speed * dt * i, Vec3::UnitZ())) * X.q).normalized();
    X.p = there - X.q * com;
    bench.tick({.X_FM = X, .changed = i == 0, .device = traits});
  }
  return bench.loop.last();
}

TEST(HandLoop, a_hand_that_is_thrown_into_a_turn_gets_nothing) {
  const DeviceTraits device{.damping = 1};
  Bench slow;
  slow.settle(0.002, 10);
  EXPECT_NE(spin_hand(slow, device, 15).hand.withheld, Withheld::diverged);
  Bench fast;
  fast.settle(0.002, 10);
  const HandTick& thrown = spin_hand(fast, device, 60);
  EXPECT_EQ(thrown.hand.withheld, Withheld::diverged);
  EXPECT_EQ(thrown.wrench.force, Vec3::Zero());
  EXPECT_EQ(thrown.wrench.torque, Vec3::Zero());
  DeviceTraits geared = device;
  geared.turn_ratio = 5;  // the probe turns five times as far as the hand
  Bench scaled;
  scaled.settle(0.002, 10);
  EXPECT_NE(spin_hand(scaled, geared, 60).hand.withheld, Withheld::diverged);
}

TEST(HandLoop, the_speed_is_that_of_the_hand_and_a_mouse_has_none) {
  Bench scaled;
  const DeviceTraits half{.ratio = 2};
  scaled.tick({.X_FM = at_depth(0.002), .device = half});
  EXPECT_EQ(throw_hand(scaled, half).hand.withheld, Withheld::nothing) << "1.5 m/s in the hand";
  Bench mouse;
  mouse.settle(0.002, 5);
  for (int i = -40; i < 40; ++i) {
    Pose X = at_depth(0.002);
    X.p.x() = 0.003 * i;
    EXPECT_EQ(mouse.tick({.X_FM = X}).hand.withheld, Withheld::nothing);
  }
}

TEST(HandLoop, a_weak_device_counts_as_thrown_at_less) {
  // 1.6 m/s: more than all of 3.3 N makes of 50 g in 20 ms (1.32 m/s).
  const auto withheld = [](const DeviceTraits& device) {
    Bench bench;
    bench.tick({.X_FM = at_depth(0.002), .device = device});
    for (int i = -40; i < 40; ++i) {
      Pose X = at_depth(0.002);
      X.p.x() = 0.0016 * i;
      bench.tick({.X_FM = X, .changed = i == -40, .device = device});
    }
    return bench.loop.last().hand.withheld;
  };
  DeviceTraits device;
  EXPECT_EQ(withheld(device), Withheld::nothing);
  device.max_force = 3.3;
  device.mass = 0.05;
  EXPECT_EQ(withheld(device), Withheld::diverged);
}

// The gains' own limit may be far beyond what the device can: a tenth of that in a millisecond.
TEST(HandLoop, the_force_of_a_device_changes_by_less_than_it_can_give) {
  Coupling coupling;
  coupling.k = 5000;
  coupling.max_force = 1000;
  Bench bench({}, coupling);
  DeviceTraits device;
  device.max_force = 3.3;
  double depth = 1e-4;
  bench.tick({.X_FM = at_depth(-depth), .device = device});  // what begins in a contact is held
  for (int i = 0; i < 2000; ++i) bench.tick({.X_FM = at_depth(depth), .device = device});
  double before = bench.loop.last().wrench.force.norm(), most = 0;
  EXPECT_NEAR(before, 0.5, 1e-3);
  for (int i = 0; i < 10; ++i) {
    depth += 1e-3;  // 1 m/s, as a hand may
    const double now = bench.tick({.X_FM = at_depth(depth), .device = device}).wrench.force.norm();
    most = std::max(most, std::abs(now - before));
    before = now;
  }
  EXPECT_GT(most, 0.3);
  EXPECT_LE(most, 0.33 + 0.01 + 1e-9) << "a tenth, and the rate of change";
}

// A hand at 0.3 m/s is no glitch, however far the probe goes for that.
TEST(HandLoop, a_scaled_motion_of_the_hand_is_no_leap) {
  Coupling coupling;
  coupling.k = 50;
  Bench bench(HandLoopSettings{}, coupling);
  DeviceTraits device;
  device.ratio = 10;
  double depth = 1e-3;
  for (int i = 0; i < 2000; ++i) bench.tick({.X_FM = at_depth(depth), .device = device});
  for (int i = 0; i < 3; ++i) bench.tick({.X_FM = at_depth(depth += 0.003), .device = device});
  EXPECT_NEAR(bench.loop.last().wrench.force.norm(), coupling.k * depth, 0.02);
}

}  // namespace
}  // namespace sonde::test
