// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/statistics.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>

namespace sonde::bench {
namespace {

std::vector<double> one_to(int n) {
  std::vector<double> out(static_cast<std::size_t>(n));
  std::iota(out.rbegin(), out.rend(), 1.0);  // falling: nothing may rely on an order
  return out;
}

TEST(Statistics, median_by_hand) {
  EXPECT_EQ(median({7}), 7);
  EXPECT_EQ(median({3, 1}), 2);
  EXPECT_EQ(median({9, 1, 5}), 5);
  EXPECT_EQ(median({9, 1, 5, 6}), 5.5);
  EXPECT_EQ(median({2, 2, 2, 100}), 2);
  EXPECT_THROW(median({}), std::invalid_argument);
}

// Nearest rank: at least the share of the values does not exceed the result, and no lesser value
// has that property.
TEST(Statistics, percentile_is_the_nearest_rank) {
  EXPECT_EQ(percentile(one_to(100), 0.99), 99);
  EXPECT_EQ(percentile(one_to(100), 0.991), 100);
  EXPECT_EQ(percentile(one_to(1000), 0.999), 999);
  EXPECT_EQ(percentile(one_to(60), 0.99), 60);
  EXPECT_EQ(percentile(one_to(10), 0), 1);
  EXPECT_EQ(percentile(one_to(10), 1), 10);
  EXPECT_THROW(percentile({}, 0.5), std::invalid_argument);
  for (int n = 1; n <= 300; ++n)
    for (const double share : {0.5, 0.9, 0.99, 0.999}) {
      const double value = percentile(one_to(n), share);  // so many do not exceed it
      EXPECT_GE(value, share * n - 1e-6) << n;
      EXPECT_LT(value - 1, share * n) << n;
    }
}

TEST(Statistics, one_interrupted_call_does_not_move_a_pose) {
  const Statistics s = summarize({{1, 1, 900}, {2, 800, 2}, {3, 3, 3}});
  EXPECT_EQ(s.poses, 3u);
  EXPECT_EQ(s.calls, 9u);
  EXPECT_EQ(s.median_us, 2);
  EXPECT_EQ(s.p99_us, 3);
  EXPECT_FALSE(s.tail);
}

TEST(Statistics, the_tail_is_of_single_calls_and_wants_a_thousand) {
  Calls calls(10, std::vector<double>(100, 1.0));
  calls[4][7] = 50;
  EXPECT_EQ(summarize(calls).tail, 1);  // one of 1000 lies beyond p99.9
  calls[5][8] = 50;
  EXPECT_EQ(summarize(calls).tail, 50);
  calls[0].pop_back();
  EXPECT_FALSE(summarize(calls).tail);
}

TEST(Statistics, a_ratio_looks_at_the_poses_that_both_have) {
  EXPECT_EQ(ratio_of_medians({{6}, {8}, {10}}, {{2}, {4}, {5}}), 2);
  EXPECT_EQ(ratio_of_medians({{6}}, {{2}, {400}, {500}}), 3);
  EXPECT_EQ(ratio_of_medians({{6}, {7}, {8}}, {{2}}), 3);
}

}  // namespace
}  // namespace sonde::bench
