// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/latency.hpp"

#include <gtest/gtest.h>

namespace sonde::test {
namespace {

using namespace std::chrono_literals;

TEST(Latency, each_sample_counts_once_with_its_first_answer) {
  Latency latency;
  const DeviceClock::time_point start = DeviceClock::now();
  for (int i = 0; i < 1000; ++i) {
    const auto sampled = start + i * 1ms;
    latency.answered(sampled, sampled + (i < 998 ? 2000us : 7000us));
    latency.answered(sampled, sampled + 90ms);
  }
  const LatencySummary summary = summary_of(latency.times());
  EXPECT_EQ(summary.samples, 1000U);
  // To a bin of the histogram, which is 6 % wide and never too low.
  EXPECT_GE(summary.median, 2000);
  EXPECT_LE(summary.median, 2120);
  EXPECT_EQ(summary.p999, 7000) << "the largest of all is exact";
}

TEST(Latency, what_answers_no_sample_does_not_count) {
  Latency latency;
  latency.answered({}, DeviceClock::now());
  EXPECT_EQ(latency.times().total, 0U);
  latency.answered(DeviceClock::now(), DeviceClock::now());
  latency.restart();
  EXPECT_EQ(latency.times().total, 0U);
}

}  // namespace
}  // namespace sonde::test
