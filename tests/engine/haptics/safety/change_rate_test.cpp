// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/safety/change_rate.hpp"

#include <gtest/gtest.h>

namespace sonde {
namespace {

// Reference: by hand. The probe's force is a `ratio`-th of the hand's.
TEST(ChangeRate, at_the_probe_is_that_of_the_hand_by_the_ratios) {
  const ChangeRate rate = change_rate_at_probe({10, 0.5}, 100, 100, 4, 0.25);
  EXPECT_EQ(rate.force, 2.5);
  EXPECT_EQ(rate.torque, 2);
  const ChangeRate unknown = change_rate_at_probe({10, 0.5}, 100, 100, 0, 0);
  EXPECT_EQ(unknown.force, 10);
  EXPECT_EQ(unknown.torque, 0.5);
}

TEST(ChangeRate, the_whole_of_a_device_takes_a_second_at_least) {
  const ChangeRate rate = change_rate_at_probe({10, 0.5}, 3, 0.125, 2, 1);
  EXPECT_EQ(rate.force, 1.5);
  EXPECT_EQ(rate.torque, 0.125);
  const ChangeRate without_limits = change_rate_at_probe({10, 0.5}, 0, 0, 1, 1);
  EXPECT_EQ(without_limits.force, 10);
  EXPECT_EQ(without_limits.torque, 0.5);
}

TEST(ChangeRate, no_limit_stays_none) {
  const ChangeRate rate = change_rate_at_probe({0, -1}, 3, 3, 2, 2);
  EXPECT_EQ(rate.force, 0);
  EXPECT_EQ(rate.torque, 0);
}

// Reference: by hand.
TEST(ChangeRate, a_step_makes_the_share_that_the_slower_of_force_and_torque_allows) {
  Wrench change;
  change.force = Vec3(0, 3, 4);                              // 5 N
  change.torque = Vec3(0, 0, -0.25);                         // N·m
  EXPECT_EQ(share_of_change(change, {10, 1}, 0.125), 0.25);  // force: 1.25 of 5; torque: a half
  EXPECT_EQ(share_of_change(change, {10, 0.25}, 0.125), 0.125);
  EXPECT_EQ(share_of_change(change, {10, 1}, 10), 1);      // no more than all
  EXPECT_EQ(share_of_change(change, {0, 1}, 0.125), 0.5);  // no limit of the force
  EXPECT_EQ(share_of_change(change, {10, 0}, 0.125), 0.25);
  EXPECT_EQ(share_of_change(change, {0, 0}, 0.125), 1);
  EXPECT_EQ(share_of_change({}, {10, 1}, 0.125), 1);  // nothing to change
  EXPECT_EQ(share_of_change(change, {10, 1}, 0), 0);
}

}  // namespace
}  // namespace sonde
