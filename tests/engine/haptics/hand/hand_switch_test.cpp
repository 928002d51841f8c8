// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/hand/hand_switch.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "tests/support/allocation_counter.hpp"

namespace sonde {
namespace {

/// A hand that remembers what was asked of it; its poses have p.x = number.
struct Recorded {
  explicit Recorded(double number)
      : hand(std::make_shared<const Hand>(
            Hand{.sample =
                     [this, number](double dt) {
                       last_dt = dt;
                       return HandSample{.X_FM = {Quat::Identity(), Vec3(number, 0, 0)}};
                     },
                 .render = [this](const Wrench& wrench) { last_force = wrench.force; },
                 .follow = [this](double behind) { last_behind = behind; }})) {}
  double last_dt = -1, last_behind = -1;
  Vec3 last_force = Vec3(-1, -1, -1);
  std::shared_ptr<const Hand> hand;
};

TEST(HandSwitch, the_newest_hand_holds_and_the_one_before_ends_without_force) {
  Recorded first(1), second(2);
  HandSwitch hands(first.hand);
  const Hand hand = hands.hand();
  EXPECT_FALSE(hand.sample(0).changed) << "nobody held before";
  EXPECT_EQ(hand.sample(0.001).X_FM.p.x(), 1);
  EXPECT_EQ(first.last_dt, 0.001);
  hand.render({.force = Vec3(1, 0, 0)});
  EXPECT_EQ(first.last_force, Vec3(1, 0, 0));
  hands.set(second.hand);
  const HandSample handed_over = hand.sample(0.001);
  EXPECT_EQ(handed_over.X_FM.p.x(), 2);
  EXPECT_TRUE(handed_over.changed) << "the force comes in from zero";
  EXPECT_EQ(second.last_dt, 0) << "its first";
  EXPECT_EQ(first.last_force, Vec3(0, 0, 0));
  hand.follow(0.5);
  EXPECT_EQ(first.last_behind, -1);
  EXPECT_EQ(second.last_behind, 0.5);
  hand.render({.force = Vec3(0, 1, 0)});
  EXPECT_EQ(second.last_force, Vec3(0, 1, 0));
  EXPECT_FALSE(hand.sample(0.001).changed);
  EXPECT_EQ(first.last_force, Vec3(0, 0, 0));
}

TEST(HandSwitch, a_last_wrench_before_the_first_tick_goes_to_nobody) {
  Recorded first(1);
  HandSwitch hands(first.hand);
  hands.hand().render({});
  EXPECT_EQ(first.last_force, Vec3(-1, -1, -1));
}

TEST(HandSwitch, a_paused_hand_is_not_asked_and_begins_anew) {
  Recorded first(1), second(2);
  HandSwitch hands(first.hand);
  const Hand hand = hands.hand();
  hand.sample(0);
  hand.sample(0.001);
  hands.set_paused(true);
  first.last_dt = -1;
  EXPECT_EQ(hand.sample(0.001).X_FM.p.x(), 1);
  EXPECT_EQ(first.last_dt, -1);
  hands.set(second.hand);
  EXPECT_EQ(hand.sample(0.001).X_FM.p.x(), 2) << "another hand takes over all the same";
  second.last_dt = -1;
  hand.sample(0.001);
  EXPECT_EQ(second.last_dt, -1);
  hands.set_paused(false);
  hand.sample(0.001);
  EXPECT_EQ(second.last_dt, 0);
  hand.sample(0.001);
  EXPECT_EQ(second.last_dt, 0.001);
}

TEST(HandSwitch, a_hand_lives_until_the_servo_has_let_go_of_it) {
  HandSwitch hands(std::make_shared<const Hand>());
  std::weak_ptr<const Hand> seen;
  const auto add = [&] {
    auto next = std::make_shared<const Hand>(
        Hand{.sample = [](double) { return HandSample{}; }, .render = {}});
    seen = next;
    hands.set(std::move(next));
  };
  add();
  const Hand hand = hands.hand();
  hand.sample(0);
  const std::weak_ptr<const Hand> in_use = seen;
  add();
  hands.sweep();
  EXPECT_FALSE(in_use.expired());
  test::AllocationCounter counter;
  hand.sample(0.001);
  hand.render({});
  counter.stop();
  EXPECT_EQ(counter.allocations() + counter.frees(), 0U) << "on the servo's side";
  EXPECT_FALSE(in_use.expired()) << "freed by the other thread alone";
  hands.sweep();
  EXPECT_TRUE(in_use.expired());
  EXPECT_EQ(hands.kept(), 1U);
}

TEST(HandSwitch, hands_change_under_a_running_thread) {
  std::atomic<bool> stop{false};
  std::atomic<int> alive{0};
  const auto make = [&](double number) {
    const std::shared_ptr<int> token(new int(0), [&](int* i) {
      --alive;
      delete i;
    });
    ++alive;
    return std::make_shared<const Hand>(
        Hand{.sample =
                 [token, number](double) {
                   ++*token;
                   return HandSample{.X_FM = {Quat::Identity(), Vec3(number, 0, 0)}};
                 },
             .render = {}});
  };
  {
    HandSwitch hands(make(0));
    const Hand hand = hands.hand();
    std::atomic<double> last{-1};
    std::thread servo([&] {
      while (!stop) {
        const double now = hand.sample(0.001).X_FM.p.x();
        EXPECT_GE(now, last) << "an older hand came back";
        last = now;
        hand.render({});
      }
    });
    for (int i = 1; i <= 2000; ++i) {
      hands.set(make(i));
      hands.sweep();
      if (i % 16 == 0) std::this_thread::yield();
    }
    while (last < 2000) std::this_thread::yield();
    hands.sweep();
    EXPECT_EQ(hands.kept(), 1U);
    EXPECT_EQ(alive, 1);
    stop = true;
    servo.join();
  }
  EXPECT_EQ(alive, 0);
}

}  // namespace
}  // namespace sonde
