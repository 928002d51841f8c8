// SPDX-License-Identifier: GPL-3.0-or-later
// The servo with a hand, in its real threads. Nothing here is about time: a loaded machine may stop
// any thread for as long as it likes.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <thread>

#include "engine/haptics/loop/servo.hpp"
#include "tests/engine/haptics/loop/at_depth.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using test::at_depth;

using namespace std::chrono_literals;

ServoSettings settings() {
  ServoSettings s;
  s.safety.ramp_time = 0.01;
  s.safety.stalled_after = 1e9;
  return s;
}

/// A hand that holds still, moves or lets go as the test says, and remembers what it was given.
struct TestHand {
  std::atomic<double> depth{0.002};
  std::atomic<bool> held{true}, trusted{true};
  std::atomic<double> force{-1};  ///< z of the last wrench; -1: none yet
  std::atomic<std::uint64_t> samples{0}, renders{0};
  std::atomic<std::uint64_t> out_of_turn{0};
  std::atomic<bool> bad_dt{false};
  std::optional<DeviceTraits> device;   ///< to be set before the start
  std::atomic<double> largest_fall{0};  ///< N, from one wrench to the next

  Hand hand() {
    return {.sample =
                [this](double dt) {
                  if ((dt == 0) != (samples == 0)) bad_dt = true;
                  if (samples != renders) ++out_of_turn;
                  ++samples;
                  return HandSample{
                      .X_FM = at_depth(depth), .held = held, .trusted = trusted, .device = device};
                },
            .render =
                [this](const Wrench& wrench) {
                  ++renders;
                  largest_fall = std::max(largest_fall.load(), force - wrench.force.z());
                  force = wrench.force.z();
                }};
  }
};

class ServoHand : public testing::Test {
 protected:
  bool wait_for(const std::function<bool(const Snapshot&)>& wanted) {
    for (const auto end = std::chrono::steady_clock::now() + 60s;
         std::chrono::steady_clock::now() < end; std::this_thread::sleep_for(1ms))
      if (const Snapshot* s = servo.latest(); s && wanted(*s)) return true;
    return false;
  }
  bool wait_for_reason(Withheld why) {
    return wait_for([why](const Snapshot& s) { return s.hand.withheld == why; });
  }
  bool wait_for_force() {
    return wait_for([](const Snapshot& s) { return s.wrench.force.z() > 0.99; });
  }
  std::shared_ptr<const Body> probe = test::body(test::box({0.02, 0.03, 0.05}));
  std::shared_ptr<const Body> fixed = test::body(test::box({0.3, 0.3, 0.1}));
  TestHand hand;
  Servo servo{{probe, fixed}, Method::pdg, Coupling{}, settings()};
};

TEST_F(ServoHand, is_sampled_and_rendered_to_in_turn) {
  servo.start(at_depth(0.002), hand.hand());
  ASSERT_TRUE(wait_for_force());
  EXPECT_GT(hand.force, 0.9);
  servo.stop();
  EXPECT_EQ(hand.out_of_turn, 0u);
  EXPECT_FALSE(hand.bad_dt);
  EXPECT_EQ(hand.renders, hand.samples + 1);  // the last word
  EXPECT_GE(hand.samples, servo.latest()->tick);
}

TEST_F(ServoHand, the_last_wrench_is_zero) {
  servo.start(at_depth(0.002), hand.hand());
  ASSERT_TRUE(wait_for_force());
  servo.stop();
  EXPECT_EQ(hand.force, 0);
  EXPECT_EQ(servo.latest()->hand.withheld, Withheld::shut_down);
  EXPECT_EQ(servo.latest()->wrench.force, Vec3::Zero());
}

TEST_F(ServoHand, nothing_is_felt_with_the_force_off_the_clutch_open_the_device_lost_or_paused) {
  servo.start(at_depth(0.002), hand.hand());
  const auto none_then_some = [&](Withheld why, const auto& set) {
    ASSERT_TRUE(wait_for_force());
    set(true);
    ASSERT_TRUE(wait_for_reason(why)) << words(why);
    // The render of the tick before the snapshot at the latest.
    EXPECT_EQ(hand.force, 0) << words(why);
    set(false);
    ASSERT_TRUE(wait_for_force()) << words(why);
  };
  none_then_some(Withheld::stopped, [&](bool on) { servo.set_force(!on); });
  none_then_some(Withheld::let_go, [&](bool on) { hand.held = !on; });
  none_then_some(Withheld::untrusted, [&](bool on) { hand.trusted = !on; });
  const auto paused = [&](bool on) { servo.set_paused(on); };
  ASSERT_TRUE(wait_for_force());
  paused(true);
  ASSERT_TRUE(wait_for_reason(Withheld::paused));
  EXPECT_EQ(hand.force, 0);
  const std::uint64_t before = hand.samples;
  for (int i = 0; i < 60000 && hand.samples < before + 3; ++i) std::this_thread::sleep_for(1ms);
  EXPECT_GE(hand.samples, before + 3);  // a device wants to be read, and told, all the same
  paused(false);
  EXPECT_TRUE(wait_for_force());
}

// 1 N of a device's 4: at 4 N/s.
TEST_F(ServoHand, a_pause_and_an_end_let_the_force_of_a_pressed_hand_fall_gradually) {
  hand.device = DeviceTraits{.max_force = 4, .mass = 0.1};
  servo.start(at_depth(0.002), hand.hand());
  ASSERT_TRUE(wait_for_force());
  hand.largest_fall = 0;
  servo.set_paused(true);
  ASSERT_TRUE(wait_for([&](const Snapshot&) { return hand.force == 0; }));
  servo.set_paused(false);
  ASSERT_TRUE(wait_for_force());
  servo.set_paused(true);
  ASSERT_TRUE(wait_for([&](const Snapshot&) { return hand.force < 0.8; }));
  servo.set_paused(false);  // it goes on once it has fallen
  ASSERT_TRUE(wait_for([&](const Snapshot&) { return hand.force == 0; }));
  ASSERT_TRUE(wait_for_force());
  servo.stop();
  EXPECT_EQ(hand.force, 0);
  EXPECT_NEAR(hand.largest_fall, 0.004, 1e-6);
  EXPECT_EQ(hand.out_of_turn, 0u);
}

TEST_F(ServoHand, a_force_that_is_switched_off_ends_at_once_in_a_pause_too) {
  hand.device = DeviceTraits{.max_force = 0.02, .mass = 0.1};  // a minute, but for longest_fade
  servo.start(at_depth(0.002), hand.hand());
  ASSERT_TRUE(wait_for([](const Snapshot& s) { return s.wrench.force.z() > 0.02; }));
  servo.set_paused(true);
  ASSERT_TRUE(wait_for([](const Snapshot& s) { return s.paused; }));
  const double before = hand.force;
  EXPECT_GT(before, 0.01);
  hand.largest_fall = 0;
  servo.set_force(false);
  ASSERT_TRUE(wait_for([&](const Snapshot&) { return hand.force == 0; }));
  EXPECT_GT(hand.largest_fall, 0.01) << "in one tick";
}

TEST_F(ServoHand, deadlines_and_ages_are_counted) {
  servo.start(at_depth(0.002), hand.hand());
  ASSERT_TRUE(wait_for([](const Snapshot& s) { return s.tick >= 100; }));
  servo.stop();
  const Snapshot last = *servo.latest();
  const ServoTiming& timing = servo.timing();
  EXPECT_EQ(timing.ticks, last.tick);
  EXPECT_EQ(timing.tick.total, last.tick);
  EXPECT_EQ(timing.period.total, last.tick - 1);
  EXPECT_EQ(timing.age.total, last.tick);
  EXPECT_EQ(timing.late, last.late);
  EXPECT_LE(timing.in_step, timing.ticks);
  EXPECT_GT(timing.geometry.total, 0u);
  EXPECT_GT(timing.period.quantile(0.5), timing.tick.quantile(0.01));
  EXPECT_STRNE(timing.real_time.scheduling, "");
  EXPECT_STRNE(timing.real_time.memory, "");
}

TEST_F(ServoHand, says_where_its_rows_come_from) {
  servo.start(at_depth(0.002), hand.hand());
  ASSERT_TRUE(wait_for([](const Snapshot& s) { return s.tick >= 20 && s.hand.rows.in_step; }));
  const RowsUsed rows = servo.latest()->hand.rows;
  EXPECT_LE(rows.age_ticks, 1u);
  EXPECT_GT(rows.reach, 0);
  EXPECT_NEAR(rows.separated.p.z(), at_depth(0).p.z(), 1e-5);
}

TEST_F(ServoHand, the_servo_thread_neither_allocates_nor_frees) {
  std::optional<test::AllocationCounter> counter;
  std::atomic<bool> done{false};
  int tick = 0;
  const Hand counting{.sample =
                          [&](double) {
                            ++tick;
                            if (tick == 5) counter.emplace();
                            if (tick == 400) counter->stop(), done = true;
                            return HandSample{.X_FM = at_depth(0.003 * std::sin(0.05 * tick))};
                          },
                      .render = {}};
  servo.start(at_depth(0), counting);
  ASSERT_TRUE(wait_for([&](const Snapshot&) { return done.load(); }));
  servo.stop();
  EXPECT_EQ(counter->allocations(), 0u);
  EXPECT_EQ(counter->frees(), 0u);
}

}  // namespace
}  // namespace sonde
