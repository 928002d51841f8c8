// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/last_second.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace sonde::ui {
namespace {

class LastSecondTest : public ::testing::Test {
 protected:
  void SetUp() override {
    MassProperties mass;
    mass.inertia = Vec3(1e-4, 1e-4, 1e-4);
    last.take(mass);
  }
  /// Ticks of 1 ms: a steady force and one that swings, and energy that grows evenly.
  void run(double from, double to, double steady, double swing, double frequency) {
    for (int i = 0; from + i * 1e-3 < to - 1e-9; ++i) {
      Snapshot tick;
      tick.time = from + i * 1e-3;
      tick.wrench.force.x() =
          steady + swing * std::sin(2 * std::numbers::pi * frequency * tick.time);
      tick.hand.energy.given = 0.25 * tick.time;
      tick.hand.device = device;
      // A free mass swings so by that force, half a tick later.
      const double omega = 2 * std::numbers::pi * frequency;
      if (device && frequency > 0)
        tick.separation.device.p.x() = -swing / (device->mass * omega * omega) *
                                       std::sin(omega * (tick.time - 0.5e-3) + lag_of_losses);
      last.add(tick);
    }
  }
  static constexpr double lag_of_losses = 0.1;  // rad: what damps it
  std::optional<DeviceTraits> device = DeviceTraits{.mass = 0.3};
  LastSecond last;
};

TEST_F(LastSecondTest, what_the_force_makes_the_handle_do_is_chatter) {
  run(0, 3, 1, 0.2, 100);
  ASSERT_TRUE(last.buzz());
  EXPECT_TRUE(last.buzz()->loop);
  EXPECT_NEAR(last.buzz()->chatter.force, 0.2, 0.01);
  EXPECT_NEAR(last.buzz()->chatter.frequency, 100, 1);
  EXPECT_TRUE(last.buzz()->chatter.buzzes());
  run(3, 4.1, 1, 0.2, 5);  // the same swing, as slow as a hand
  EXPECT_FALSE(last.buzz()->chatter.buzzes());
}

TEST_F(LastSecondTest, with_a_mouse_or_a_device_without_motors_nothing_buzzes) {
  device = DeviceTraits{.mass = 0.3, .force = false};
  run(0, 1.1, 1, 0.2, 100);
  EXPECT_FALSE(last.buzz()->loop);
  EXPECT_EQ(last.buzz()->chatter.force, 0);
  device.reset();
  run(1.1, 2.2, 1, 0.2, 100);
  EXPECT_FALSE(last.buzz()->loop);
}

TEST_F(LastSecondTest, the_energy_is_that_of_one_second) {
  run(0, 5, 1, 0, 0);
  ASSERT_TRUE(last.buzz());
  EXPECT_NEAR(last.buzz()->energy, 0.25, 1e-3);
}

TEST_F(LastSecondTest, before_a_second_there_is_none_and_a_pause_or_a_restart_begins_afresh) {
  run(0, 0.5, 1, 0, 0);
  EXPECT_FALSE(last.buzz());
  run(0.5, 1.2, 1, 0, 0);
  EXPECT_TRUE(last.buzz());
  run(3, 3.5, 1, 0, 0);
  EXPECT_FALSE(last.buzz()) << "after a pause";
  run(3.5, 4.2, 1, 0, 0);
  EXPECT_TRUE(last.buzz());
  run(0, 0.5, 1, 0, 0);
  EXPECT_FALSE(last.buzz()) << "after a restart";
}

}  // namespace
}  // namespace sonde::ui
