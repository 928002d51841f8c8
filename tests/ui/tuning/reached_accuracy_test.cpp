// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/reached_accuracy.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sonde::ui::test {
namespace {

Snapshot contact_tick(double time, double residual = 0) {
  Snapshot tick;
  tick.time = time;
  tick.separation.status = Status::penetrating;
  tick.separation.converged = true;
  tick.hand.rows.residual = residual;
  tick.hand.rows.refresh_us = 300;
  tick.tick_us = 20;
  return tick;
}

/// As many ticks as there have to be, at 1 kHz.
template <class Change>
ReachedAccuracy after(std::size_t count, const Change& change) {
  ReachedAccuracy reached;
  for (std::size_t i = 0; i < count; ++i) {
    Snapshot tick = contact_tick(1e-3 * double(i));
    change(i, tick);
    reached.add(tick);
  }
  return reached;
}

TEST(ReachedAccuracyTest, is_known_after_enough_ticks_in_contact) {
  const auto same = [](std::size_t, Snapshot&) {};
  EXPECT_FALSE(after(ReachedAccuracy::least - 1, same).reached());
  const auto reached = after(ReachedAccuracy::least, same).reached();
  ASSERT_TRUE(reached);
  EXPECT_EQ(reached->rows_us, 300);
  EXPECT_EQ(reached->tick_us, 20);
  EXPECT_EQ(reached->converged, 1);
  EXPECT_EQ(reached->within, 0);
}

/// 1 − √(1 − r²), by hand: r = 0.6 leaves 0.8 of the depth.
TEST(ReachedAccuracyTest, a_residual_is_the_part_of_the_depth_that_may_be_too_much) {
  for (const auto& [residual, within] :
       {std::pair{0.0, 0.0}, std::pair{0.6, 0.2}, std::pair{1.0, 1.0}, std::pair{1.5, 1.0}}) {
    const auto reached = after(30, [&](std::size_t, Snapshot& tick) {
                           tick.hand.rows.residual = residual;
                         }).reached();
    ASSERT_TRUE(reached);
    EXPECT_NEAR(reached->within, within, 1e-15) << residual;
  }
  const double small = 1e-9;
  const auto reached =
      after(30, [&](std::size_t, Snapshot& tick) { tick.hand.rows.residual = small; }).reached();
  EXPECT_NEAR(reached->within / (small * small / 2), 1, 1e-9) << "also where it is tiny";
}

TEST(ReachedAccuracyTest, nine_in_ten_keep_to_it) {
  const auto reached = after(100, [](std::size_t i, Snapshot& tick) {
                         tick.hand.rows.refresh_us = double((37 * i) % 100 + 1);  // 1 to 100
                         tick.tick_us = i % 10 == 3 ? 900 : 20;
                         tick.hand.rows.residual = i % 10 == 5 ? 1 : 0;
                         tick.separation.converged = i % 4 != 0;
                       }).reached();
  ASSERT_TRUE(reached);
  EXPECT_EQ(reached->rows_us, 90);
  EXPECT_EQ(reached->tick_us, 20) << "one in ten is worse";
  EXPECT_EQ(reached->within, 0);
  EXPECT_EQ(reached->converged, 0.75);
}

TEST(ReachedAccuracyTest, phases_are_the_mean_and_the_servos_own_tick_is_one_of_them) {
  const auto reached = after(40, [](std::size_t i, Snapshot& tick) {
                         tick.hand.rows.phases[Phase::solve] = i % 2 == 0 ? 100 : 300;
                         tick.hand.rows.phases[Phase::couple] =
                             7;  // of the geometry, which has none
                         tick.tick_us = i % 2 == 0 ? 10 : 30;
                       }).reached();
  ASSERT_TRUE(reached);
  EXPECT_DOUBLE_EQ(reached->phases[Phase::solve], 200);
  EXPECT_DOUBLE_EQ(reached->phases[Phase::couple], 20);
  EXPECT_EQ(reached->phases[Phase::sweep], 0);
}

TEST(ReachedAccuracyTest, ticks_that_are_paused_free_failed_or_told_twice_do_not_count) {
  ReachedAccuracy reached;
  for (std::size_t i = 0; i < 10 * ReachedAccuracy::least; ++i) {
    Snapshot tick = contact_tick(1e-3 * double(i));
    if (i % 3 == 0) tick.paused = true;
    if (i % 3 == 1) tick.separation.status = Status::separated;
    if (i % 3 == 2) tick.separation.status = Status::failed;
    reached.add(tick);
  }
  for (std::size_t i = 0; i < 10 * ReachedAccuracy::least; ++i) reached.add(contact_tick(0.5));
  EXPECT_FALSE(reached.reached());
}

TEST(ReachedAccuracyTest, only_the_last_ticks_count) {
  const auto reached = after(ReachedAccuracy::most + 500, [](std::size_t i, Snapshot& tick) {
                         tick.hand.rows.residual = i < 500 ? 1 : 0;
                       }).reached();
  ASSERT_TRUE(reached);
  EXPECT_EQ(reached->within, 0);
}

TEST(ReachedAccuracyTest, a_time_that_goes_back_is_another_run) {
  ReachedAccuracy reached = after(100, [](std::size_t, Snapshot&) {});
  ASSERT_TRUE(reached.reached());
  reached.add(contact_tick(0.001));
  EXPECT_FALSE(reached.reached());
  reached = after(100, [](std::size_t, Snapshot&) {});
  reached.clear();
  EXPECT_FALSE(reached.reached());
}

}  // namespace
}  // namespace sonde::ui::test
