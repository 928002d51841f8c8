// SPDX-License-Identifier: GPL-3.0-or-later
// The damping that acts behind the gate, after what withheld the force. Reference: the same loop
// without the controller, and a hand that holds still, where there is nothing to damp.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/haptics/safety/hand_trial.hpp"
#include "tests/engine/haptics/loop/hand_loop_bench.hpp"

namespace sonde::test {
namespace {

using Bench = HandLoopBench;

DeviceTraits arm(double most_force) {
  return {.max_damping = 4, .max_force = most_force, .mass = 0.2};
}

/// Goes out from 5 mm to 2.6, by 0.35 m/s: the contact has given, and the controller brakes.
void pull(Bench& bench, const DeviceTraits& device, bool control) {
  bench.loop.set_passivity_control(control);
  for (int i = 0; i < 2000; ++i) bench.tick({.X_FM = at_depth(0.00505), .device = device});
  for (int i = 1; i <= 7; ++i)
    bench.tick({.X_FM = at_depth(0.00505 - 3.5e-4 * i), .device = device});
}

/// What withholds the force, or gives another one.
struct Break {
  const char* name;
  void (*ticks)(Bench&, HandSample);
};
const Break breaks[] = {
    {"untrusted",
     [](Bench& b, HandSample s) {
       s.trusted = false;
       b.tick(s);
     }},
    {"stopped",
     [](Bench& b, HandSample s) {
       for (int i = 0; i < 500; ++i) b.tick(s, true, Withheld::stopped);
     }},
    {"changed",
     [](Bench& b, HandSample s) {
       s.changed = true;
       b.tick(s);
     }},
    {"a puck",
     [](Bench& b, HandSample s) {
       s.device->force = false;
       b.tick(s);
     }},
    {"a mouse",
     [](Bench& b, HandSample s) {
       s.device.reset();
       b.tick(s);
     }},
    {"a trial",
     [](Bench& b, HandSample s) {
       HandTrial trial;
       trial.max_force = trial.max_torque = 1;
       s.trial = &trial;
       b.tick(s);
     }},
    {"a pause", [](Bench& b, HandSample) { b.rest(Withheld::paused); }},
};

/// N, on a hand that holds still in the contact.
double first_after(const Break& what, const DeviceTraits& device, bool control) {
  Bench bench(HandLoopSettings{});
  pull(bench, device, control);
  const HandSample still{.X_FM = at_depth(0.0026), .device = device};
  if (control) {
    EXPECT_GT(bench.loop.last().hand.energy.damping, 3.9) << "it brakes";
  }
  what.ticks(bench, still);
  return bench.tick(still).wrench.force.z();
}

TEST(HandLoopDamping, ends_with_the_force_that_it_was_of) {
  for (const Break& what : breaks)
    for (const double most : {3.3, 12.0})
      EXPECT_NEAR(first_after(what, arm(most), true), first_after(what, arm(most), false), 5e-3)
          << what.name << ' ' << most;
}

// 4 N·s/m at 0.1 m/s, times the share of the ramp.
TEST(HandLoopDamping, rises_from_zero_with_the_force) {
  Bench bench(HandLoopSettings{});
  const DeviceTraits device = arm(12);
  pull(bench, device, true);
  bench.tick({.X_FM = at_depth(0.0026), .device = device}, true, Withheld::stopped);
  for (int i = 1; i <= 20; ++i) {
    const HandTick& tick = bench.tick({.X_FM = at_depth(0.0026 - 1e-4 * i), .device = device});
    const double damping = tick.hand.share * 4 * 0.1;
    EXPECT_LT(tick.hand.share, 0.15);
    EXPECT_GT(tick.wrench.force.z(), -damping - 1e-9) << i;
  }
  EXPECT_GT(bench.loop.last().hand.energy.damping, 3) << "it would brake";
}

// Where no speed is too high for a hand, a pose may be anywhere.
TEST(HandLoopDamping, a_pose_beyond_what_can_be_computed_with_leaves_nothing_behind) {
  for (const double far : {1e160, 1e306}) {
    HandLoopSettings settings = at_once();
    settings.safety.runaway_speed = settings.safety.runaway_turn = 0;
    Bench bench(settings);
    const DeviceTraits device = arm(12);
    pull(bench, device, true);
    Pose X = at_depth(0.0026, far);
    for (const double x : {far, 0.0, far, -far}) {
      X.p.x() = x;
      const Wrench& wrench = bench.tick({.X_FM = X, .device = device}, false).wrench;
      EXPECT_TRUE(wrench.force.allFinite() && wrench.torque.allFinite()) << far << ' ' << x;
      EXPECT_TRUE(std::isfinite(bench.loop.last().hand.energy.excess)) << far << ' ' << x;
    }
    for (int i = 0; i < 500; ++i) bench.tick({.X_FM = at_depth(0.0026), .device = device});
    EXPECT_NEAR(bench.loop.last().wrench.force.z(), 1.3, 0.01) << far;
  }
}

}  // namespace
}  // namespace sonde::test
