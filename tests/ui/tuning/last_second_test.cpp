// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/last_second.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/study/stability/press_and_hold.hpp"

namespace sonde::ui {
namespace {

class LastSecondTest : public ::testing::Test {
 protected:
  void SetUp() override {
    MassProperties mass;
    mass.inertia = Vec3(1e-4, 1e-4, 1e-4);
    last.take(mass);
  }
  /// Ticks of 1 ms: a steady force and one that swings, and energy that grows evenly.
  void run(double from, double to, double steady, double swing, double frequency) {
    for (int i = 0; from + i * 1e-3 < to - 1e-9; ++i) {
      Snapshot tick;
      tick.time = from + i * 1e-3;
      tick.wrench.force.x() =
          steady + swing * std::sin(2 * std::numbers::pi * frequency * tick.time);
      tick.hand.energy.given = 0.25 * tick.time;
      last.add(tick);
    }
  }
  LastSecond last;
};

TEST_F(LastSecondTest, the_share_of_power_that_swings_is_the_chatter) {
  // Mean squares: steady², swing²/2.
  run(0, 3, 1, 0.2, 200);
  ASSERT_TRUE(last.buzz());
  EXPECT_NEAR(last.buzz()->chatter, 0.02 / 1.02, 1e-4);
  EXPECT_GT(last.buzz()->chatter, chatter_limit);
  run(3, 4.1, 1, 0.2, 5);  // the same swing, as slow as a hand
  EXPECT_LT(last.buzz()->chatter, 1e-6);
}

TEST_F(LastSecondTest, the_energy_is_that_of_one_second) {
  run(0, 5, 1, 0, 0);
  ASSERT_TRUE(last.buzz());
  EXPECT_NEAR(last.buzz()->energy, 0.25, 1e-3);
}

TEST_F(LastSecondTest, before_a_second_there_is_none_and_a_pause_or_a_restart_begins_afresh) {
  run(0, 0.5, 1, 0, 0);
  EXPECT_FALSE(last.buzz());
  run(0.5, 1.2, 1, 0, 0);
  EXPECT_TRUE(last.buzz());
  run(3, 3.5, 1, 0, 0);
  EXPECT_FALSE(last.buzz()) << "after a pause";
  run(3.5, 4.2, 1, 0, 0);
  EXPECT_TRUE(last.buzz());
  run(0, 0.5, 1, 0, 0);
  EXPECT_FALSE(last.buzz()) << "after a restart";
}

}  // namespace
}  // namespace sonde::ui
