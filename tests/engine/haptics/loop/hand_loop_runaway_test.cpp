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

}  // namespace
}  // namespace sonde::test
