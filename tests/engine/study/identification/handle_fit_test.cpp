// SPDX-License-Identifier: GPL-3.0-or-later
// Reference: the truth of true_handle.hpp.
#include "engine/study/identification/handle_fit.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/engine/study/identification/plan_along.hpp"
#include "tests/engine/study/identification/true_handle.hpp"

namespace sonde {
namespace {

/// Pulses along x of up to 2 N, for the handle that answers.
PulsePlan plan() { return test::plan_along(0, test::device_of_mass(0.1)); }

TEST(HandleFit, a_steady_force_beside_the_command_is_its_offset) {
  const test::TrueHandle truth{0.1, 0.4, 0.1, 1e-3, 0.0};
  Response response = test::answer(truth, plan(), 0);
  // What hangs on the handle, as if it had been a part of the command.
  for (ResponseSample& s : response)
    if (s.command.force.x() != 0) s.command.force.x() -= 0.05;
  const AxisResponse axis = axis_response(response, 0);
  const HandleFit fit = fit_handle(axis, pulse_windows(axis), 0);
  EXPECT_NEAR(fit.offset, 0.05, 0.05 * 0.05);
  EXPECT_NEAR(fit.inertia.value, 0.1, 0.05 * 0.1);
}

TEST(HandleFit, fewer_than_eight_pulses_are_refused) {
  PulsePlan few = plan();
  few.pulses.resize(7);
  const AxisResponse axis = axis_response(test::answer({}, few, 0), 0);
  EXPECT_THROW(fit_handle(axis, pulse_windows(axis), 3e-5), std::invalid_argument);
}

TEST(HandleFit, more_noise_widens_the_intervals) {
  double before = 0;
  for (const double noise : {0.0, 2e-5, 2e-4}) {
    const AxisResponse axis = axis_response(test::answer({}, plan(), 0, 1, noise), 0);
    const HandleFit fit = fit_handle(axis, pulse_windows(axis), noise == 0 ? 3e-5 : 0);
    EXPECT_GT(fit.damping.high - fit.damping.low, before);
    before = fit.damping.high - fit.damping.low;
  }
}

}  // namespace
}  // namespace sonde
