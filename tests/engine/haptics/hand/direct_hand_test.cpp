// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/hand/direct_hand.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/allocation_counter.hpp"

namespace sonde {
namespace {

TEST(DirectHand, the_probe_is_where_the_newest_target_is) {
  DirectHand direct({Quat::Identity(), Vec3(1, 2, 3)});
  const Hand hand = direct.hand();
  EXPECT_EQ(hand.sample(0).X_FM.p, Vec3(1, 2, 3));
  direct.set_target({Quat::Identity(), Vec3(4, 5, 6)});
  direct.set_target({Quat::Identity(), Vec3(7, 8, 9)});
  test::AllocationCounter counter;
  HandSample sample;
  for (int tick = 0; tick <= 200; ++tick) sample = hand.sample(0.001);
  counter.stop();
  EXPECT_EQ(counter.allocations(), 0U);
  EXPECT_EQ(sample.X_FM.p, Vec3(7, 8, 9));
  EXPECT_TRUE(sample.held && sample.trusted);
}

// Reference: uniform motion.
TEST(DirectHand, targets_of_one_motion_are_reached_in_the_time_between_them) {
  DirectHand direct({Quat::Identity(), Vec3::Zero()});
  const Hand hand = direct.hand();
  const auto target = [](int i) {
    return Pose{Quat(std::cos(0.05 * i), std::sin(0.05 * i), 0, 0), Vec3(0.01 * i, 0, 0)};
  };
  direct.set_target(target(1));
  EXPECT_EQ(hand.sample(0).X_FM.p, target(1).p) << "at once, before the first tick";
  Pose last = target(1);
  test::AllocationCounter counter;
  for (int i = 2; i < 20; ++i) {
    for (int tick = 1; tick < 10; ++tick) last = hand.sample(1e-3).X_FM;
    direct.set_target(target(i));
    const Pose now = hand.sample(1e-3).X_FM;
    EXPECT_NEAR((now.p - target(i - 1).p).norm(), 0, 1e-12) << "reached as the next one comes";
    EXPECT_NEAR(now.q.dot(target(i - 1).q), 1, 1e-12);
    if (i > 2) {
      EXPECT_NEAR((now.p - last.p).norm(), 1e-3, 1e-12) << "a tenth of the way";
    }
  }
  counter.stop();
  EXPECT_EQ(counter.allocations(), 0U);
  for (int tick = 0; tick < 250; ++tick) last = hand.sample(1e-3).X_FM;
  EXPECT_EQ(last.p, target(19).p) << "to the bit";
  EXPECT_EQ(last.q.coeffs(), target(19).q.coeffs());
  // After a pause of the mouse too, a picture that took 0.3 s among them: over 0.2 s.
  direct.set_target(target(3));
  for (int tick = 0; tick <= 100; ++tick) last = hand.sample(1e-3).X_FM;
  EXPECT_NEAR((last.p - target(11).p).norm(), 0, 1e-12) << "half way";
  for (int tick = 0; tick <= 100; ++tick) last = hand.sample(1e-3).X_FM;
  EXPECT_EQ(last.p, target(3).p);
}

TEST(DirectHand, the_first_sample_and_one_after_a_pause_do_not_glide) {
  const auto x = [](double at) { return Pose{Quat::Identity(), Vec3(at, 0, 0)}; };
  DirectHand direct(x(0));
  const Hand hand = direct.hand();
  hand.sample(1e-3);
  direct.set_target(x(1));
  for (int tick = 0; tick < 10; ++tick) hand.sample(1e-3);
  direct.set_target(x(2));
  EXPECT_LT(hand.sample(1e-3).X_FM.p.x(), 2);
  EXPECT_EQ(hand.sample(0).X_FM.p.x(), 2) << "the first sample after a pause";
  for (int tick = 0; tick < 10; ++tick) hand.sample(1e-3);
  direct.set_target(x(3));
  EXPECT_EQ(hand.sample(0).X_FM.p.x(), 3) << "a target that was set in the pause";
  for (int tick = 0; tick < 10; ++tick) hand.sample(1e-3);
  direct.set_target(x(4));
  EXPECT_LT(hand.sample(1e-3).X_FM.p.x(), 4);
  direct.set_target(x(5));
  EXPECT_EQ(hand.sample(0).X_FM.p.x(), 5);
  for (int tick = 0; tick < 3; ++tick) EXPECT_EQ(hand.sample(1e-3).X_FM.p.x(), 5);
}

// Pictures 10 ms apart after one that took 0.1 s: what is behind is caught up with in that time.
TEST(DirectHand, what_a_slow_picture_is_behind_is_not_caught_up_with_at_once) {
  const auto x = [](double at) { return Pose{Quat::Identity(), Vec3(at, 0, 0)}; };
  DirectHand direct(x(0));
  const Hand hand = direct.hand();
  double last = 0, fastest = 0;
  for (int tick = 1; tick <= 400; ++tick) {
    if (tick % 10 == 0 && (tick < 100 || tick >= 200)) direct.set_target(x(tick));
    const double now = hand.sample(1e-3).X_FM.p.x();
    if (tick > 30) fastest = std::max(fastest, now - last);
    last = now;
  }
  EXPECT_LT(fastest, 3) << "the mouse goes at 1 a tick";
  EXPECT_NEAR(last, 390, 15);
}

TEST(DirectHand, a_target_that_comes_early_is_gone_to_from_where_the_probe_is) {
  DirectHand direct({Quat::Identity(), Vec3::Zero()});
  const Hand hand = direct.hand();
  const auto go = [&](double x) { direct.set_target({Quat::Identity(), Vec3(x, 0, 0)}); };
  go(1);
  hand.sample(0);
  for (int tick = 1; tick < 10; ++tick) hand.sample(1e-3);
  go(2);
  hand.sample(1e-3);
  for (int tick = 1; tick < 5; ++tick) hand.sample(1e-3);
  go(1);  // the way to 2 is half gone
  EXPECT_NEAR(hand.sample(1e-3).X_FM.p.x(), 1.5, 1e-12);
  // Half of the 10 ms to the last target is left, and the mouse took 5 to this one: 10 at twice
  // its speed, but 5 at least.
  EXPECT_NEAR(hand.sample(1e-3).X_FM.p.x(), 1.5 - 0.5 / 5, 1e-12);
}

// A drag at 1 a tick, a target every 10 ticks, and a loop that is behind for 50 ticks of it.
TEST(DirectHand, the_probe_stands_while_the_loop_is_behind_and_catches_up_afterwards) {
  const auto x = [](double at) { return Pose{Quat::Identity(), Vec3(at, 0, 0)}; };
  DirectHand direct(x(0));
  const Hand hand = direct.hand();
  double last = 0, stood_at = 0, fastest = 0;
  for (int tick = 1; tick <= 400; ++tick) {
    if (tick % 10 == 0) direct.set_target(x(tick));
    const double now = hand.sample(1e-3).X_FM.p.x();
    const bool behind = tick >= 100 && tick < 150;
    hand.follow(behind ? 1.5 : 0.3);
    if (tick == 101) stood_at = last;
    if (tick > 101 && tick <= 150) {
      EXPECT_EQ(now, stood_at) << tick;
    }
    if (tick > 30) fastest = std::max(fastest, now - last);
    last = now;
  }
  EXPECT_LE(fastest, 2 + 1e-9) << "twice the mouse's speed";
  EXPECT_NEAR(last, 400 - 10, 1) << "a target behind the mouse, as without";
}

TEST(DirectHand, a_loop_that_is_somewhat_behind_makes_the_probe_slow_and_none_stops_it_for_ever) {
  const auto x = [](double at) { return Pose{Quat::Identity(), Vec3(at, 0, 0)}; };
  DirectHand direct(x(0));
  const Hand hand = direct.hand();
  const auto pose = [&] { return hand.sample(1e-3).X_FM.p.x(); };
  hand.sample(1e-3);
  direct.set_target(x(0));
  for (int tick = 0; tick < 100; ++tick) pose();
  direct.set_target(x(100));  // over 100 ticks
  pose();
  hand.follow(0.75);
  const double at = pose();
  EXPECT_NEAR(pose() - at, 0.5, 1e-9) << "half way between hardly and wholly behind";
  hand.follow(2);
  int stood = 0;
  for (double before = pose(), now; (now = pose()) == before && stood < 1000; ++stood) before = now;
  EXPECT_NEAR(1e-3 * stood, DirectHand::longest_wait, 5e-3);
  for (int tick = 0; tick < 100; ++tick) pose();
  EXPECT_EQ(pose(), 100);
}

TEST(DirectHand, a_pause_of_the_mouse_is_no_leap_for_a_probe_that_waits) {
  const auto x = [](double at) { return Pose{Quat::Identity(), Vec3(at, 0, 0)}; };
  DirectHand direct(x(0));
  const Hand hand = direct.hand();
  const auto pose = [&] { return hand.sample(1e-3).X_FM.p.x(); };
  hand.sample(1e-3);
  direct.set_target(x(0));
  for (int tick = 0; tick < 100; ++tick) pose();
  direct.set_target(x(100));
  for (int tick = 0; tick < 190; ++tick) {
    pose();
    hand.follow(1);
  }
  hand.follow(0);
  for (int tick = 0; tick < 20; ++tick) pose();
  direct.set_target(x(200));
  const double before = pose();
  EXPECT_LT(before, 30);
  EXPECT_LT(pose() - before, 5);
}

}  // namespace
}  // namespace sonde
