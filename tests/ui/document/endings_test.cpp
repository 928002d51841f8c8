// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/endings.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
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

  std::unique_ptr<Session> held_session() {
    const auto cube = [] { return sonde::test::body(sonde::test::box({0.1, 0.1, 0.1})); };
    const std::shared_ptr<const Body> probe = cube();
    body = probe;
    LoadedScene loaded{.pair = Pair(probe, cube())};
    loaded.start.p = Vec3(0.095, 0.01, 0.02);
    loaded.coupling.k = 500;
    loaded.servo.real_time = false;
    auto session = std::make_unique<Session>(std::move(loaded));
    session->hold_by(std::make_shared<const Hand>(
        Hand{[held = held](double) {
               ++held->samples;
               return HandSample{.X_FM = {Quat::Identity(), Vec3(0.095, 0.01, 0.02)}};
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

TEST_F(EndingsTest, a_session_that_is_added_has_let_go_of_the_hand) {
  std::unique_ptr<Session> session = held_session();
  ASSERT_TRUE(comes([this] { return held->force > 0; })) << "it is felt";
  Endings endings;
  endings.add(std::move(session));
  const int samples = held->samples;
  EXPECT_EQ(held->force, 0) << "the last that the hand was told";
  ASSERT_TRUE(comes([this] { return body.expired(); })) << "it ends without being asked again";
  EXPECT_EQ(held->samples, samples) << "nothing has asked the hand since";
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
