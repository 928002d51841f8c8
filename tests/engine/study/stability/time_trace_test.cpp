// SPDX-License-Identifier: GPL-3.0-or-later
// References: the closed form of a second-order system's step response, and statics.
#include "engine/study/stability/time_trace.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

constexpr double sample_time = 1e-3;

/// 1 − e^(−ζωt) (cos ω_d t + ζω/ω_d sin ω_d t).
std::vector<double> step_response(double omega, double zeta) {
  const double damped = omega * std::sqrt(1 - zeta * zeta);
  std::vector<double> out;
  for (int i = 0; i < 4000; ++i) {
    const double t = i * sample_time;
    out.push_back(1 - std::exp(-zeta * omega * t) *
                          (std::cos(damped * t) + zeta * omega / damped * std::sin(damped * t)));
  }
  return out;
}

/// The envelope e^(−ζωt)/√(1 − ζ²) bounds it, and is reached to within half a swing.
TEST(SettlingTime, of_a_swing_lies_below_its_envelope_by_half_a_swing_at_most) {
  for (const double zeta : {0.05, 0.1, 0.3}) {
    const double omega = 40, band = 0.05;
    const double envelope = -std::log(band * std::sqrt(1 - zeta * zeta)) / (zeta * omega);
    const auto settled = settling_time(step_response(omega, zeta), sample_time, 1, band);
    ASSERT_TRUE(settled);
    EXPECT_LE(*settled, envelope + sample_time);
    EXPECT_GE(*settled,
              envelope - std::numbers::pi / (omega * std::sqrt(1 - zeta * zeta)) - sample_time);
  }
}

TEST(SettlingTime, of_what_never_moves_is_none_and_of_what_never_stays_there_is_none) {
  EXPECT_EQ(settling_time(std::vector<double>(10, 2.0), sample_time, 2, 0.05), 0);
  EXPECT_FALSE(settling_time(std::vector<double>{2, 2, 2, 3}, sample_time, 2, 0.05));
  EXPECT_NEAR(*settling_time(std::vector<double>{0, 1, 2, 2}, sample_time, 2, 0.05),
              2 * sample_time, 1e-12);
}

/// A block on a large one, on an ideal device in a hand with a spring and a damper.
ClosedLoopSetup pressed_block(double k) {
  ClosedLoopSetup setup{
      .pair = {test::body(test::box({0.04, 0.04, 0.04})), test::body(test::box({0.2, 0.2, 0.1}))}};
  setup.coupling.k = k;
  setup.coupling.max_force = 100;
  setup.coupling.max_torque = 100;
  setup.device.translation = {.inertia = 0.3, .hand_stiffness = 200, .hand_damping = 20};
  setup.device.rotation = {.inertia = 1e-3, .hand_stiffness = 2, .hand_damping = 0.1};
  setup.device.translation.limit = setup.device.rotation.limit = 100;
  return setup;
}
const Pose on_top{Quat::Identity(), {0.003, 0.002, 0.0701}};

/// At rest the motors and the hand's spring bear the push: d = F/(k + k_h) beyond the 0.1 mm that
/// the block begins above the face, where k of the object norm is that of a pure translation.
TEST(Trace, ends_at_the_balance_of_forces) {
  const double k = 500, push = 3, gap = 1e-4;
  ClosedLoop loop(pressed_block(k));
  const CoursePlace place = course_place(on_top, {{0, 0, -push}, Vec3::Zero()}, 0.035);
  for (const HandCourse course : {HandCourse::step, HandCourse::ramp}) {
    const TimeTrace found = trace(loop, course, place);
    ASSERT_EQ(found.samples.size(), 1200u);
    const double depth = (push - 200 * gap) / (k + 200);
    EXPECT_NEAR(found.samples.back().depth, depth, 2e-2 * depth) << name_of(course);
    EXPECT_NEAR(found.figures.force, k * depth, 2e-2 * k * depth);
    ASSERT_TRUE(found.figures.settling_time);
    EXPECT_LT(*found.figures.settling_time, 0.4);
    EXPECT_EQ(found.figures.failures, 0);
    EXPECT_LT(found.figures.energy, 0);  // the spring holds what the hand gave
    EXPECT_EQ(found.figures.chatter, 0);
  }
}

/// Far beyond k = 2b/T a sampled wall swings without end: theory, devices.md.
TEST(Trace, beyond_stability_nothing_settles) {
  ClosedLoopSetup setup = pressed_block(90'000);
  setup.device.translation.hand_damping = 1;
  ClosedLoop loop(setup);
  const TimeTrace found =
      trace(loop, HandCourse::step, course_place(on_top, {{0, 0, -3}, Vec3::Zero()}, 0.035));
  EXPECT_FALSE(found.figures.settling_time);
  EXPECT_GT(found.figures.overshoot, 1);
  EXPECT_EQ(found.figures.chatter, 0) << "it is thrown out of the contact: another fault";
}

TEST(Trace, the_same_again_gives_the_same_bits) {
  ClosedLoop one(pressed_block(400)), other(pressed_block(400));
  const CoursePlace place = course_place(on_top, {{0, 0, -2}, Vec3::Zero()}, 0.035);
  trace(one, HandCourse::reversal, place);
  const TimeTrace a = trace(one, HandCourse::slide, place),
                  b = trace(other, HandCourse::slide, place);
  for (std::size_t i = 0; i < a.samples.size(); ++i) {
    ASSERT_EQ(a.samples[i].motors.force, b.samples[i].motors.force);
    ASSERT_EQ(a.samples[i].depth, b.samples[i].depth);
  }
}

}  // namespace
}  // namespace sonde
