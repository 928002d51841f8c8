// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/search_budget.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace sonde {
namespace {

TEST(SearchBudget, without_limits_never_ends) {
  SearchBudget budget({}, {}, search_tuning);
  budget.spend(1'000'000);
  EXPECT_FALSE(budget.is_limited());
  EXPECT_FALSE(budget.is_short());
  EXPECT_EQ(budget.steps_left(), std::numeric_limits<int>::max());
  EXPECT_FALSE(budget.search_is_over());
  EXPECT_FALSE(budget.is_over());
}

TEST(SearchBudget, steps_are_used_up_and_never_owed) {
  SearchBudget budget({.steps = 10}, {}, search_tuning);
  EXPECT_TRUE(budget.is_limited() && budget.counts_steps());
  budget.spend(4);
  EXPECT_EQ(budget.steps_left(), 6);
  budget.spend(9);
  EXPECT_EQ(budget.steps_left(), 0);
  EXPECT_EQ(budget.steps_spent(), 13);
  EXPECT_TRUE(budget.search_is_over() && budget.is_over());
}

TEST(SearchBudget, a_start_that_is_cut_short_leaves_no_steps) {
  SearchBudget budget({.steps = 10}, {}, search_tuning);
  budget.spend_all();
  EXPECT_EQ(budget.steps_left(), 0);
  EXPECT_EQ(budget.steps_spent(), 10);
}

TEST(SearchBudget, time_ends_first_for_sketches_then_for_the_search_then_for_refining) {
  SearchTuning tuning;
  tuning.share_for_sketches = 0.25, tuning.share_for_search = 0.5, tuning.share_for_refining = 0.75;
  const double second = 1e6;
  // Begun six tenths of the time ago: the first two shares are over, the third is not.
  const SearchBudget budget({.microseconds = 1000 * second},
                            {1000 * second, now_us() - 600 * second}, tuning);
  EXPECT_TRUE(budget.sketching().passed());
  EXPECT_TRUE(budget.search_is_over());
  EXPECT_FALSE(budget.is_over());
}

TEST(SearchBudget, a_time_is_short_where_a_second_thread_costs_more_than_it_brings) {
  SearchTuning tuning;
  tuning.shortest_for_two_threads = 5000;
  EXPECT_TRUE(SearchBudget({.microseconds = 4999}, {}, tuning).is_short());
  EXPECT_FALSE(SearchBudget({.microseconds = 5000}, {}, tuning).is_short());
}

}  // namespace
}  // namespace sonde
