// SPDX-License-Identifier: GPL-3.0-or-later
// References: school mechanics (a mass under an even force, F t² / 2m), and the integration of
// true_handle.hpp.
#include "engine/study/identification/handle_residuals.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/study/identification/plan_along.hpp"
#include "tests/engine/study/identification/true_handle.hpp"

namespace sonde {
namespace {

using Eigen::VectorXd;

/// Parameters in units of one.
constexpr HandleScale units{1, 1, 1, 1, 1};

VectorXd parameters(const FreeHandle& handle) {
  VectorXd p(5);
  p << handle.inertia, handle.damping, handle.friction, handle.delay, handle.offset;
  return p;
}

/// 2 N for four samples of a tenth of a second on what moves as 0.5 kg does, 0.01 m aside.
AxisResponse pushed() {
  AxisResponse out;
  for (int k = 0; k < 4; ++k) {
    const double t = 0.1 * k;
    out.times.push_back(t);
    out.commands.push_back(2);
    out.positions.push_back(2 * t * t + 0.01);
  }
  return out;
}
const std::vector<PulseWindow> whole{{.begin = 0, .first = 0, .last = 4, .end = 4, .amplitude = 2}};

TEST(HandleResiduals, are_the_motion_that_is_left_over_its_mean_in_units) {
  const AxisResponse response = pushed();
  const HandleResiduals residuals{
      .response = &response, .windows = &whole, .scale = units, .unit = 0.5};
  const VectorXd none = residuals.at(parameters({.inertia = 0.5}));
  ASSERT_EQ(none.size(), 4);
  EXPECT_LT(none.cwiseAbs().maxCoeff(), 1e-12) << "where it starts is no part of it";
  // Twice the mass goes half as far: t² is left, about its mean of 0.035.
  const VectorXd left = residuals.at(parameters({.inertia = 1}));
  for (Eigen::Index k = 0; k < 4; ++k) {
    const double t = 0.1 * static_cast<double>(k);
    EXPECT_NEAR(left[k], (t * t - 0.035) / 0.5, 1e-12);
  }
  EXPECT_NEAR(motion_rms(response, whole), 2 * std::sqrt(0.0098 / 4 - 0.035 * 0.035), 1e-12);
}

TEST(HandleResiduals, signs_of_what_has_none_do_not_count) {
  const AxisResponse response = pushed();
  const HandleResiduals residuals{
      .response = &response, .windows = &whole, .scale = units, .unit = 1};
  const FreeHandle handle{.inertia = 0.7, .damping = 0.3, .friction = 0.2, .delay = 0.01};
  VectorXd turned = -parameters(handle);
  EXPECT_EQ(residuals.at(turned), residuals.at(parameters(handle)));
  turned[HandleParameter::offset] = 0.5;
  EXPECT_NE(residuals.at(turned), residuals.at(parameters(handle)));
}

TEST(HandleResiduals, a_sample_that_was_not_measured_has_none) {
  AxisResponse response = pushed();
  response.positions[2] = 7;
  response.repeats = {false, false, true, false};
  const HandleResiduals residuals{
      .response = &response, .windows = &whole, .scale = units, .unit = 1};
  const VectorXd left = residuals.at(parameters({.inertia = 0.5}));
  ASSERT_EQ(left.size(), 3);
  EXPECT_LT(left.cwiseAbs().maxCoeff(), 1e-12);
}

TEST(HandleResiduals, a_part_after_a_gap_begins_at_rest) {
  AxisResponse response = pushed();
  response.at_rest = {2};
  const std::vector<double> moved = modelled_motion({.inertia = 0.5}, response);
  const std::vector<double> expected{0, 0.02, 0, 0.02};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(moved[k], expected[k], 1e-12) << k;
}

/// The command of the second half was given half a sample before it was logged.
TEST(HandleResiduals, times_of_commands_are_parameters_with_a_prior) {
  AxisResponse response;
  for (int k = 0; k < 4; ++k) {
    response.times.push_back(0.1 * k);
    response.commands.push_back(k < 2 ? 0 : 2);
    const double pushed_for = std::max(0.0, 0.1 * k - 0.15);
    response.positions.push_back(2 * pushed_for * pushed_for);
  }
  HandleResiduals residuals{.response = &response,
                            .windows = &whole,
                            .scale = units,
                            .unit = 1,
                            .changes = {2},
                            .prior = 3};
  ASSERT_EQ(residuals.inputs(), 6);
  ASSERT_EQ(residuals.values(), 5);
  VectorXd p(6);
  p << parameters({.inertia = 0.5}), 0.5;
  const VectorXd left = residuals.at(p);
  EXPECT_LT(left.head(4).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_DOUBLE_EQ(left[4], 1.5);
  p[5] = 0;
  EXPECT_GT(residuals.at(p).head(4).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(HandleResiduals, the_truth_leaves_less_than_an_integration_errs) {
  const test::TrueHandle truth{.inertia = 0.1, .damping = 0.4, .friction = 0.05, .step = 0};
  const AxisResponse axis =
      axis_response(test::answer(truth, test::plan_along(0, test::device_of_mass(0.1)), 0), 0);
  const std::vector<PulseWindow> windows = pulse_windows(axis);
  const HandleResiduals residuals{
      .response = &axis, .windows = &windows, .scale = units, .unit = motion_rms(axis, windows)};
  const VectorXd left = residuals.at(
      parameters({.inertia = 0.1, .damping = 0.4, .friction = 0.05, .delay = truth.delay}));
  EXPECT_LT(left.cwiseAbs().maxCoeff(), 1e-5);
}

}  // namespace
}  // namespace sonde
