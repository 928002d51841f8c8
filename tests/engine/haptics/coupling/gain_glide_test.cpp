// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/coupling/gain_glide.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

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

// The object norm is the damped mode without damping, whatever its b_t says.
TEST(GainGlide, to_the_damper_and_back_the_damping_comes_and_goes) {
  Coupling plain = gains(500, 7), damped = gains(1500, 4);
  damped.mode = Coupling::Mode::damped;
  GainGlide glide(plain, 0.1);
  glide.set(damped);
  const GainGlide::Blend half = glide.next(0.05);
  EXPECT_EQ(half.share, 1);
  EXPECT_EQ(half.now.mode, Coupling::Mode::damped);
  EXPECT_NEAR(half.now.k, 1000, 1e-9);
  EXPECT_NEAR(half.now.b_t, 2, 1e-9);
  EXPECT_EQ(glide.next(0.06).now.b_t, 4);
  glide.set(plain);
  EXPECT_NEAR(glide.next(0.025).now.b_t, 3, 1e-9);
  const Coupling there = glide.next(0.08).now;
  EXPECT_EQ(there.mode, Coupling::Mode::object);
  EXPECT_EQ(there.k, 500);
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

TEST(GainGlide, modes_changed_in_quick_succession_do_not_make_the_wrench_step) {
  Coupling object = gains(500), classic = gains(500), stiffer = gains(900);
  classic.mode = Coupling::Mode::classic;
  classic.k_t = 1500;
  stiffer.max_force = 25;
  // One contact, a millimetre deep: the force of a blend is that of its two stiffnesses.
  const auto force = [](const GainGlide::Blend& b) {
    const auto of = [](const Coupling& c) {
      return 1e-3 * (c.mode == Coupling::Mode::object ? c.k : c.k_t);
    };
    return b.share * of(b.now) + (1 - b.share) * of(b.before);
  };
  GainGlide glide(object, 0.1);
  const std::pair<int, Coupling> wishes[] = {
      {0, classic}, {50, object}, {60, classic}, {70, stiffer}};
  double before = 0.5, largest = 0;
  for (int tick = 0; tick < 250; ++tick) {
    for (const auto& [when, wish] : wishes)
      if (when == tick) glide.set(wish);
    const double now = force(glide.next(1e-3));
    largest = std::max(largest, std::abs(now - before));
    before = now;
  }
  EXPECT_NEAR(before, 0.9, 1e-12) << "the newest wish is where it ends";
  // From 0.5 N to 1.5 N in 100 ticks.
  EXPECT_LT(largest, 1.01e-2);
  EXPECT_GT(largest, 0.99e-2);
}

TEST(GainGlide, a_change_of_mode_that_is_held_goes_back_for_a_newer_wish) {
  GainGlide glide(gains(500), 0.1);
  Coupling stiff = gains(500), softer = gains(100);
  stiff.mode = Coupling::Mode::classic;
  stiff.k_t = 9000;
  glide.set(stiff);
  glide.next(0.03);
  const GainGlide::Blend held = glide.next(1e-3, 0);
  EXPECT_NEAR(held.share, 0.3, 1e-12);
  EXPECT_EQ(held.before.k, 500);
  glide.set(softer);
  const GainGlide::Blend back = glide.next(1e-3, 0);  // no step yet, and the same wrench
  EXPECT_NEAR(back.share, 0.7, 1e-12);
  EXPECT_EQ(back.before.k_t, 9000);
  EXPECT_EQ(back.now.k, 500);
  for (int tick = 0; tick < 150; ++tick) glide.next(1e-3);
  EXPECT_EQ(glide.next(1e-3).share, 1);
  EXPECT_EQ(glide.next(1e-3).now.k, 100);
}

// Both ways may be held: one by its stiffness, the other by that against turns.
TEST(GainGlide, a_change_of_mode_goes_back_once_and_then_stays_while_it_is_held) {
  GainGlide glide(gains(500), 0.1);
  Coupling stiff = gains(500);
  stiff.mode = Coupling::Mode::classic;
  glide.set(stiff);
  glide.next(0.03);
  glide.set(stiff);
  EXPECT_NEAR(glide.next(1e-3, 0).share, 0.3, 1e-12) << "no newer wish: the same again";
  glide.set(gains(100));
  for (int tick = 0; tick < 10; ++tick) EXPECT_NEAR(glide.next(1e-3, 0).share, 0.7, 1e-12) << tick;
  for (int tick = 0; tick < 150; ++tick) glide.next(1e-3);
  EXPECT_EQ(glide.next(1e-3).now.k, 100);
}

TEST(GainGlide, a_limit_that_falls_does_not_wait_for_the_other_mode) {
  GainGlide glide(gains(500), 0.1);
  Coupling classic = gains(500), careful = gains(500);
  classic.mode = Coupling::Mode::classic;
  careful.max_force = 1;
  glide.set(classic);
  EXPECT_EQ(glide.next(0.05).now.max_force, Coupling{}.max_force);
  glide.set(careful);
  for (int tick = 0; tick < 200; ++tick) EXPECT_EQ(glide.next(1e-3).now.max_force, 1) << tick;
  EXPECT_EQ(glide.next(1e-3).now.mode, Coupling::Mode::object);
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
