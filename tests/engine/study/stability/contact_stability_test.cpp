// SPDX-License-Identifier: GPL-3.0-or-later
// References: the single axis (sampled_stability.hpp) where axes do not act on each other, which is
// computed from other states; the simulated device with a spring beside it; and work summed up
// along a cycle.
#include "engine/study/stability/contact_stability.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "engine/study/stability/sampled_stability.hpp"

namespace sonde {
namespace {

SampledContact contact_with_delay(double delay) {
  SampledContact out;
  out.device.translation = {.inertia = 0.1, .damping = 0.5};
  out.device.rotation = {.inertia = 5e-5, .damping = 4e-4};
  out.device.delay = delay;
  return out;
}

TEST(ContactStability, one_axis_is_the_sampled_axis) {
  for (const double delay : {0.0, 4e-4, 1e-3, 2.7e-3})
    for (const double B : {0.0, 1.0}) {
      SampledContact c = contact_with_delay(delay);
      c.stiffness(2, 2) = 1;
      c.damping(2, 2) = B;
      const SampledAxis axis{0.1, 0.5, B, 1e-3, delay};
      EXPECT_NEAR(largest_stable_factor(c) / largest_stable_stiffness(axis), 1, 3e-4) << delay;
      const double passive = largest_passive_stiffness(axis);
      EXPECT_NEAR(largest_passive_factor(c), passive, 2e-4 * passive) << delay;
    }
}

// Reference: what is not a number has no eigenvalues, and nothing is known to be stable.
TEST(ContactStability, what_has_no_eigenvalues_is_stable_at_no_stiffness) {
  SampledContact c = contact_with_delay(1e-3);
  c.stiffness(2, 2) = 1;
  ASSERT_GT(largest_stable_factor(c), 100);
  for (const double none : {double(NAN), double(INFINITY)}) {
    c.stiffness(0, 1) = none;
    EXPECT_EQ(largest_stable_factor(c), 0) << none;
    EXPECT_EQ(largest_stable_factor(c, slowest_buzz), 0) << none;
    EXPECT_EQ(largest_released_factor(c), 0) << none;
    EXPECT_EQ(largest_released_factor_of_any_swing(c), 0) << none;
    EXPECT_EQ(largest_passive_factor_in_translation(c), 0) << none;
    EXPECT_GT(buzz_radius(c), 1) << none;
  }
}

TEST(ContactStability, of_several_axes_the_weakest_counts) {
  SampledContact c = contact_with_delay(1e-3);
  c.stiffness(0, 0) = 1;
  c.stiffness(4, 4) = 2e-3;
  const double turning = largest_stable_stiffness({5e-5, 4e-4, 0, 1e-3, 1e-3}) / 2e-3;
  const double moving = largest_stable_stiffness({0.1, 0.5, 0, 1e-3, 1e-3});
  EXPECT_NEAR(largest_stable_factor(c) / std::min(turning, moving), 1, 3e-4);
  // What is held adds to what is multiplied.
  SampledContact half = contact_with_delay(1e-3);
  half.stiffness(0, 0) = 1;
  half.held_stiffness(0, 0) = moving / 4;
  EXPECT_NEAR(largest_stable_factor(half) / (0.75 * moving), 1, 1e-3);
}

TEST(ContactStability, a_contact_with_a_lever_is_one_axis_along_it) {
  // One row w = (n, r×n): in the mode it moves, a mass of 1/(wᵀM⁻¹w), if dampings go with masses.
  SampledContact c = contact_with_delay(1e-3);
  c.device.rotation.damping = 0.5 / 0.1 * 5e-5;
  Vec6 w;
  w << 0, 0, 1, 0.01, -0.02, 0;
  c.stiffness = w * w.transpose();
  const double per_mass = 1 / 0.1 + (0.01 * 0.01 + 0.02 * 0.02) / 5e-5;
  const SampledAxis axis{1 / per_mass, 5 / per_mass, 0, 1e-3, 1e-3};
  EXPECT_NEAR(largest_stable_factor(c) / largest_stable_stiffness(axis), 1, 3e-4);
}

/// Largest swing of a handle on a spring of stiffness K beside its hand, late over early.
double growth(const SimulatedDeviceParameters& device, double K) {
  SimulatedDevice handle(device, 1e-3);
  handle.reset({Quat::Identity(), Vec3::Zero()});
  double early = 0, late = 0;
  Wrench push;
  push.force.x() = 1;
  for (int i = 0; i < 8000; ++i) {
    Wrench spring;
    spring.force.x() = -K * handle.measured().p.x();
    handle.step(spring, {}, i < 3 ? push : Wrench{});
    double& part = i < 4000 ? early : late;
    if (i >= 2000) part = std::max(part, std::abs(handle.state().X_WD.p.x()));
  }
  return late / early;
}

TEST(ContactStability, a_hand_counts_as_the_simulated_device_has_it) {
  for (const double delay : {0.0, 1e-3, 1.4e-3}) {
    SampledContact c = contact_with_delay(delay);
    c.stiffness(0, 0) = 1;
    c.device.translation.limit = 1e6;
    c.device.translation.hand_stiffness = 200;
    c.device.translation.hand_damping = 1;
    const double K = largest_stable_factor(c);
    EXPECT_LT(growth(c.device, 0.99 * K), 1) << delay;
    EXPECT_GT(growth(c.device, 1.01 * K), 1) << delay;
  }
}

TEST(ContactStability, sliding_away_is_no_buzz) {
  SampledContact c = contact_with_delay(1e-3);
  c.stiffness(0, 0) = -1;
  EXPECT_LE(buzz_radius(c), 1);
  c.stiffness(2, 2) = 1;
  EXPECT_NEAR(largest_stable_factor(c) / largest_stable_stiffness({0.1, 0.5, 0, 1e-3, 1e-3}), 1,
              3e-4);
}

/// One row of contact (n, r×n) at a lever of 2 cm.
SampledContact on_a_lever(double delay) {
  SampledContact c = contact_with_delay(delay);
  Vec6 w;
  w << 0, 0, 1, 0, -0.02, 0;
  c.stiffness = w * w.transpose();
  return c;
}

TEST(ContactStability, what_has_no_motors_is_not_rendered) {
  for (const double delay : {0.0, 1e-3, 1.4e-3}) {
    SampledContact c = on_a_lever(delay);
    const double all_six = largest_stable_factor(c);
    c.device.rotation.limit = 0;
    // The turn moves by itself, and takes no part: one axis of the whole mass.
    const double K = largest_stable_factor(c);
    EXPECT_NEAR(K / largest_stable_stiffness({0.1, 0.5, 0, 1e-3, delay}), 1, 3e-4) << delay;
    EXPECT_GT(K, 1.4 * all_six) << delay;
    c.device.translation.limit = 0;
    EXPECT_EQ(largest_stable_factor(c), INFINITY);
  }
}

/// Largest displacement, late over early, of a device whose motors get the whole wrench of a
/// contact: its own limits say what it renders.
double growth_at(const SampledContact& c, double factor) {
  SimulatedDevice handle(c.device, c.sample_time);
  handle.reset({Quat::Identity(), Vec3::Zero()});
  double early = 0, late = 0;
  Wrench push;
  push.force.z() = 1e-3;
  push.torque.y() = 1e-6;
  for (int i = 0; i < 8000; ++i) {
    const HandleState& state = handle.state();
    Vec6 x;
    x << state.X_WD.p, 2 * state.X_WD.q.vec();  // small
    const Vec6 f = -factor * c.stiffness * x;
    handle.step({f.head<3>(), f.tail<3>()}, {}, i < 3 ? push : Wrench{});
    double& part = i < 4000 ? early : late;
    if (i >= 2000) part = std::max(part, std::abs(state.X_WD.p.z()));
  }
  return late / early;
}

TEST(ContactStability, a_device_without_torque_swings_where_theory_says) {
  for (const double delay : {0.0, 1e-3}) {
    SampledContact c = on_a_lever(delay);
    c.device.translation.limit = 1e6;
    c.device.rotation.limit = 0;
    c.device.translation.hand_stiffness = 200;
    c.device.translation.hand_damping = 1;
    c.device.rotation.hand_stiffness = 0.1;
    c.device.rotation.hand_damping = 5e-4;
    const double K = largest_stable_factor(c);
    EXPECT_LT(growth_at(c, 0.99 * K), 1) << delay;
    EXPECT_GT(growth_at(c, 1.01 * K), 1) << delay;
  }
}

/// J that the wall gives whoever draws the handle slowly round a rectangle: turned about y, then
/// along z, and back in the same order.
double work_of_cycle(const SampledContact& c, double way, double turn) {
  constexpr int steps = 1000;
  Vec6 x = Vec6::Zero();
  double work = 0;
  const Vec6 along = Vec6::Unit(2) * way, about = Vec6::Unit(4) * turn;
  for (const Vec6& side : {about, along, Vec6(-about), Vec6(-along)})
    for (int i = 0; i < steps; ++i) {
      const Vec6 middle = x + side / (2 * steps);
      Vec6 f = -c.stiffness * middle;
      if (c.device.rotation.limit == 0) f.tail<3>().setZero();
      work += f.dot(side) / steps;
      x += side / steps;
    }
  return work;
}

TEST(ContactStability, a_force_without_its_torque_is_not_passive) {
  SampledContact c = on_a_lever(1e-3);
  c.stiffness *= 681;
  EXPECT_NEAR(work_of_cycle(c, 1e-3, 0.1), 0, 1e-12);
  EXPECT_EQ(cycle_lever(c), 0);
  EXPECT_GT(largest_passive_factor(c), 0);
  c.device.rotation.limit = 0;
  EXPECT_EQ(largest_passive_factor(c), 0);
  // 681 N/m at 2 cm, 1 mm and 0.1 rad: the way is there and back, the turn half of it to each side.
  EXPECT_NEAR(work_of_cycle(c, 1e-3, 0.1), 681 * 0.02 * 1e-3 * 0.1, 1e-9);
  EXPECT_NEAR(cycle_lever(c) * 0.05 * 2e-3, work_of_cycle(c, 1e-3, 0.1), 1e-9);
  // With the turn held, it is the wall of one axis.
  EXPECT_NEAR(largest_passive_factor_in_translation(c) * 681,
              largest_passive_stiffness({0.1, 0.5, 0, 1e-3, 1e-3}), 0.1);
}

TEST(ContactStability, springs_that_are_no_gradient_are_not_passive_either) {
  // The classic coupling: a turn moves the force, a displacement the torque, by different gains.
  SampledContact c = on_a_lever(1e-3);
  c.stiffness.bottomRows<3>() *= 3;
  EXPECT_NEAR(cycle_lever(c), 2 * 0.02, 1e-12);
  EXPECT_EQ(largest_passive_factor(c), 0);
  // Of a gradient, differences that are not symmetric are an error of the differences.
  c.gradient = true;
  EXPECT_EQ(cycle_lever(c), 0);
  EXPECT_GT(largest_passive_factor(c), 0);
}

// Reference: the single axis without a hand; and a contact in which a handle drifts away.
TEST(ContactStability, a_hand_that_lets_go_leaves_the_device_alone) {
  SampledContact c = contact_with_delay(1e-3);
  c.stiffness(2, 2) = 1;
  c.device.translation.hand_stiffness = 200;
  c.device.translation.hand_damping = 1;
  const double alone = largest_stable_stiffness({0.1, 0.5, 0, 1e-3, 1e-3});
  EXPECT_NEAR(largest_released_factor(c) / alone, 1, 3e-4);
  EXPECT_GT(largest_stable_factor(c), 2 * alone);
  // A flutter of the free directions, too slow to buzz: a curl of 0.5 % of the stiffness. It grows.
  c.stiffness(0, 0) = c.stiffness(1, 1) = 1e-3;
  c.stiffness(0, 1) = 5e-3;
  c.stiffness(1, 0) = -5e-3;
  EXPECT_NEAR(largest_released_factor(c) / alone, 1, 3e-4);
  EXPECT_LT(largest_released_factor_of_any_swing(c), 0.5 * alone);
}

/// A force with a curl on a handle m, d that no hand holds, F times of it: with z = x + iy,
///
///     m z̈ + d ż + F (k − ic) z = 0,   k = mω²,   c = dω,
///
/// which swings for ever at ω for F = 1. More of it grows.
struct Whirl {
  double omega = 0;
  double mass = 0.1, damping = 0.5, sample_time = 1e-4;

  /// The signal is Re exp(st): of the two, the root that swings. Exact also for a sampled force.
  std::complex<double> s(double F) const {
    const std::complex<double> K = F * std::complex(mass * omega * omega, -damping * omega);
    const double e = std::exp(-damping * sample_time / mass), way = (1 - e) * mass / damping;
    const std::complex<double> trace = 1 + e - K * (sample_time - way) / damping;
    const std::complex<double> det =
        e * (1.0 - K * (sample_time - way) / damping) + way * K * (1 - e) / damping;
    const std::complex<double> root = std::sqrt(trace * trace / 4.0 - det);
    const std::complex<double> one = std::log(trace / 2.0 + root) / sample_time;
    const std::complex<double> other = std::log(trace / 2.0 - root) / sample_time;
    return one.real() > other.real() ? one : other;
  }
  /// The least F at which it grows at this rate, 1/s.
  double limit(double rate) const {
    double low = 0.5, high = 2;
    for (int i = 0; i < 50; ++i) {
      const double middle = (low + high) / 2;
      (s(middle).real() < rate ? low : high) = middle;
    }
    return low;
  }
  SampledContact held_by_a_hand() const {
    SampledContact out;
    out.device.translation = {.inertia = mass, .damping = damping};
    out.device.translation.hand_stiffness = 200;
    out.device.translation.hand_damping = 1;
    out.device.rotation = {.inertia = 5e-5, .damping = 4e-4};
    out.sample_time = sample_time;
    out.stiffness(0, 0) = out.stiffness(1, 1) = mass * omega * omega;
    out.stiffness(0, 1) = damping * omega;
    out.stiffness(1, 0) = -damping * omega;
    return out;
  }
};

/// Largest of Re exp(st), late over early.
double growth_of_signal(std::complex<double> s) {
  double early = 0, late = 0;
  for (int i = 0; i < 4000; ++i) {
    const double size = std::abs(std::exp(s * (i * 1e-3)).real());
    double& part = i < 2000 ? early : late;
    part = std::max(part, size);
  }
  return late / early;
}

// Reference: the closed form of a swing that grows, at 1, 3 and 8 Hz.
TEST(ContactStability, a_swing_that_grows_is_unstable_at_any_frequency) {
  for (const double hertz : {1.0, 3.0, 8.0}) {
    const Whirl whirl{.omega = 2 * std::numbers::pi * hertz};
    // A slow one counts that doubles within a minute; a buzz, if it grows at all (but for
    // rounding).
    const bool buzzes = hertz > slowest_buzz;
    const double limit = whirl.limit(buzzes ? 1e-7 / whirl.sample_time : std::log(2.0) / 60);
    EXPECT_NEAR(std::abs(whirl.s(limit).imag()) / whirl.omega, 1, 0.05);
    EXPECT_LT(growth_of_signal(whirl.s(0.95 * limit)), 1);
    EXPECT_GT(growth_of_signal(whirl.s(1.05 * limit)), 1);
    const SampledContact contact = whirl.held_by_a_hand();
    EXPECT_NEAR(largest_released_factor_of_any_swing(contact) / limit, 1, 3e-4) << hertz;
    if (buzzes)
      EXPECT_NEAR(largest_released_factor(contact) / limit, 1, 3e-4);
    else
      EXPECT_GT(largest_released_factor(contact), 1.5 * limit) << "too slow to buzz: " << hertz;
  }
}

// Two directions in which a handle slides away all but equally fast, with next to no curl.
TEST(ContactStability, sliding_away_on_a_bent_way_is_no_swing) {
  SampledContact c = contact_with_delay(1e-3);
  c.stiffness(2, 2) = 1;
  c.stiffness(0, 0) = c.stiffness(1, 1) = -1e-2;
  c.stiffness(0, 1) = 1e-4;
  c.stiffness(1, 0) = -1e-4;
  EXPECT_NEAR(largest_released_factor_of_any_swing(c) / largest_released_factor(c), 1, 1e-9);
}

}  // namespace
}  // namespace sonde
