// SPDX-License-Identifier: GPL-3.0-or-later
// Devices that report less often than the servo samples them.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/engine/haptics/loop/hand_loop_bench.hpp"

namespace sonde::test {
namespace {

using Bench = HandLoopBench;

/// N: how far the force stays behind k times the depth while a hand moves in at `speed`, on a
/// device that reports only every `every` ticks, and says so or not.
double behind(double speed, int every, bool says) {
  HandLoopSettings settings;
  settings.safety.ramp_time = 0;
  Bench bench(settings);
  const DeviceTraits traits{.max_force = 12, .mass = 0.2};
  for (int i = 0; i < 2000; ++i)  // the ramp of a start is over
    bench.tick({.X_FM = at_depth(0.001 * std::min(1.0, i * dt)), .device = traits});
  for (int i = 0; i < 100; ++i)
    bench.tick({.X_FM = at_depth(0.001 - 1.1e-4 * i), .device = traits});
  double most = 0, depth = -0.01;
  for (int i = 0; depth < 0.01; ++i) {
    if (i % every == 0) depth = -0.01 + speed * dt * i;
    HandSample sample{.X_FM = at_depth(depth), .device = traits};
    if (says && i % every == 0) sample.since = every * dt;
    const double force = bench.tick(sample).wrench.force.z();
    if (depth > 0.004) most = std::max(most, 500 * depth - force);
  }
  return most;
}

// Reference: a wall of 500 N/m. The force is behind by no more than a report's step is beyond a
// tenth of the largest force, which is what a tick of a millisecond may add, and some old rows.
TEST(HandLoopReports, a_device_that_reports_less_often_than_the_servo_runs_feels_the_wall) {
  constexpr double tenth = 1.2, rows = 0.3;
  for (const double speed : {0.1, 0.3, 0.5})
    for (const int every : {1, 2, 10})
      EXPECT_LT(behind(speed, every, true), std::max(0.0, 500 * speed * every * dt - tenth) + rows)
          << speed << ' ' << every;
  EXPECT_GT(behind(0.3, 10, false), 3) << "what takes 3 mm for a leap of one tick";
}

/// N: how far the force stays above k times the depth while a hand withdraws at `speed`.
double stays_above(double speed, int every) {
  HandLoopSettings settings;
  settings.safety.ramp_time = 0;
  Bench bench(settings);
  const DeviceTraits traits{.max_force = 12, .mass = 0.2};
  for (int i = 0; i < 2000; ++i)
    bench.tick({.X_FM = at_depth(0.005 * std::min(1.0, i * dt)), .device = traits});
  EXPECT_NEAR(bench.loop.last().wrench.force.z(), 500 * 0.005, 0.01);
  double most = 0, depth = 0.005;
  for (int i = 1; depth > 0; ++i) {
    if (i % every == 0) depth = 0.005 - speed * dt * i;
    HandSample sample{.X_FM = at_depth(depth), .device = traits};
    if (i % every == 0) sample.since = every * dt;
    const double force = bench.tick(sample).wrench.force.z();
    if (depth > 0) most = std::max(most, force - 500 * depth);
  }
  return most;
}

// A wall that pushes a hand that leaves it harder than it held it gives energy. Reference: a wall
// of 500 N/m, and some old rows.
TEST(HandLoopReports, a_hand_that_withdraws_is_not_pushed_by_the_force_of_before) {
  for (const double speed : {0.05, 0.2, 0.5})
    for (const int every : {1, 2, 10}) EXPECT_LT(stays_above(speed, every), 0.3) << speed << every;
}

TEST(HandLoopReports, a_leap_stays_one_however_long_the_device_was_silent) {
  HandLoopSettings settings;
  settings.safety.ramp_time = 0;
  for (const double since : {0.0, 0.001, 0.01, 0.5}) {
    Bench bench(settings);
    const DeviceTraits traits{.max_force = 12, .mass = 0.2};
    for (int i = 0; i < 500; ++i) bench.tick({.X_FM = at_depth(0.001), .device = traits});
    const HandTick& tick = bench.tick({.X_FM = at_depth(0.016), .device = traits, .since = since});
    EXPECT_LT(tick.wrench.force.z(), 0.55) << since;
  }
}

/// N/m in use in a contact, of 50 000 asked for, by a device that is handed over in the first tick
/// and known `late` ticks after that; whether its answer fails once in between.
double held_gains(int late, bool fails) {
  const DeviceTraits traits{.max_force = 3.3, .mass = 0.1, .period = 1e-3};
  Coupling coupling;
  coupling.k = 50000;
  HandLoopBench bench({}, coupling);
  for (int i = 0; i < 100; ++i) bench.tick({.X_FM = at_depth(0.002)});
  HandSample sample{.X_FM = at_depth(0.002)};
  for (int i = 0; i < 500; ++i) {
    sample.changed = i == 0;
    sample.trusted = i >= late;
    if (i >= late) sample.device = traits;
    if (fails && i == 300) sample.X_FM.p.x() = std::numeric_limits<double>::quiet_NaN();
    bench.tick(sample);
    sample.X_FM = at_depth(0.002);
  }
  return bench.loop.last().hand.gains.now.k;
}

// Reference: the same device, known at once. Arms open in a thread of their own.
TEST(HandLoopReports, gains_are_held_for_a_device_that_is_known_late) {
  const double at_once = held_gains(0, false);
  EXPECT_LT(at_once, 10000);
  for (const int late : {1, 3, 50}) EXPECT_EQ(held_gains(late, false), at_once) << late;
  EXPECT_EQ(held_gains(0, true), at_once);
}

}  // namespace
}  // namespace sonde::test
