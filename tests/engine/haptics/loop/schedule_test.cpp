// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/loop/schedule.hpp"

#include <gtest/gtest.h>

namespace sonde {
namespace {

TEST(Schedule, keeps_the_period_whatever_the_jitter_within_it) {
  Schedule schedule{.period = 1000, .due = 5000};
  EXPECT_FALSE(schedule.finish(5800));
  EXPECT_EQ(schedule.due, 6000);
  EXPECT_FALSE(schedule.finish(6001));
  EXPECT_EQ(schedule.due, 7000);
  EXPECT_FALSE(schedule.finish(8000));  // at its deadline to the nanosecond: in time
  EXPECT_EQ(schedule.due, 8000);
}

TEST(Schedule, a_tick_past_its_deadline_is_late_and_made_up_for) {
  Schedule schedule{.period = 1000, .due = 5000};
  EXPECT_TRUE(schedule.finish(6400));
  EXPECT_EQ(schedule.due, 6000);  // at once, and the following ones are in step again
  EXPECT_FALSE(schedule.finish(6800));
  EXPECT_EQ(schedule.due, 7000);
}

TEST(Schedule, starts_again_after_a_long_delay) {
  Schedule schedule{.period = 1000, .due = 5000};
  EXPECT_TRUE(schedule.finish(95'300));
  EXPECT_EQ(schedule.due, 95'300);
  int ticks_at_once = 0;
  std::int64_t now = 95'300;
  while (schedule.due <= now) {
    schedule.finish(now += 10);
    ++ticks_at_once;
  }
  EXPECT_EQ(ticks_at_once, 1);
}

TEST(RateMeter, knows_nothing_before_the_second_tick) {
  RateMeter meter;
  EXPECT_EQ(meter.rate(), 0);
  meter.tick(123);
  EXPECT_EQ(meter.rate(), 0);
}

TEST(RateMeter, measures_regular_ticks_exactly_from_the_second_on) {
  RateMeter meter;
  std::int64_t now = 777;
  meter.tick(now);
  for (int i = 0; i < 1000; ++i) {
    meter.tick(now += 1'000'000);
    ASSERT_DOUBLE_EQ(meter.rate(), 1000);
  }
}

TEST(RateMeter, follows_a_change_within_two_windows) {
  RateMeter meter;
  std::int64_t now = 0;
  for (int i = 0; i < 500; ++i) meter.tick(now += 1'000'000);
  const std::int64_t change = now;
  while (now < change + 200'000'000) meter.tick(now += 2'000'000);
  EXPECT_NEAR(meter.rate(), 500, 5);
}

}  // namespace
}  // namespace sonde
