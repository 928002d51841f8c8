// SPDX-License-Identifier: GPL-3.0-or-later
// References: the single axis (sampled_stability.hpp) where axes do not act on each other, which is
// computed from other states; and the simulated device with a spring beside it.
#include "engine/study/stability/contact_stability.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

}  // namespace
}  // namespace sonde
