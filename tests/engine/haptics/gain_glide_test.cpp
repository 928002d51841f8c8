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
    const Coupling& now = glide.next(1e-3);
    // 1000 N/m in 100 ticks of the same length.
    EXPECT_NEAR(now.k - before, 10, 1e-9) << tick;
    EXPECT_NEAR(now.b_t, 0.03 * tick, 1e-9);
    before = now.k;
  }
  glide.next(1.001e-3);
  EXPECT_EQ(glide.next(1e-3).k, 1500);
  EXPECT_EQ(glide.next(1e-3).b_t, 3);
}

TEST(GainGlide, another_goal_on_the_way_begins_where_it_is) {
  GainGlide glide(gains(500), 0.1);
  glide.set(gains(1500));
  const double half_way = glide.next(0.05).k;
  glide.set(gains(500));
  EXPECT_NEAR(glide.next(1e-3).k, half_way - 5, 1e-9);
  EXPECT_EQ(glide.next(1).k, 500);
}

TEST(GainGlide, limits_and_another_mode_are_there_at_once) {
  GainGlide glide(gains(500), 0.1);
  Coupling wanted = gains(1500);
  wanted.max_force = 2;
  glide.set(wanted);
  EXPECT_EQ(glide.next(1e-3).max_force, 2);
  EXPECT_LT(glide.next(1e-3).k, 600);
  wanted.mode = Coupling::Mode::classic;
  wanted.k_t = 77;
  glide.set(wanted);
  EXPECT_EQ(glide.next(1e-3).mode, Coupling::Mode::classic);
  EXPECT_EQ(glide.next(1e-3).k_t, 77);
}

TEST(GainGlide, without_time_nothing_moves_and_a_restart_does_not_glide) {
  GainGlide glide(gains(500), 0.1);
  glide.set(gains(1500));
  EXPECT_EQ(glide.next(0).k, 500);
  EXPECT_EQ(glide.next(NAN).k, 500);
  glide.restart(gains(900));
  EXPECT_EQ(glide.next(1e-3).k, 900);
  GainGlide none(gains(500), 0);
  none.set(gains(1500));
  EXPECT_EQ(none.next(1e-3).k, 1500);
}

}  // namespace
}  // namespace sonde
