// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/descent/pace.hpp"

#include <gtest/gtest.h>

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
