// SPDX-License-Identifier: GPL-3.0-or-later
// The reference is classic_wrench with the difference of two separations. (The loop in step is
// tested on whole paths: haptic_loop_test.cpp.)
#include "engine/haptics/coupling/coupler.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/engine/haptics/tick_time.hpp"

namespace sonde {
namespace {

using test::dt;

Separation pushed_out(double depth) {
  Separation s;
  s.status = Status::penetrating;
  s.device.p = Vec3(0, 0, -depth);
  s.depth = depth;
  return s;
}

Coupling damped_in_translation() {
  Coupling c;
  c.mode = Coupling::Mode::classic;
  c.k_t = 100;
  c.b_t = 2;
  c.max_force = 1e9;
  return c;
}

double force_z(Coupler& coupler, const Separation& s, double step = dt) {
  return coupler.wrench(s, step).force.z();
}

TEST(Coupler, damps_the_separation_by_its_backward_difference) {
  Coupler coupler(MassProperties{}, damped_in_translation());
  EXPECT_NEAR(force_z(coupler, pushed_out(0.001)), 0.1, 1e-12);
  EXPECT_NEAR(force_z(coupler, pushed_out(0.003)), 0.3 + 2 * 0.002 / dt, 1e-9);
  EXPECT_NEAR(force_z(coupler, pushed_out(0.002)), 0.2 - 2 * 0.001 / dt, 1e-9);
}

// Many ticks of lag may be caught up in one: the rate would not be the hand's.
TEST(Coupler, the_classic_mode_does_not_damp_what_only_catches_up) {
  Coupler coupler(MassProperties{}, damped_in_translation());
  force_z(coupler, pushed_out(0.003));
  Separation lagged = pushed_out(0.001);
  lagged.jumped = lagged.lagged = true;
  EXPECT_NEAR(force_z(coupler, lagged), 0.1, 1e-12);
}

TEST(Coupler, does_not_damp_across_a_jump_a_failure_or_a_gap) {
  Coupler coupler(MassProperties{}, damped_in_translation());
  force_z(coupler, pushed_out(0.001));
  Separation jumped = pushed_out(0.003);
  jumped.jumped = true;
  EXPECT_NEAR(force_z(coupler, jumped), 0.3, 1e-12);
  EXPECT_EQ(force_z(coupler, Separation{}), 0);  // failed
  EXPECT_NEAR(force_z(coupler, pushed_out(0.002)), 0.2, 1e-12);
  coupler.forget();
  EXPECT_NEAR(force_z(coupler, pushed_out(0.001)), 0.1, 1e-12);
  EXPECT_NEAR(force_z(coupler, pushed_out(0.002), 0), 0.2, 1e-12);
}

// About z by nearly half a turn, as the probe is pushed out: by the springs alone where it passes
// half a turn, since no motion made the rotation vector start again from the other side.
TEST(Coupler, does_not_damp_a_turn_that_passes_half_a_turn) {
  Coupling c;
  c.mode = Coupling::Mode::classic;
  c.k_r = 1;
  c.b_r = 0.5;
  c.max_force = c.max_torque = 1e9;
  Coupler coupler(MassProperties{}, c);
  const auto torque_z = [&](double turn) {
    Separation s = pushed_out(0.001);
    s.separated.q = Quat(Eigen::AngleAxisd(turn, Vec3::UnitZ()));
    return coupler.wrench(s, dt).torque.z();
  };
  const double pi = std::numbers::pi;
  EXPECT_NEAR(torque_z(pi - 0.02), pi - 0.02, 1e-9);
  EXPECT_NEAR(torque_z(pi - 0.01), pi - 0.01 + 0.5 * 0.01 / dt, 1e-6);
  EXPECT_NEAR(torque_z(pi + 0.01), -(pi - 0.01), 1e-9);
  EXPECT_NEAR(torque_z(pi + 0.02), -(pi - 0.02) + 0.5 * 0.01 / dt, 1e-6);
  // A change of 0.9 π is a turn, however fast; one of 1.1 π is the shorter one the other way round.
  torque_z(-0.4 * pi);
  EXPECT_NEAR(torque_z(0.5 * pi), 0.5 * pi + 0.5 * 0.9 * pi / dt, 1e-6);
  EXPECT_NEAR(torque_z(-0.6 * pi), -0.6 * pi, 1e-9);
}

TEST(Coupler, from_one_mode_to_another_the_wrench_is_of_both) {
  Coupling object;
  object.k = 500;
  object.max_force = 1e9;
  Coupler coupler(MassProperties{}, object);
  EXPECT_NEAR(force_z(coupler, pushed_out(0.002)), 1, 1e-12);
  coupler.set_coupling({.now = damped_in_translation(), .before = object, .share = 0.25});
  EXPECT_NEAR(force_z(coupler, pushed_out(0.002)), 0.75 * 1 + 0.25 * 0.2, 1e-12);
  coupler.set_coupling(damped_in_translation());
  EXPECT_NEAR(force_z(coupler, pushed_out(0.002)), 0.2, 1e-12);
}

TEST(Coupler, keeps_within_the_limits_of_the_coupling) {
  Coupling c = damped_in_translation();
  c.max_force = 0.05;
  Coupler coupler(MassProperties{}, c);
  const Wrench w = coupler.wrench(pushed_out(0.001), dt);
  EXPECT_NEAR(w.force.norm(), 0.05, 1e-12);
  EXPECT_TRUE(w.saturated);
}

}  // namespace
}  // namespace sonde
