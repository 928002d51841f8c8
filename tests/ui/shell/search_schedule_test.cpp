// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/search_schedule.hpp"

#include <gtest/gtest.h>

namespace sonde::ui {
namespace {

Pose at(double x) { return {Quat::Identity(), Vec3(x, 0, 0)}; }

BackgroundResult found_at(const Pose& device, double time_us = 0) {
  BackgroundResult out;
  out.device = device;
  out.time_us = time_us;
  return out;
}

TEST(SearchSchedule, a_pose_that_is_answered_is_not_asked_about_again) {
  SearchSchedule schedule;
  ASSERT_TRUE(schedule.asks(at(1), 0));
  schedule.answered(found_at(at(1)));
  for (const qint64 now : {10, 500, 100000}) EXPECT_FALSE(schedule.asks(at(1), now)) << now;
  schedule.forget();
  EXPECT_TRUE(schedule.asks(at(1), 200000)) << "of another pair";
}

TEST(SearchSchedule, a_moving_probe_gets_a_hundredth_of_the_time) {
  SearchSchedule schedule;
  ASSERT_TRUE(schedule.asks(at(0), 0));
  schedule.answered(found_at(at(0), 50e3));  // 50 ms: half a second from the request on
  int asked = 0;
  for (int now = 16; now < 500; now += 16) asked += schedule.asks(at(1e-3 * now), now);
  EXPECT_EQ(asked, 0);
  EXPECT_TRUE(schedule.asks(at(7), 500));
}

TEST(SearchSchedule, a_probe_that_comes_to_rest_is_asked_about_before_its_time) {
  SearchSchedule schedule;
  ASSERT_TRUE(schedule.asks(at(0), 0));
  schedule.answered(found_at(at(0), 1e6));  // not again before 10 s
  EXPECT_FALSE(schedule.asks(at(1), 200));
  EXPECT_FALSE(schedule.asks(at(1), 300)) << "it may go on";
  EXPECT_TRUE(schedule.asks(at(1), 301));
  EXPECT_FALSE(schedule.asks(at(1), 700)) << "once is enough";
}

TEST(SearchSchedule, without_an_answer_it_asks_again_after_a_second) {
  SearchSchedule schedule;
  ASSERT_TRUE(schedule.asks(at(0), 0));
  EXPECT_FALSE(schedule.asks(at(0), 999));
  EXPECT_TRUE(schedule.asks(at(0), 1000));
}

TEST(SearchSchedule, what_was_passed_over_counts_only_where_it_was_found) {
  SearchSchedule schedule;
  schedule.answered(found_at(at(0)));
  ASSERT_TRUE(schedule.newest());
  schedule.pass_over(found_at(at(1)));
  EXPECT_FALSE(schedule.newest()) << "nothing is known any more";
  EXPECT_FALSE(schedule.takes(found_at(at(1)), at(2))) << "the probe has left";
  EXPECT_TRUE(schedule.takes(found_at(at(1)), at(1)));
  EXPECT_TRUE(schedule.takes(found_at(at(2)), at(3))) << "a newer one";
  schedule.answered(found_at(at(2)));
  EXPECT_TRUE(schedule.takes(found_at(at(1)), at(2))) << "nothing is passed over any more";
}

}  // namespace
}  // namespace sonde::ui
