// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/axis_map.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/engine/devices/six.hpp"

namespace sonde::test {
namespace {

AxisMap without_dead_zones() {
  AxisMap map;
  for (AxisSetting& axis : map.axes) axis.dead_zone = 0;
  return map;
}

TEST(AxisMap, signs_swaps_and_gains_are_per_axis) {
  AxisMap map = without_dead_zones();
  map.axes[0] = {.source = 1, .inverted = true, .gain = 2, .dead_zone = 0};
  map.axes[1] = {.source = 0, .inverted = false, .gain = 0.5, .dead_zone = 0};
  map.axes[5].gain = 0;
  EXPECT_EQ(mapped(map, six(0.25, 0.5, 0.75, -1, 1, 1)), six(-1, 0.125, 0.75, -1, 1, 0));
}

TEST(AxisMap, the_dead_zone_has_no_step_and_full_deflection_stays_full) {
  AxisMap map;
  map.axes[0].dead_zone = 0.2;
  const auto x = [&](double value) { return mapped(map, six(value, 0, 0, 0, 0, 0))[0]; };
  EXPECT_EQ(x(0.2), 0);
  EXPECT_EQ(x(-0.2), 0);
  EXPECT_NEAR(x(0.2 + 1e-9), 0, 1e-8);
  EXPECT_DOUBLE_EQ(x(0.6), 0.5);
  EXPECT_DOUBLE_EQ(x(-1), -1);
  EXPECT_DOUBLE_EQ(x(7), 1) << "no further than full";
}

TEST(AxisMap, the_curve_is_finer_near_rest_odd_rising_and_full_at_the_end) {
  AxisMap map = without_dead_zones();
  map.axes[0].expo = 0.5;
  const auto x = [&](double value) { return mapped(map, six(value, 0, 0, 0, 0, 0))[0]; };
  EXPECT_DOUBLE_EQ(x(0.5), 0.5 * 0.5 + 0.5 * 0.125);
  EXPECT_DOUBLE_EQ(x(1), 1);
  for (double v = 0; v < 1; v += 0.01) {
    EXPECT_LT(x(v), x(v + 0.01));
    EXPECT_DOUBLE_EQ(x(-v), -x(v));
  }
  map.axes[0].expo = 1;
  EXPECT_DOUBLE_EQ(x(0.5), 0.125) << "the cube";
  map.axes[0].dead_zone = 0.2;
  EXPECT_DOUBLE_EQ(x(0.6), 0.125) << "of what is beyond the dead zone";
}

TEST(AxisMap, a_source_that_is_no_axis_gives_nothing) {
  AxisMap map = without_dead_zones();
  map.axes[0].source = 6;
  map.axes[1].source = -1;
  EXPECT_EQ(mapped(map, SixAxes::Ones()), six(0, 0, 1, 1, 1, 1));
}

TEST(AxisMap, position_control_moves_and_turns_in_the_fixed_frame) {
  const Pose rest{Quat(Eigen::AngleAxisd(0.7, Vec3::UnitX())), Vec3(1, 2, 3)};
  const Reach reach{.translation = 0.1, .rotation = std::numbers::pi / 2};
  const Pose moved = position_controlled(rest, six(1, -0.5, 0, 0, 0, 1), reach);
  EXPECT_LT((moved.p - Vec3(1.1, 1.95, 3)).norm(), 1e-15);
  const Quat expected = Quat(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ())) * rest.q;
  EXPECT_LT(moved.q.angularDistance(expected), 1e-15);
  const Pose still = position_controlled(rest, SixAxes::Zero(), reach);
  EXPECT_EQ(still.p, rest.p);
  EXPECT_LT(still.q.angularDistance(rest.q), 1e-15);
}

TEST(AxisMap, a_rate_held_for_a_second_leads_as_far_as_it_says) {
  const Reach rate{.translation = 0.2, .rotation = 0.9};
  Pose pose;
  for (int i = 0; i < 1000; ++i) pose = rate_controlled(pose, six(0, 0, -1, 0, 1, 0), rate, 0.001);
  EXPECT_LT((pose.p - Vec3(0, 0, -0.2)).norm(), 1e-12);
  EXPECT_LT(pose.q.angularDistance(Quat(Eigen::AngleAxisd(0.9, Vec3::UnitY()))), 1e-12);
}

TEST(AxisMap, smoothing_does_not_depend_on_the_size_of_the_steps) {
  const SixAxes target = SixAxes::Ones();
  SixAxes fine = SixAxes::Zero();
  for (int i = 0; i < 16; ++i) fine = smoothed(fine, target, 0.001, 0.03);
  const SixAxes coarse = smoothed(SixAxes::Zero(), target, 0.016, 0.03);
  EXPECT_LT((fine - coarse).norm(), 1e-14);
  EXPECT_NEAR(coarse[0], 1 - std::exp(-0.016 / 0.03), 1e-15);
  EXPECT_EQ(smoothed(SixAxes::Zero(), target, 0.001, 0), target);
}

}  // namespace
}  // namespace sonde::test
