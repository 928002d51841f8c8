// SPDX-License-Identifier: GPL-3.0-or-later
// References: the integration of true_handle.hpp, and closed forms of school mechanics.
#include "engine/study/identification/free_handle.hpp"

#include <gtest/gtest.h>

#include "tests/engine/study/identification/true_handle.hpp"

namespace sonde {
namespace {

struct Case {
  double inertia, damping, friction, delay;
};
constexpr Case cases[] = {{0.1, 0, 0, 0},          {0.1, 0.4, 0.05, 1e-3}, {0.3, 4, 0.4, 0},
                          {0.05, 0.2, 0.25, 3e-3}, {1, 0.01, 0.6, 2.5e-3}, {0.02, 5, 0.01, 0.0204}};

TEST(FreeHandle, moves_as_an_integration_in_small_steps_does) {
  PulsePlan plan;
  for (const double amplitude : {0.5, -1.0, 2.0}) plan.pulses.push_back({0, amplitude, 20});
  for (const Case& c : cases) {
    const Response truth = test::answer({c.inertia, c.damping, c.friction, c.delay, 0.0}, plan, 0);
    std::vector<double> times, commands;
    for (const ResponseSample& s : truth) {
      times.push_back(s.t);
      commands.push_back(s.command.force.x());
    }
    const FreeHandle handle{c.inertia, c.damping, c.friction, c.delay};
    const std::vector<double> modelled = free_motion(handle, times, commands);
    double most = 0;
    for (const double x : modelled) most = std::max(most, std::abs(x));
    ASSERT_GT(most, 0);
    for (std::size_t i = 0; i < truth.size(); ++i)
      ASSERT_NEAR(modelled[i], truth[i].X_BH.p.x(), 1e-6 * most) << c.inertia << " at " << i;
  }
}

TEST(FreeHandle, a_constant_force_accelerates_evenly_and_an_offset_is_such_a_force) {
  const std::vector<double> times{0, 0.1, 0.25, 1}, two(4, 2.0), none(4, 0.0);
  const std::vector<double> pushed = free_motion({.inertia = 0.5, .friction = 0.5}, times, two);
  const std::vector<double> hung = free_motion({.inertia = 0.5, .offset = 1.5}, times, none);
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_NEAR(pushed[i], 1.5 * times[i] * times[i], 1e-12);
    EXPECT_NEAR(hung[i], 1.5 * times[i] * times[i], 1e-12);
  }
}

TEST(FreeHandle, friction_holds_what_does_not_exceed_it) {
  const std::vector<double> times{0, 0.1, 0.2}, force(3, 0.3);
  for (const double x : free_motion({.friction = 0.3}, times, force)) EXPECT_EQ(x, 0);
  EXPECT_GT(free_motion({.friction = 0.299}, times, force).back(), 0);
}

}  // namespace
}  // namespace sonde
