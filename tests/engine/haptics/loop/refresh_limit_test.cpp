// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/loop/refresh_limit.hpp"

#include <gtest/gtest.h>

namespace sonde {
namespace {

TEST(RefreshLimit, is_the_budget_as_long_as_answers_converge) {
  RefreshLimit limit;
  for (int i = 0; i < 5; ++i, limit.learn(true)) EXPECT_EQ(limit.of(800), 800);
}

TEST(RefreshLimit, doubles_up_to_its_largest_and_falls_back_at_once) {
  RefreshLimit limit;
  for (const double wanted : {800.0, 1600.0, 3200.0, 6400.0, 6400.0}) {
    EXPECT_EQ(limit.of(800), wanted);
    limit.learn(false);
  }
  limit.learn(true);
  EXPECT_EQ(limit.of(800), 800);
}

TEST(RefreshLimit, a_larger_budget_is_not_raised_and_a_small_one_grows_as_far) {
  RefreshLimit limit;
  for (int i = 0; i < 3000; ++i) limit.learn(false);
  EXPECT_EQ(limit.of(9000), 9000);
  EXPECT_EQ(limit.of(1), loop_tuning.longest_refresh_us);
}

TEST(RefreshLimit, no_limit_stays_none) {
  RefreshLimit limit;
  limit.learn(false);
  EXPECT_EQ(limit.of(0), 0);
}

}  // namespace
}  // namespace sonde
