// SPDX-License-Identifier: GPL-3.0-or-later
// Reference: the same handle and wall without sampling and delay, in closed form.
#include "engine/study/tuning/wall_hardness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace sonde {
namespace {

SampledAxis fast(double damping) {
  return {.inertia = 0.3, .damping = damping, .virtual_damping = 0, .sample_time = 1e-5};
}

// Without damping x = v sin(ωt)/ω, so that F(t)/(v t) = K sin(ωt)/(ωt).
TEST(WallHardness, of_a_wall_without_sampling_is_that_of_a_mass_on_a_spring) {
  for (const double k : {100.0, 1000.0, 4000.0}) {
    const double turn = std::sqrt(k / 0.3) * 0.01;
    const double right = k * std::sin(turn) / turn;
    EXPECT_NEAR(rate_hardness(fast(0), k) / right, 1, 2e-3) << k;
  }
}

// A handle too heavy to be slowed goes 1 mm in a millisecond. What acts after 10 ms was sampled a
// delay before that, and half a sample more in the mean of all moments at which it meets the wall:
// K (1 − (t_d + T/2)/10 ms), however the delay falls between the samples.
TEST(WallHardness, goes_by_the_delay_and_not_by_where_a_sample_falls) {
  for (const double sample : {1e-3, 4e-4})
    for (const double delay : {0.0, 3e-4, 9.999e-4, 1e-3, 1.001e-3, 2.5e-3}) {
      const SampledAxis heavy{.inertia = 1e3, .damping = 0, .sample_time = sample, .delay = delay};
      const double right = 500 * (1 - (delay + sample / 2) / 0.01);
      EXPECT_NEAR(rate_hardness(heavy, 500) / right, 1, 0.01) << sample << ' ' << delay;
    }
}

TEST(WallHardness, delay_softens_and_damping_hardens) {
  SampledAxis axis = fast(2);
  axis.sample_time = 1e-3;
  const double own = rate_hardness(axis, 1000);
  axis.delay = 2e-3;
  EXPECT_LT(rate_hardness(axis, 1000), 0.9 * own);
  axis.delay = 0;
  axis.virtual_damping = 5;
  EXPECT_GT(rate_hardness(axis, 1000), own);
}

// x = (1 − e^−ζωt (cos ω't + ζω/ω' sin ω't)) of its end, with both springs and both dampings.
TEST(WallHardness, rise_time_is_that_of_the_second_order_step) {
  const AxisHand hand{200, 1};
  for (const double k : {200.0, 1000.0, 4000.0}) {
    const SampledAxis axis = fast(2);
    const double omega = std::sqrt((k + hand.stiffness) / axis.inertia);
    const double decay = (axis.damping + hand.damping) / (2 * axis.inertia);
    const double swing = std::sqrt(omega * omega - decay * decay);
    const auto reached = [&](double share) {
      for (double t = 0;; t += 1e-6)
        if (1 - std::exp(-decay * t) *
                    (std::cos(swing * t) + decay / swing * std::sin(swing * t)) >=
            share)
          return t;
    };
    EXPECT_NEAR(rise_time(axis, k, hand), reached(0.9) - reached(0.1), 5e-5) << k;
  }
}

// Its time constant is the damping over both springs, 10 s: nine tenths take 23.
TEST(WallHardness, a_force_that_hardly_comes_has_no_rise_time) {
  SampledAxis axis = fast(4000);
  axis.sample_time = 1e-3;
  EXPECT_EQ(rise_time(axis, 200, {200, 0}), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace sonde
