// SPDX-License-Identifier: GPL-3.0-or-later
// References: the eigenvalues of the single axis (sampled_stability.hpp), which say how long a
// swing lasts, and the frequency of a mass on a spring.
#include "engine/study/stability/rest.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/study/stability/sampled_stability.hpp"
#include "engine/study/stability/stiffness_sweep.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

constexpr double beyond_any = 1e6;
constexpr SampledAxis free_axis{0.1, 1, 0, 1e-3, 0};

/// A box that only displacements move, pressed on a large one with no hand on it.
ClosedLoopSetup released_box(double k) {
  ClosedLoopSetup out{
      .pair = {test::body(test::box({0.05, 0.05, 0.05})), test::body(test::box({1, 1, 0.2}))}};
  out.coupling.k = k;
  out.coupling.max_force = out.coupling.max_torque = beyond_any;
  out.device.translation = {.inertia = 0.1, .damping = 1, .limit = beyond_any};
  out.device.rotation = {.inertia = 1e3, .damping = 1e5, .limit = beyond_any};
  return out;
}

Press soft_press() {
  Press out{.X_FM = {Quat::Identity(), {0, 0, 0.125 + 1e-6}}, .push = {}};
  out.push.force = {0, 0, -2};
  out.knock = 0.1;  // the swing stays in contact
  return out;
}

RestReport until_rest(double k, const RestPatience& patience = {}) {
  ClosedLoop loop(released_box(k));
  return press_until_rest(loop, soft_press(), patience);
}

TEST(Rest, takes_as_long_as_the_eigenvalues_say) {
  const double K = largest_stable_stiffness(free_axis);
  for (const double share : {0.5, 0.9, 0.97}) {
    const RestReport r = until_rest(share * K);
    EXPECT_TRUE(r.at_rest) << share;
    EXPECT_LE(r.kinetic, 0.1 * 1e-6 / 2) << "mass at 1 mm/s";
    // From what a knock of 0.2 N for 20 ms gives, at most, to that: E falls by ρ² a sample.
    const double begins = std::pow(0.2 * 0.02, 2) / (2 * 0.1);
    const double samples =
        std::log(begins / 5e-8) / (-2 * std::log(spectral_radius(free_axis, share * K)));
    EXPECT_LE(r.time, samples * 1e-3 + 1) << share;
  }
}

// Over two windows such a swing loses what passes for a hold that is stable.
TEST(Rest, is_not_what_swings_on_a_little_less) {
  const double k = 0.93 * largest_stable_stiffness(free_axis);
  ClosedLoop loop(released_box(k));
  const HoldReport held = press_and_hold(loop, soft_press());
  EXPECT_TRUE(comes_to_rest(held));
  EXPECT_GT(held.kinetic, 5e-8) << "it moves";
  EXPECT_FALSE(until_rest(k, {.fades = 0.5, .lasts = 0.5}).at_rest);
}

TEST(Rest, a_swing_that_lasts_is_described) {
  const double k = 1.05 * largest_stable_stiffness(free_axis);
  const RestReport r = until_rest(k);
  EXPECT_FALSE(r.at_rest);
  EXPECT_GT(r.swing, 1e-5);
  EXPECT_NEAR(r.frequency, std::sqrt(k / 0.1) / (2 * std::numbers::pi), 0.25 * r.frequency);
  EXPECT_LT(r.time, 5) << "given up";
}

}  // namespace
}  // namespace sonde
