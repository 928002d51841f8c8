// SPDX-License-Identifier: GPL-3.0-or-later
// References: closed forms of what is carried.
#include "engine/haptics/safety/carried_force.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace sonde {
namespace {

constexpr ChangeRate carried_rate{.force = 10, .torque = 0.1};
constexpr double carried_tick = 1e-3;  // s

Wrench carried_push(double force, double torque = 0) {
  return {Vec3(0, 0, force), Vec3(torque, 0, 0)};
}

TEST(CarriedForce, what_is_felt_goes_on_and_comes_to_what_is_wanted_at_the_rate) {
  CarriedForce carried;
  EXPECT_EQ(carried.added_to(carried_push(2), carried_rate, Vec3::Zero(), carried_tick).force.z(),
            2);
  carried.carry(carried_push(1, 0.05), carried_push(2, 0.02));
  for (int i = 1; i <= 100; ++i) {
    const Wrench out =
        carried.added_to(carried_push(2, 0.02), carried_rate, Vec3::Zero(), carried_tick);
    EXPECT_NEAR(out.force.z(), 1 + 10 * carried_tick * i, 1e-12) << i;
    EXPECT_NEAR(out.torque.x(), std::max(0.02, 0.05 - 0.1 * carried_tick * i), 1e-12) << i;
  }
  EXPECT_EQ(carried.added_to(carried_push(2), carried_rate, Vec3::Zero(), carried_tick).force.z(),
            2);
}

TEST(CarriedForce, a_hand_that_goes_the_way_of_the_change_slows_it_down_and_no_other) {
  CarriedForce carried;
  const auto after_a_tick = [&](double velocity) {
    carried.carry(carried_push(1), carried_push(2));  // it rises
    return carried.added_to(carried_push(2), carried_rate, Vec3(0, 0, velocity), carried_tick)
               .force.z() -
           1;
  };
  EXPECT_NEAR(after_a_tick(0), 0.01, 1e-12);
  EXPECT_NEAR(after_a_tick(-1), 0.01, 1e-12) << "pressed in";
  EXPECT_NEAR(after_a_tick(slow_enough / 2), 0.005, 1e-12);
  EXPECT_NEAR(after_a_tick(1), 0.0001, 1e-12);
}

// Besides the rate, in 50 ms, and in proportion below slow_enough.
TEST(CarriedForce, what_only_pushes_the_handle_along_ends_soon) {
  CarriedForce carried;
  const auto after_a_tick = [&](double velocity) {
    carried.carry(carried_push(3), carried_push(1));
    return carried.added_to(carried_push(1), carried_rate, Vec3(0, 0, velocity), carried_tick)
        .force.z();
  };
  EXPECT_NEAR(after_a_tick(1), 3 - 0.01 - 2 / 0.05 * carried_tick, 1e-12);
  EXPECT_NEAR(after_a_tick(slow_enough / 2), 3 - 0.01 - 1 / 0.05 * carried_tick, 1e-12);
  EXPECT_NEAR(after_a_tick(0), 3 - 0.01, 1e-12);
  EXPECT_NEAR(after_a_tick(-slow_enough / 2), 3 - 0.005, 1e-12) << "it is pressed against";
}

TEST(CarriedForce, it_never_pulls_where_the_coupling_pushes) {
  CarriedForce carried;
  carried.carry(carried_push(1), carried_push(3));
  EXPECT_EQ(
      carried.added_to(carried_push(1), carried_rate, Vec3::Zero(), carried_tick).force.norm(), 0);
  EXPECT_GT(carried.added_to(carried_push(3), carried_rate, Vec3::Zero(), carried_tick).force.z(),
            1);
}

TEST(CarriedForce, nothing_is_carried_over_an_end_or_what_is_no_number) {
  CarriedForce carried;
  carried.carry(carried_push(1), carried_push(2));
  carried.restart();
  EXPECT_EQ(carried.added_to(carried_push(2), carried_rate, Vec3::Zero(), carried_tick).force.z(),
            2);
  carried.carry(carried_push(std::numeric_limits<double>::quiet_NaN()), carried_push(2));
  EXPECT_EQ(carried.added_to(carried_push(2), carried_rate, Vec3::Zero(), carried_tick).force.z(),
            2);
  carried.carry(carried_push(1), carried_push(2));
  EXPECT_EQ(carried.added_to(carried_push(2), {.force = 0, .torque = 0}, Vec3::Zero(), carried_tick)
                .force.z(),
            2)
      << "no limit";
}

}  // namespace
}  // namespace sonde
