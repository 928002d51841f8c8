// SPDX-License-Identifier: GPL-3.0-or-later
// References: the limits asked for, and the integration of true_handle.hpp.
#include "engine/study/identification/pulse_plan.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "tests/engine/study/identification/plan_along.hpp"
#include "tests/engine/study/identification/true_handle.hpp"

namespace sonde {
namespace {

using test::device_of_force;

double largest(const std::vector<Wrench>& commands, Vec3 Wrench::*of) {
  double most = 0;
  for (const Wrench& w : commands) most = std::max(most, (w.*of).norm());
  return most;
}

TEST(PulsePlan, stays_within_the_limits_and_half_of_what_the_device_can) {
  const auto usual = commands_of(plan_pulses(device_of_force(), {}, 1e-3));
  EXPECT_DOUBLE_EQ(largest(usual, &Wrench::force), 2);
  EXPECT_DOUBLE_EQ(largest(usual, &Wrench::torque), 0.05);
  const auto weak = commands_of(plan_pulses(device_of_force(3, 0.04), {}, 1e-3));
  EXPECT_DOUBLE_EQ(largest(weak, &Wrench::force), 1.5);
  EXPECT_DOUBLE_EQ(largest(weak, &Wrench::torque), 0.02);
  const auto less =
      commands_of(plan_pulses(device_of_force(), {.force = 0.7, .torque = 0.01}, 1e-3));
  EXPECT_DOUBLE_EQ(largest(less, &Wrench::force), 0.7);
  EXPECT_DOUBLE_EQ(largest(less, &Wrench::torque), 0.01);
}

TEST(PulsePlan, moves_one_axis_at_a_time_and_those_with_motors_alone) {
  for (const double torque : {0.0, 0.3}) {
    const PulsePlan plan = plan_pulses(device_of_force(10, torque), {}, 1e-3);
    std::set<std::size_t> axes;
    for (const Pulse& pulse : plan.pulses) axes.insert(pulse.axis);
    EXPECT_EQ(axes.size(), torque > 0 ? 6u : 3u);
    for (const Wrench& w : commands_of(plan))
      EXPECT_LE((w.force.array() != 0).count() + (w.torque.array() != 0).count(), 1);
  }
}

TEST(PulsePlan, every_pulse_has_a_mean_of_zero_and_an_amplitude_of_its_own) {
  const PulsePlan plan = plan_pulses(device_of_force(), {}, 1e-3);
  std::set<double> sizes;
  double sum = 0;
  for (const Pulse& pulse : plan.pulses)
    if (pulse.axis == 0) {
      PulsePlan one = plan;
      one.pulses = {pulse};
      Vec3 mean = Vec3::Zero();
      for (const Wrench& w : commands_of(one)) mean += w.force;
      EXPECT_NEAR(mean.norm(), 0, 1e-12);
      sizes.insert(std::abs(pulse.amplitude));
      sum += pulse.amplitude > 0 ? 1 : -1;
    }
  EXPECT_EQ(sizes.size(), 16u);
  EXPECT_EQ(sum, 0);
}

TEST(PulsePlan, the_largest_pulse_moves_the_handle_as_far_as_asked_and_back) {
  PulsePlan plan = test::plan_along(0, device_of_force(), {.travel = 0.02});
  plan.pulses.erase(plan.pulses.begin(), plan.pulses.end() - 1);
  double most = 0;
  const Response truth = test::answer({0.1, 0, 0, 0, 0.0}, plan, 0);
  for (const ResponseSample& s : truth) most = std::max(most, std::abs(s.X_BH.p.x()));
  EXPECT_NEAR(most, 0.02, 0.001);  // a part is a whole number of samples
  EXPECT_NEAR(truth.back().X_BH.p.x(), 0, 1e-9);
}

TEST(PulsePlan, its_duration_is_that_of_its_commands) {
  const PulsePlan plan = plan_pulses(device_of_force(), {}, 5e-4);
  EXPECT_DOUBLE_EQ(time_of(plan), 5e-4 * static_cast<double>(commands_of(plan).size()));
}

TEST(PulsePlan, limits_that_are_none_are_refused) {
  EXPECT_THROW(plan_pulses(device_of_force(), {.force = 0}, 1e-3), std::invalid_argument);
  EXPECT_THROW(plan_pulses(device_of_force(), {.torque = -1}, 1e-3), std::invalid_argument);
  EXPECT_THROW(plan_pulses(device_of_force(), {.travel = HUGE_VAL}, 1e-3), std::invalid_argument);
  EXPECT_THROW(plan_pulses(device_of_force(), {}, 0), std::invalid_argument);
}

}  // namespace
}  // namespace sonde
