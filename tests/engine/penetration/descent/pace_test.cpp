// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/descent/pace.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/penetration/descent/descent_tuning.hpp"

namespace sonde {
namespace {

/// Over an edge at x = 0, what is wanted is towards it, and proportional to the distance.
Vec6 wanted_at(double x) { return -2.5 * x * Vec6::Unit(3); }

// Reference: the root of a linear function, which one secant step finds.
TEST(Pace, steps_that_undo_each_other_end_where_the_wanted_step_vanishes) {
  Pace pace;
  double x = 0.2;
  for (int i = 0; i < 2; ++i) {
    const Vec6 step = pace.damped(wanted_at(x));
    pace.learn(step, {.free_until = 1}, 1e-9, 1);
    x += step[3];
  }
  EXPECT_NEAR(x, 0, 1e-15);
}

TEST(Pace, steps_that_go_on_are_not_damped) {
  Pace pace;
  for (int i = 0; i < 5; ++i) {
    const Vec6 step = 0.1 * Vec6::Unit(2);
    EXPECT_EQ(pace.damped(step), step);
    pace.learn(step, {.free_until = 1}, 1e-9, 1);
  }
}

/// Along d, each step the same part of the one before.
Vec6 in_series(double first, double ratio, int k) {
  return first * std::pow(ratio, k) * Vec6::Unit(4);
}

/// What the pace makes of the last of so many steps of a series, from y on.
std::optional<Vec6> after_series(Pace& pace, double first, double ratio, int count, const Vec6& y,
                                 double most = 1e3) {
  std::optional<Vec6> out;
  for (int k = 0; k < count; ++k) {
    const Vec6 step = pace.damped(in_series(first, ratio, k));
    out = pace.extrapolated(y, step, most);
    pace.learn(step, {.free_until = 1}, 1e-9, 1);
  }
  return out;
}

// Reference: the sum of a geometric series.
TEST(Pace, steps_that_shrink_alike_are_summed_up) {
  const Vec6 far = Vec6(-10 * Vec6::Unit(4));
  for (const double ratio : {0.4, 0.9, 0.98}) {
    Pace pace;
    const std::optional<Vec6> sum = after_series(pace, 1e-3, ratio, 3, far);
    ASSERT_TRUE(sum) << ratio;
    const Vec6 want = in_series(1e-3, ratio, 2) / (1 - ratio);
    EXPECT_NEAR((*sum - want).norm(), 0, 1e-9 * want.norm()) << ratio;
    Pace too_few;
    EXPECT_FALSE(after_series(too_few, 1e-3, ratio, 2, far)) << ratio;
  }
}

TEST(Pace, a_sum_does_not_rise_above_the_ceiling) {
  Vec6 y = Vec6::Zero();
  y[0] = 1, y[4] = -1e-3;
  Pace pace;
  pace.ceiling = y.norm() + 1e-7;
  const std::optional<Vec6> sum = after_series(pace, 1e-3, 0.99, 3, y);
  ASSERT_TRUE(sum);
  EXPECT_NEAR((y + *sum).norm(), pace.ceiling, 1e-12);
  EXPECT_LT(sum->norm(), 10e-3);
}

TEST(Pace, a_sum_is_no_longer_than_may_be_swept) {
  Pace pace;
  const Vec6 far = Vec6(-10 * Vec6::Unit(4));
  const std::optional<Vec6> sum = after_series(pace, 1e-3, 0.99, 3, far, 4);
  ASSERT_TRUE(sum);
  EXPECT_NEAR((*sum - 4 * in_series(1e-3, 0.99, 2)).norm(), 0, 1e-12);
  Pace short_way;
  EXPECT_FALSE(after_series(short_way, 1e-3, 0.99, 3, far, 1)) << "not worth a look";
  Pace alike;
  EXPECT_FALSE(after_series(alike, 1e-3, 1, 3, far, std::numeric_limits<double>::infinity()))
      << "steps that neither grow nor shrink have no sum";
}

TEST(Pace, what_is_no_series_is_not_summed_up) {
  const Vec6 far = Vec6(-10 * Vec6::Unit(4));
  Pace uneven;
  for (const double length : {1.0, 0.9, 0.5, 0.45, 0.3}) {
    const Vec6 step = uneven.damped(length * Vec6::Unit(4));
    EXPECT_FALSE(uneven.extrapolated(far, step, 1e3)) << length;
    uneven.learn(step, {.free_until = 1}, 1e-9, 1);
  }
  // Steps along which |y| rises, which regain gaps.
  Pace rising;
  EXPECT_FALSE(after_series(rising, 1e-3, 0.9, 6, -far));
}

TEST(Pace, a_sum_that_was_too_long_ends_the_series) {
  const Vec6 far = Vec6(-10 * Vec6::Unit(4));
  Pace pace;
  const std::optional<Vec6> sum = after_series(pace, 1e-3, 0.9, 3, far);
  ASSERT_TRUE(sum);
  pace.extrapolates = true;
  pace.learn(*sum, {.free_until = 1}, 1e-9, 1);
  const Vec6 back = pace.damped(-1e-4 * Vec6::Unit(4));
  EXPECT_FALSE(pace.extrapolated(far, back, 1e3));
  EXPECT_FALSE(pace.in_series);
  // And another begins with three steps.
  pace.extrapolates = false;
  pace.learn(back, {.free_until = 1}, 1e-9, 1);
  for (const double length : {0.9e-4, 0.81e-4}) {
    const Vec6 step = pace.damped(-length * Vec6::Unit(4));
    EXPECT_EQ(pace.extrapolated(-far, step, 1e3).has_value(), length < 0.85e-4) << length;
    pace.learn(step, {.free_until = 1}, 1e-9, 1);
  }
}

TEST(Pace, progress_is_counted_and_paths_that_are_cut_short_bend) {
  Pace pace;
  pace.bending = 1;
  const Vec6 step = Vec6::Unit(0);
  pace.learn(step, {.free_until = 1e-12, .hit = true}, 1e-9, 1);
  EXPECT_EQ(pace.stalled, 1);
  EXPECT_EQ(pace.bending, descent_tuning.bending_growth);
  pace.learn(step, {.free_until = 1e-12, .hit = true, .given_up = true}, 1e-9, 1);
  EXPECT_EQ(pace.stalled, 1) << "a sweep that was given up says nothing about progress";
  pace.learn(step, {.free_until = 0.5, .hit = true}, 1e-9, 1);
  EXPECT_EQ(pace.stalled, 0);
  EXPECT_EQ(pace.went, 0.5);
}

TEST(Pace, a_step_is_shortened_to_its_limit_only) {
  EXPECT_EQ(shortened(3 * Vec6::Unit(1), 5), 3 * Vec6::Unit(1));
  EXPECT_NEAR((shortened(3 * Vec6::Unit(1), 2) - 2 * Vec6::Unit(1)).norm(), 0, 1e-15);
}

}  // namespace
}  // namespace sonde
