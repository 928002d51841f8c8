// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/safety/runaway.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/engine/haptics/tick_time.hpp"

namespace sonde {
namespace {

using test::dt;

struct RunawayTest : testing::Test {
  Runaway runaway{{.way = 2}};
  /// Straight on at a speed (m/s) for some ticks.
  void go(double speed, int ticks, bool pushed) {
    for (int i = 0; i < ticks; ++i)
      runaway.observe(speed * dt * Vec3::UnitX(), Vec3::Zero(), dt, pushed);
  }
};

TEST_F(RunawayTest, a_hand_that_is_fast_under_a_force_is_seen_until_it_is_slow_and_free) {
  go(3, 15, true);
  EXPECT_FALSE(runaway.seen()) << "not for so short";
  go(3, 15, true);
  EXPECT_TRUE(runaway.seen());
  runaway.release();
  EXPECT_TRUE(runaway.seen()) << "free, and fast still";
  go(0, 100, false);
  EXPECT_TRUE(runaway.seen()) << "slow, and not free";
  runaway.release();
  EXPECT_FALSE(runaway.seen());
}

TEST_F(RunawayTest, thrown_out_of_the_contact_it_is_seen_on_its_way) {
  go(4, 3, true);
  go(4, 20, false);
  EXPECT_TRUE(runaway.seen());
}

TEST_F(RunawayTest, a_hand_moves_freely_as_fast_as_it_likes) {
  go(10, 1000, false);
  EXPECT_FALSE(runaway.seen());
}

TEST_F(RunawayTest, slower_than_that_nothing_is_seen_however_hard_it_is_pushed) {
  go(1.99, 1000, true);
  EXPECT_FALSE(runaway.seen());
}

// 5 mm to and fro at 100 Hz: 3 m/s at its fastest, and nowhere in the mean.
TEST_F(RunawayTest, a_buzz_is_none) {
  Vec3 before = Vec3::Zero();
  for (int i = 1; i < 1000; ++i) {
    const Vec3 here(0.005 * std::sin(2 * std::numbers::pi * 100 * dt * i), 0, 0);
    runaway.observe(here - before, Vec3::Zero(), dt, true);
    before = here;
    ASSERT_FALSE(runaway.seen()) << i;
  }
}

TEST_F(RunawayTest, a_slow_device_that_steps_every_eighth_tick_is_as_fast_as_it_is) {
  for (int i = 0; i < 1000; ++i)
    runaway.observe(i % 8 == 0 ? Vec3(0.008, 0, 0) : Vec3::Zero(), Vec3::Zero(), dt,
                    true);  // 1 m/s
  EXPECT_FALSE(runaway.seen());
}

TEST_F(RunawayTest, without_time_a_number_or_a_limit_nothing_is_seen) {
  runaway.observe(Vec3(1, 0, 0), Vec3::Zero(), 0, true);
  runaway.observe(Vec3(std::numeric_limits<double>::quiet_NaN(), 0, 0), Vec3::Zero(), dt, true);
  EXPECT_FALSE(runaway.seen());
  Runaway unlimited({});
  for (int i = 0; i < 100; ++i) unlimited.observe(Vec3(1, 0, 0), Vec3(1, 0, 0), dt, true);
  EXPECT_FALSE(unlimited.seen());
}

TEST_F(RunawayTest, a_hand_that_is_turned_too_fast_by_a_torque_is_seen_until_it_is_slow_and_free) {
  Runaway turned({2, 30});
  const auto turn = [&](double speed, int ticks, bool pushed) {
    for (int i = 0; i < ticks; ++i)
      turned.observe(Vec3::Zero(), speed * dt * Vec3::UnitZ(), dt, pushed);
  };
  turn(100, 1000, false);
  EXPECT_FALSE(turned.seen()) << "freely it turns as fast as it likes";
  turned.restart();
  turn(29.9, 1000, true);
  EXPECT_FALSE(turned.seen());
  turn(45, 30, true);
  EXPECT_TRUE(turned.seen());
  turned.release();
  EXPECT_TRUE(turned.seen()) << "free, and fast still";
  turn(0, 100, false);
  turned.release();
  EXPECT_FALSE(turned.seen());
}

// 0.2 rad to and fro at 100 Hz: 125 rad/s at its fastest, and nowhere in the mean.
TEST_F(RunawayTest, a_buzz_in_turning_is_none) {
  Runaway turned({2, 30});
  double before = 0;
  for (int i = 1; i < 1000; ++i) {
    const double here = 0.2 * std::sin(2 * std::numbers::pi * 100 * dt * i);
    turned.observe(Vec3::Zero(), Vec3(0, here - before, 0), dt, true);
    before = here;
    ASSERT_FALSE(turned.seen()) << i;
  }
}

// Reference: v = F t / m, with the 20 ms over which the speed is averaged.
TEST(ThrownSpeed, is_what_all_of_the_force_makes_of_the_handle) {
  const ThrownSpeed most{2, 30};
  DeviceTraits touch;
  touch.max_force = 3.3;
  touch.mass = 0.05;
  touch.max_torque = 0.05;
  touch.inertia = 5e-5;
  EXPECT_NEAR(thrown_speed(touch, most).way, 3.3 * 0.02 / 0.05, 1e-12);
  EXPECT_NEAR(thrown_speed(touch, most).turn, 0.05 * 0.02 / 5e-5, 1e-9);
  DeviceTraits scaled = touch;  // the same handle, whose motion the probe makes five times as large
  scaled.ratio = 5;
  scaled.max_force /= 5;
  scaled.mass /= 25;
  EXPECT_NEAR(thrown_speed(scaled, most).way, thrown_speed(touch, most).way, 1e-12);
  touch.max_force = 30;
  EXPECT_EQ(thrown_speed(touch, most).way, 2) << "no hand goes faster and is not thrown";
  EXPECT_EQ(thrown_speed({}, most).way, 2) << "nothing is known";
  EXPECT_EQ(thrown_speed({}, most).turn, 30);
  EXPECT_EQ(thrown_speed(touch, {}).way, 0) << "no limit was asked for";
}

}  // namespace
}  // namespace sonde
