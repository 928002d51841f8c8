// SPDX-License-Identifier: GPL-3.0-or-later
// The reference is the sorted list of the same times.
#include "engine/haptics/loop/time_histogram.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

namespace sonde {
namespace {

TEST(TimeHistogram, quantiles_are_those_of_the_sorted_times_to_a_bin) {
  std::mt19937_64 random(3);
  std::lognormal_distribution<double> times(3, 1.5);
  TimeHistogram histogram;
  std::vector<double> all;
  for (int i = 0; i < 20000; ++i) {
    all.push_back(times(random));
    histogram.add(all.back());
  }
  std::sort(all.begin(), all.end());
  for (const double share : {0.01, 0.5, 0.9, 0.99, 0.999, 1.0}) {
    const double exact = all[static_cast<std::size_t>(std::ceil(share * double(all.size()))) - 1];
    EXPECT_GE(histogram.quantile(share), exact) << share;
    EXPECT_LE(histogram.quantile(share), 1.06 * exact) << share;
  }
  EXPECT_EQ(histogram.total, all.size());
  EXPECT_EQ(histogram.largest, all.back());
}

TEST(TimeHistogram, holds_what_is_too_short_or_too_long_or_no_time) {
  TimeHistogram histogram;
  EXPECT_EQ(histogram.quantile(0.5), 0);
  for (const double us : {0.0, -3.0, std::numeric_limits<double>::quiet_NaN()}) histogram.add(us);
  EXPECT_EQ(histogram.counts.front(), 3u);
  histogram.add(1e9);
  histogram.add(std::numeric_limits<double>::infinity());
  EXPECT_EQ(histogram.counts.back(), 2u);
  EXPECT_EQ(histogram.total, 5u);
}

TEST(TimeHistogram, never_says_more_than_the_largest) {
  TimeHistogram histogram;
  histogram.add(101);
  EXPECT_EQ(histogram.quantile(0.5), 101);
}

}  // namespace
}  // namespace sonde
