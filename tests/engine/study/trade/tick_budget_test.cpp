// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/trade/tick_budget.hpp"

#include <gtest/gtest.h>

#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

/// By hand: within 10 % in 100 us, within 1 % in 400 us.
Calibration measured() {
  CalibrationSeries series;
  series.pair = "by hand";
  series.answers = Answers::tick;
  series.points = {{100, {0.1, 0.1}}, {400, {0.01, 0.01}}, {0, {0, 0}}};
  return {{series}};
}

TEST(TickBudget, an_accuracy_replaces_the_time) {
  const auto cube = test::body(test::box({1, 1, 1}));
  const Pair pair(cube, cube);
  const auto time = [&](double accuracy) {
    ServoSettings servo;
    servo.accuracy = accuracy;
    return tick_budget(servo, pair, Method::pdg, measured()).microseconds;
  };
  EXPECT_NEAR(time(0.1), 100, 1e-9);
  EXPECT_NEAR(time(0.01), 400, 1e-9);
  EXPECT_GT(time(0.05), 100);
  EXPECT_LT(time(0.05), 400);
  EXPECT_EQ(time(0.001), 0);  // no time suffices: no limit
}

TEST(TickBudget, without_an_accuracy_the_budget_is_as_given) {
  const auto cube = test::body(test::box({1, 1, 1}));
  ServoSettings servo;
  servo.budget = {.steps = 7, .microseconds = 300};
  const Budget budget = tick_budget(servo, {cube, cube}, Method::pdg, measured());
  EXPECT_EQ(budget.microseconds, 300);
  EXPECT_EQ(budget.steps, 7);
}

}  // namespace
}  // namespace sonde
