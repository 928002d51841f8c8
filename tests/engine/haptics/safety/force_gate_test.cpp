// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/safety/force_gate.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "tests/engine/haptics/tick_time.hpp"

namespace sonde {
namespace {

using test::dt;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Wrench push(double force, double torque = 0) {
  Wrench w;
  w.force = Vec3(0, 0, force);
  w.torque = Vec3(torque, 0, 0);
  return w;
}

/// No slew limits, so that the ramp is seen alone.
ForceGate ramp_alone() { return ForceGate({.ramp_time = 0.1, .force_slew = 0, .torque_slew = 0}); }

double pass(ForceGate& gate, double force, Withheld why = Withheld::nothing) {
  return gate.pass(push(force), why, 10, 1, dt).force.z();
}

constexpr std::array all{Withheld::stopped, Withheld::paused,    Withheld::let_go,
                         Withheld::changed, Withheld::untrusted, Withheld::not_finite,
                         Withheld::failed,  Withheld::stalled,   Withheld::shut_down};

TEST(ForceGate, the_force_comes_in_from_zero_in_the_time_of_the_ramp) {
  ForceGate gate = ramp_alone();
  for (int i = 1; i <= 100; ++i) EXPECT_NEAR(pass(gate, 2), 2 * i / 100.0, 1e-12);
  EXPECT_EQ(pass(gate, 2), 2);
  EXPECT_EQ(gate.share(), 1);
}

TEST(ForceGate, the_ramp_waits_for_a_contact) {
  ForceGate gate = ramp_alone();
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(pass(gate, 0), 0);
  EXPECT_NEAR(pass(gate, 2), 0.02, 1e-12);
}

TEST(ForceGate, whatever_withholds_the_force_makes_it_zero_at_once_and_come_in_again) {
  for (const Withheld why : all) {
    ForceGate gate({.ramp_time = 0.1});
    for (int i = 0; i < 200; ++i) pass(gate, 8);
    ASSERT_EQ(pass(gate, 8), 8);
    const Wrench w = gate.pass(push(8, 0.5), why, 10, 1, dt);
    EXPECT_EQ(w.force, Vec3::Zero());
    EXPECT_EQ(w.torque, Vec3::Zero());
    EXPECT_EQ(gate.withheld(), why);
    for (int i = 0; i < 500; ++i) pass(gate, 0);  // free for a while
    EXPECT_NEAR(pass(gate, 8), 0.08, 1e-12);
    EXPECT_EQ(gate.withheld(), Withheld::nothing);
  }
}

// One tick of an answer that has not converged is no reason to let go of a wall.
TEST(ForceGate, an_answer_that_has_not_converged_fades_and_comes_in_again) {
  ForceGate gate({.ramp_time = 0.1, .force_slew = 0, .torque_slew = 0, .fade_time = 0.05});
  for (int i = 0; i < 200; ++i) pass(gate, 8);
  for (int i = 1; i <= 50; ++i) {
    EXPECT_NEAR(pass(gate, 8, Withheld::unsettled), 8 * (1 - i / 50.0), 1e-9);
    EXPECT_EQ(gate.withheld(), Withheld::unsettled);
  }
  EXPECT_NEAR(pass(gate, 8, Withheld::unsettled), 0, 1e-12);
  for (int i = 1; i <= 100; ++i) EXPECT_NEAR(pass(gate, 8), 8 * i / 100.0, 1e-9);
  EXPECT_EQ(gate.withheld(), Withheld::nothing);
  // It stays a gate: what is no number is cut at once, fading or not.
  EXPECT_EQ(pass(gate, nan, Withheld::unsettled), 0);
}

TEST(ForceGate, each_reason_has_words_of_its_own) {
  std::set<std::string> seen;
  for (const Withheld why : all) {
    EXPECT_STRNE(words(why), "");
    EXPECT_TRUE(seen.insert(words(why)).second) << words(why);
  }
  EXPECT_STREQ(words(Withheld::nothing), "");
}

TEST(ForceGate, what_is_not_a_number_never_reaches_the_hand) {
  for (const double bad : {nan, std::numeric_limits<double>::infinity()}) {
    ForceGate gate({.ramp_time = 0});
    pass(gate, 2);
    const Wrench w = gate.pass(push(1, bad), Withheld::nothing, 10, 1, dt);
    EXPECT_EQ(w.force, Vec3::Zero());
    EXPECT_EQ(w.torque, Vec3::Zero());
    EXPECT_EQ(gate.withheld(), Withheld::not_finite);
  }
  ForceGate gate({.ramp_time = 0.1});
  EXPECT_EQ(gate.pass(push(1), Withheld::nothing, 10, 1, nan).force, Vec3::Zero());
}

TEST(ForceGate, force_and_torque_change_no_faster_than_their_slew) {
  ForceGate gate({.ramp_time = 0, .force_slew = 1000, .torque_slew = 20});
  Wrench last;
  int slewed = 0;
  for (int i = 0; i < 100; ++i) {
    const double sign = i / 10 % 2 == 0 ? 1 : -1;
    const Wrench w = gate.pass(push(8 * sign, 0.5 * sign), Withheld::nothing, 10, 1, dt);
    EXPECT_LE((w.force - last.force).norm(), 1000 * dt * (1 + 1e-9));
    EXPECT_LE((w.torque - last.torque).norm(), 20 * dt * (1 + 1e-9));
    slewed += gate.slewed();
    last = w;
  }
  EXPECT_GT(slewed, 50);
  for (int i = 0; i < 100; ++i) last = gate.pass(push(3), Withheld::nothing, 10, 1, dt);
  EXPECT_EQ(last.force, Vec3(0, 0, 3));  // and reaches what is wanted
  EXPECT_FALSE(gate.slewed());
}

TEST(ForceGate, the_limits_of_the_device_hold_last) {
  ForceGate gate({.ramp_time = 0, .force_slew = 0, .torque_slew = 0});
  const Wrench w = gate.pass(push(50, 3), Withheld::nothing, 10, 1, dt);
  EXPECT_NEAR(w.force.norm(), 10, 1e-12);
  EXPECT_NEAR(w.torque.norm(), 1, 1e-12);
  EXPECT_TRUE(w.saturated);
}

TEST(ForceGate, a_tick_that_comes_late_does_not_jump_the_ramp) {
  ForceGate gate({.ramp_time = 0.1, .force_slew = 0, .torque_slew = 0});
  EXPECT_LE(gate.pass(push(8), Withheld::nothing, 10, 1, 5.0).force.norm(), 0.5);
}

TEST(ForceGate, without_a_time_step_nothing_changes) {
  ForceGate gate({.ramp_time = 0.1});
  EXPECT_EQ(gate.pass(push(8), Withheld::nothing, 10, 1, 0).force, Vec3::Zero());
}

}  // namespace
}  // namespace sonde
