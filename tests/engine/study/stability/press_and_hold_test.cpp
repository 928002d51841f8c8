// SPDX-License-Identifier: GPL-3.0-or-later
// References: what a hand, a spring and a wall do at rest, and limits that are known to be reached.
#include "engine/study/stability/press_and_hold.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "engine/study/stability/sampled_stability.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

constexpr double no_motors = 1e6;

ClosedLoopSetup box_on_wall(double k) {
  ClosedLoopSetup out{
      .pair = {test::body(test::box({0.05, 0.05, 0.05})), test::body(test::box({1, 1, 0.2}))}};
  out.coupling.k = k;
  out.coupling.max_force = out.coupling.max_torque = no_motors;
  out.device.translation = {.inertia = 0.1, .damping = 1, .limit = no_motors};
  out.device.rotation = {.inertia = 1e3, .damping = 1e5, .limit = no_motors};
  return out;
}

Press press(double force) {
  Press out;
  out.X_FM = {Quat::Identity(), {0, 0, 0.125 + 1e-6}};
  out.push.force = {0, 0, -force};
  return out;
}

HoldReport report(const ClosedLoopSetup& setup, const Press& press) {
  ClosedLoop loop(setup);
  return press_and_hold(loop, press);
}

TEST(PressAndHold, a_quiet_hold_is_described_as_it_is) {
  ClosedLoopSetup s = box_on_wall(500);
  s.device.translation.damping = 20;  // it settles within the hold
  const HoldReport r = report(s, press(2));
  EXPECT_TRUE(r.stable);
  EXPECT_FALSE(r.chattering);
  EXPECT_FALSE(r.saturated);
  EXPECT_NEAR(r.depth, 2.0 / 500, 2e-5);
  EXPECT_NEAR(r.force, 2, 0.01);
  EXPECT_NEAR(r.torque, 0, 1e-5);
  EXPECT_EQ(r.contact, 1);
  EXPECT_EQ(r.growth, 0);
  EXPECT_LT(r.force_error, 0.02);
  EXPECT_EQ(r.jumps, 0);
  EXPECT_EQ(r.pop_throughs, 0);
  EXPECT_EQ(r.failures, 0);
}

// Reference: the whole hold.
TEST(PressAndHold, that_ends_as_soon_as_its_outcome_is_certain_has_the_same_outcome) {
  const double K = largest_stable_stiffness({0.1, 1, 0, 1e-3, 0});
  int lost = 0;
  for (const double times : {0.3, 0.9, 0.97, 1.02, 1.1, 2.0, 8.0})
    for (const double knock : {0.1, 1.0, 4.0}) {
      Press light = press(2);
      light.knock = knock;
      const HoldReport whole = report(box_on_wall(times * K), light);
      ClosedLoop loop(box_on_wall(times * K));
      const HoldReport ended = press_and_hold(loop, light, HoldQuestion::outcome);
      SCOPED_TRACE(std::to_string(times) + ' ' + std::to_string(knock));
      EXPECT_EQ(ended.stable, whole.stable);
      EXPECT_EQ(ended.growth < light.decay, whole.growth < light.decay);
      EXPECT_LE(ended.growth, whole.growth);
      if (whole.stable) {
        EXPECT_EQ(ended.growth, whole.growth);
      }
      lost += !whole.stable;
    }
  EXPECT_GT(lost, 5);
}

TEST(PressAndHold, beyond_the_eigenvalues_it_grows_and_the_motors_give_energy) {
  const double K = largest_stable_stiffness({0.1, 1, 0, 1e-3, 0});
  Press light = press(2);
  light.knock = 0.1;  // the swing stays in contact
  const HoldReport below = report(box_on_wall(0.7 * K), light);
  const HoldReport above = report(box_on_wall(1.3 * K), light);
  EXPECT_TRUE(below.stable);
  EXPECT_LT(below.growth, 0.95);
  EXPECT_FALSE(above.stable);
  EXPECT_GT(above.growth, 0.95);
  EXPECT_GT(above.work, 0);
  EXPECT_GT(above.kinetic, 10 * below.kinetic);
}

// Damping that is asked for is no error. Reference: motors without delay give what is commanded,
// and a delay of n ticks is off by what changes in them.
TEST(PressAndHold, a_damper_that_is_commanded_is_faithful) {
  ClosedLoopSetup s = box_on_wall(0);
  s.coupling.mode = Coupling::Mode::classic;
  s.coupling.k_t = 500;
  s.coupling.k_r = 1;
  s.coupling.b_t = 10;
  Press hard = press(2);
  hard.knock = 4;
  const HoldReport r = report(s, hard);
  EXPECT_TRUE(r.stable);
  EXPECT_LT(r.force_error, 1e-3);
  s.device.delay = 3e-3;
  EXPECT_GT(report(s, hard).force_error, 0.02);
}

TEST(PressAndHold, limits_that_are_reached_are_seen) {
  ClosedLoopSetup s = box_on_wall(500);
  s.coupling.max_force = 1.9;  // less than the hand pushes: the probe sinks in
  const HoldReport r = report(s, press(2));
  EXPECT_TRUE(r.saturated);
  EXPECT_GT(r.saturation, 0.9);
  EXPECT_NEAR(r.force, 1.9, 1e-9);
  EXPECT_GT(r.force_error, 0.05);
}

TEST(PressAndHold, without_contact_nothing_is_held) {
  const HoldReport r = report(box_on_wall(500), press(-2));
  EXPECT_EQ(r.contact, 0);
  EXPECT_FALSE(r.stable);
  EXPECT_EQ(r.force, 0);
  EXPECT_EQ(r.chatter, 0);
}

TEST(PressAndHold, any_stiffness_gives_an_honest_report) {
  for (const double k : {1e-3, 1e12}) {
    ClosedLoopSetup s = box_on_wall(k);
    s.coupling.max_force = s.device.translation.limit = 12;
    const HoldReport r = report(s, press(2));
    for (const double x : {r.growth, r.kinetic, r.work, r.chatter, r.depth, r.force})
      EXPECT_TRUE(std::isfinite(x)) << k;
    if (k > 1) {
      EXPECT_FALSE(r.stable && !r.saturated && !r.chattering);
    }
  }
}

TEST(PressAndHold, takes_the_ticks_that_it_says) {
  EXPECT_EQ(tick_count({}, 1e-3), 100 + 100 + 20 + 100 + 2 * 300);
}

}  // namespace
}  // namespace sonde
