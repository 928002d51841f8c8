// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/endings.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include "tests/support/shapes.hpp"
#include "ui/document/session.hpp"

namespace sonde::ui::test {
namespace {

/// A session whose probe a hand holds that counts what the servo asks of it, and pushes into the
/// fixed body.
class EndingsTest : public testing::Test {
 protected:
  struct Held {
    std::atomic<int> samples = 0;
    std::atomic<double> force = 0;  ///< N, the last
  };

  /// `device`: the hand is on one, and pressed.
  std::unique_ptr<Session> held_session(std::optional<DeviceTraits> device = {}) {
    const auto cube = [] { return sonde::test::body(sonde::test::box({0.1, 0.1, 0.1})); };
    const std::shared_ptr<const Body> probe = cube();
    body = probe;
    LoadedScene loaded{.pair = Pair(probe, cube())};
    loaded.start.p = Vec3(0.095, 0.01, 0.02);
    loaded.coupling.k = 500;
    loaded.servo.real_time = false;
    loaded.servo.safety.stalled_after = 1e9;  // on a loaded machine too
    auto session = std::make_unique<Session>(std::move(loaded));
    session->hold_by(std::make_shared<const Hand>(Hand{
        [held = held, device](double) {
          ++held->samples;
          return HandSample{.X_FM = {Quat::Identity(), Vec3(0.095, 0.01, 0.02)}, .device = device};
        },
        [held = held](const Wrench& wrench) { held->force = wrench.force.norm(); }}));
    return session;
  }
  static bool comes(const std::function<bool()>& holds) {
    for (int i = 0; i < 30'000 && !holds(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return holds();
  }

  std::shared_ptr<Held> held = std::make_shared<Held>();
  std::weak_ptr<const Body> body;
};

/// Whose force rises and falls by 0.5 N/s.
constexpr DeviceTraits slow_device{.max_force = 0.5, .mass = 0.1};

TEST_F(EndingsTest, a_session_that_is_added_lets_go_of_the_hand) {
  std::unique_ptr<Session> session = held_session();
  ASSERT_TRUE(comes([this] { return held->force > 0; })) << "it is felt";
  const LoopEnded ended = session->ended();
  EXPECT_FALSE(*ended);
  Endings endings;
  endings.add(std::move(session));
  ASSERT_TRUE(comes([&] { return ended->load(); }));
  const int samples = held->samples;
  EXPECT_EQ(held->force, 0) << "the last that the hand was told";
  EXPECT_TRUE(endings.unended().empty());
  ASSERT_TRUE(comes([this] { return body.expired(); })) << "it ends without being asked again";
  EXPECT_EQ(held->samples, samples) << "nothing has asked the hand since";
}

// 2.5 N at 2 N/s: 1.25 s, for which the window waited before.
TEST_F(EndingsTest, a_pressed_hands_force_falls_gradually_and_nobody_waits_for_that) {
  std::unique_ptr<Session> session = held_session(DeviceTraits{.max_force = 2, .mass = 0.1});
  ASSERT_TRUE(comes([this] { return held->force > 2.4; }));
  const LoopEnded ended = session->ended();
  Endings endings;
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  endings.add(std::move(session));
  EXPECT_LT(seconds(), 0.5);
  EXPECT_GT(held->force, 1);
  EXPECT_EQ(endings.unended().size(), 1U);
  ASSERT_TRUE(comes([&] { return ended->load(); }));
  EXPECT_GT(seconds(), 1) << "gradually";
  EXPECT_EQ(held->force, 0);
}

TEST_F(EndingsTest, esc_ends_the_force_of_what_ends_and_of_what_is_to_end_at_once) {
  for (const bool added : {true, false}) {
    std::unique_ptr<Session> session = held_session(slow_device);
    ASSERT_TRUE(comes([this] { return held->force > 1.5; }));
    Endings endings;
    endings.expect(session.get());
    if (added) endings.add(std::move(session));
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    ASSERT_GT(held->force, 1) << "3 s to fall";
    endings.stop_force();
    const auto start = std::chrono::steady_clock::now();
    ASSERT_TRUE(comes([this] { return held->force == 0; }));
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
  }
}

TEST_F(EndingsTest, a_reset_does_not_wait_for_a_pressed_hand_and_esc_ends_its_force) {
  std::unique_ptr<Session> session = held_session(slow_device);
  ASSERT_TRUE(comes([this] { return held->force > 1.5; }));
  const auto start = std::chrono::steady_clock::now();
  session->reset();
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(500));
  EXPECT_TRUE(session->placing());
  EXPECT_GT(held->force, 1);
  session->set_force(false);
  ASSERT_TRUE(comes([&] { return !session->placing(); }));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2)) << "of 3";
  EXPECT_EQ(held->force, 0);
  session->set_force(true);
  EXPECT_TRUE(comes([this] { return held->force > 0; })) << "it has begun again";
}

TEST_F(EndingsTest, their_end_waits_for_all_of_theirs) {
  std::weak_ptr<const Body> first;
  {
    Endings endings;
    endings.add(held_session());
    first = body;
    endings.add(held_session());
  }
  EXPECT_TRUE(first.expired());
  EXPECT_TRUE(body.expired());
}

TEST_F(EndingsTest, nothing_to_end_is_no_fault) {
  Endings endings;
  endings.add(nullptr);
  endings.add(held_session());
  endings.add(nullptr);
  EXPECT_TRUE(comes([this] { return body.expired(); }));
}

}  // namespace
}  // namespace sonde::ui::test
