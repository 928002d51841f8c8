// SPDX-License-Identifier: GPL-3.0-or-later
// A window that closes while a device presses a hand. Reference: the hand counts what it gets.
#include <gtest/gtest.h>

#include <atomic>
#include <memory>

#include "tests/ui/window_fixture.hpp"
#include "ui/document/session.hpp"

namespace sonde::ui::test {
namespace {

class ClosingTest : public WindowTest {
 protected:
  /// A hand on a device whose force rises and falls by 1 N/s presses the probe where it is.
  void SetUp() override {
    WindowTest::SetUp();
    if (HasFatalFailure()) return;
    open_cubes();
    const Pose at = window->session()->device_pose();
    window->session()->hold_by(std::make_shared<const Hand>(
        Hand{[at](double) {
               return HandSample{.X_FM = at, .device = DeviceTraits{.max_force = 1, .mass = 0.1}};
             },
             [felt = force](const Wrench& wrench) { *felt = wrench.force.norm(); }}));
    window->set_felt(true);
    ASSERT_TRUE(wait_until([this] { return *force > 0.9; }));
  }
  std::shared_ptr<std::atomic<double>> force = std::make_shared<std::atomic<double>>(0);
};

TEST_F(ClosingTest, it_stays_until_the_force_has_fallen) {
  window->close();
  EXPECT_TRUE(window->isVisible());
  EXPECT_GT(*force, 0.3) << "it falls within a second";
  ASSERT_TRUE(wait_until([this] { return !window->isVisible(); }));
  EXPECT_EQ(*force, 0);
}

TEST_F(ClosingTest, esc_ends_the_force_meanwhile) {
  window->close();
  ASSERT_GT(*force, 0.3);
  QTest::keyClick(window.get(), Qt::Key_Escape);
  QElapsedTimer clock;
  clock.start();
  ASSERT_TRUE(wait_until([this] { return *force == 0; }));
  EXPECT_LT(clock.elapsed(), 200) << "of the second that it takes by itself";
  EXPECT_TRUE(wait_until([this] { return !window->isVisible(); }));
}

TEST_F(ClosingTest, nobody_is_asked_twice_and_nothing_else_can_be_opened) {
  window->close();
  const int asked = asked_to_leave;
  window->close();
  EXPECT_TRUE(window->isVisible());
  EXPECT_FALSE(window->acceptDrops());
  ASSERT_TRUE(wait_until([this] { return !window->isVisible(); }));
  EXPECT_EQ(asked_to_leave, asked);
  EXPECT_EQ(*force, 0);
}

TEST_F(ClosingTest, with_no_motors_it_closes_at_once) {
  window->set_felt(false);
  window->close();
  EXPECT_FALSE(window->isVisible());
}

}  // namespace
}  // namespace sonde::ui::test
