// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/gain_glide.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sonde {
namespace {

Coupling gains(double k, double b_t = 0) {
  Coupling c;
  c.k = k;
  c.b_t = b_t;
  return c;
}

TEST(GainGlide, goes_in_equal_steps_and_arrives_exactly) {
  GainGlide glide(gains(500), 0.1);
  glide.set(gains(1500, 3));
  double before = 500;
  for (int tick = 1; tick < 100; ++tick) {
    const Coupling& now = glide.next(1e-3).now;
    // 1000 N/m in 100 ticks of the same length.
    EXPECT_NEAR(now.k - before, 10, 1e-9) << tick;
    EXPECT_NEAR(now.b_t, 0.03 * tick, 1e-9);
    before = now.k;
  }
  glide.next(1.001e-3);
  EXPECT_EQ(glide.next(1e-3).now.k, 1500);
  EXPECT_EQ(glide.next(1e-3).now.b_t, 3);
}

TEST(GainGlide, another_goal_on_the_way_begins_where_it_is) {
  GainGlide glide(gains(500), 0.1);
  glide.set(gains(1500));
  const double half_way = glide.next(0.05).now.k;
  glide.set(gains(500));
  EXPECT_NEAR(glide.next(1e-3).now.k, half_way - 5, 1e-9);
  EXPECT_EQ(glide.next(1).now.k, 500);
}

TEST(GainGlide, a_limit_that_rises_goes_with_the_gains_and_one_that_falls_is_there_at_once) {
  GainGlide glide(gains(500), 0.1);
  Coupling wanted = gains(1500);
  wanted.max_force = 2;
  wanted.max_torque = 1;
  glide.set(wanted);
  const Coupling now = glide.next(0.05).now;
  EXPECT_EQ(now.max_force, 2);
  EXPECT_NEAR(now.max_torque, 0.75, 1e-12);
  EXPECT_NEAR(now.k, 1000, 1e-9);
  EXPECT_EQ(glide.next(0.06).now.max_torque, 1);
}

TEST(GainGlide, to_another_mode_the_share_of_the_wrench_grows) {
  GainGlide glide(gains(500), 0.1);
  Coupling wanted = gains(1500);
  wanted.mode = Coupling::Mode::classic;
  wanted.k_t = 77;
  wanted.max_force = 30;
  glide.set(wanted);
  const GainGlide::Blend half = glide.next(0.05);
  EXPECT_EQ(half.now.mode, Coupling::Mode::classic);
  EXPECT_EQ(half.now.k_t, 77);
  EXPECT_EQ(half.before.mode, Coupling::Mode::object);
  EXPECT_EQ(half.before.k, 500);
  EXPECT_NEAR(half.share, 0.5, 1e-12);
  EXPECT_NEAR(half.now.max_force, 20, 1e-12);
  EXPECT_EQ(glide.next(0.06).share, 1);
  EXPECT_EQ(glide.next(0.06).now.max_force, 30);
}

TEST(GainGlide, without_time_nothing_moves_and_a_restart_does_not_glide) {
  GainGlide glide(gains(500), 0.1);
  glide.set(gains(1500));
  EXPECT_EQ(glide.next(0).now.k, 500);
  EXPECT_EQ(glide.next(NAN).now.k, 500);
  glide.restart(gains(900));
  EXPECT_EQ(glide.next(1e-3).now.k, 900);
  GainGlide none(gains(500), 0);
  none.set(gains(1500));
  EXPECT_EQ(none.next(1e-3).now.k, 1500);
}

}  // namespace
}  // namespace sonde
