// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/device_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "tests/engine/devices/motion_samples.hpp"
#include "tests/support/allocation_counter.hpp"

namespace sonde {
namespace {

using test::along;
using test::com;
using test::expect_near;
using test::handle_at;
using test::in_scene;
using test::pushed;
using test::same;
using test::start;

TEST(DeviceMotion, the_probe_begins_where_it_is_and_then_follows_the_handle) {
  DeviceMotion motion(in_scene(), com, start);
  const HandSample first = motion.move(handle_at({0.5, 0.5, 0.5}, 1), 0);
  expect_near(first.X_FM, start);
  EXPECT_TRUE(first.held);
  EXPECT_TRUE(first.trusted);
  const HandSample next = motion.move(handle_at({0.51, 0.5, 0.5}, 1), 0.001);
  EXPECT_LT((next.X_FM * com - start * com - Vec3(0.01, 0, 0)).norm(), 1e-15);
  const HandSample turned = motion.move(handle_at({0.51, 0.5, 0.5}, 1.2), 0.001);
  EXPECT_LT((turned.X_FM * com - next.X_FM * com).norm(), 1e-15) << "about the centre of mass";
  EXPECT_NEAR(turned.X_FM.q.angularDistance(start.q), 0.2, 1e-12);
}

TEST(DeviceMotion, the_clutch_holds_the_probe_to_the_bit_and_lets_it_go_without_a_jump) {
  DeviceSettings settings = in_scene();
  settings.clutch_button = 2;
  DeviceMotion motion(settings, com, start);
  motion.move(handle_at({0, 0, 0}), 0);
  const Pose before = motion.move(handle_at({0.01, 0, 0}, 0.1, 1), 0.001).X_FM;
  EXPECT_FALSE(motion.clutch_open()) << "another button";
  for (int i = 1; i <= 50; ++i) {
    const HandSample held = motion.move(handle_at({0.01 - 0.002 * i, 0, 0.001 * i}, 0.1, 2), 0.001);
    EXPECT_TRUE(same(held.X_FM, before));
    EXPECT_FALSE(held.held);
    EXPECT_TRUE(held.trusted);
    EXPECT_TRUE(motion.clutch_open());
    EXPECT_EQ(motion.on_handle({.force = Vec3(1, 2, 3)}).force, Vec3(0, 0, 0));
  }
  const HandSample released = motion.move(handle_at({-0.3, 0, 0.1}, 0.4), 0.001);
  expect_near(released.X_FM, before);
  EXPECT_TRUE(released.held);
  const HandSample after = motion.move(handle_at({-0.3, 0.02, 0.1}, 0.4), 0.001);
  EXPECT_LT((after.X_FM * com - before * com - Vec3(0, 0.02, 0)).norm(), 1e-15);
}

TEST(DeviceMotion, nothing_jumps_when_the_device_comes_back_or_something_is_changed) {
  DeviceMotion motion(in_scene(), com, start);
  motion.move(handle_at({0, 0, 0}), 0);
  const Pose before = motion.move(handle_at({0.01, 0.02, 0}, 0.3), 0.001).X_FM;
  DeviceSample lost = handle_at({9, 9, 9}, 2);
  lost.state = DeviceState::silent;
  for (const DeviceState state : {DeviceState::silent, DeviceState::faulty, DeviceState::absent}) {
    lost.state = state;
    const HandSample without = motion.move(lost, 0.001);
    EXPECT_FALSE(without.trusted);
    EXPECT_TRUE(same(without.X_FM, before));
  }
  DeviceSample back = handle_at({-0.05, 0, 0}, -0.5);
  expect_near(motion.move(back, 0.001).X_FM, before);
  back.session = 2;  // it was gone, between two ticks
  back.X_BH.p.x() = 0.05;
  expect_near(motion.move(back, 0.001).X_FM, before);
  DeviceSettings other = in_scene();
  other.scaling = 7;
  motion.set_settings(other);
  expect_near(motion.move(back, 0.001).X_FM, before);
  back.X_BH.p.x() += 0.001;
  EXPECT_LT((motion.move(back, 0.001).X_FM.p - before.p - Vec3(0.007, 0, 0)).norm(), 1e-14);
}

TEST(DeviceMotion, a_wrench_goes_back_to_the_device_that_tells_positions) {
  DeviceMotion motion(in_scene(), com, start);
  const Wrench wrench{.force = Vec3(1, 2, 3), .torque = Vec3(4, 5, 6)};
  motion.move(handle_at({0, 0, 0}), 0);
  EXPECT_EQ(motion.on_handle(wrench).force, wrench.force);
  EXPECT_LT((motion.on_handle(wrench).torque - wrench.torque).norm(), 1e-14);
  DeviceSample faulty = handle_at({0, 0, 0});
  faulty.state = DeviceState::faulty;
  motion.move(faulty, 0.001);
  EXPECT_EQ(motion.on_handle(wrench).force, Vec3(0, 0, 0));
  motion.move(pushed(along(0, 1)), 0.001);
  EXPECT_EQ(motion.on_handle(wrench).force, Vec3(0, 0, 0)) << "a puck";
}

TEST(DeviceMotion, by_rate_a_deflection_is_a_velocity) {
  DeviceSettings settings = in_scene();
  settings.reach = 0.05;
  settings.scaling = 2;
  settings.turn = 0.5;
  DeviceMotion motion(settings, com, start);
  for (int i = 0; i < 100; ++i) motion.move(pushed(along(1, 0.5)), 0.001);
  const Pose moved = motion.move(pushed(along(5, 1)), 0).X_FM;
  EXPECT_LT((moved * com - start * com - Vec3(0, 0.1 * 0.5 * 2 * 0.05, 0)).norm(), 1e-14);
  Pose turned;
  for (int i = 0; i < 100; ++i) turned = motion.move(pushed(along(5, 1)), 0.002).X_FM;
  EXPECT_LT((turned * com - moved * com).norm(), 1e-14);
  EXPECT_NEAR(turned.q.angularDistance(moved.q), 0.2 * 0.5, 1e-12);
  const Pose rest = motion.move(pushed(SixAxes::Zero()), 0.001).X_FM;
  EXPECT_TRUE(same(motion.move(pushed(SixAxes::Zero()), 1).X_FM, rest)) << "let go, it stays";
}

TEST(DeviceMotion, by_position_a_deflection_is_a_displacement) {
  DeviceSettings settings = in_scene();
  settings.control = DeviceSettings::Control::position;
  DeviceMotion motion(settings, com, start);
  motion.move(pushed(SixAxes::Zero()), 0);
  const Pose there = motion.move(pushed(along(2, 0.5)), 0.001).X_FM;
  EXPECT_LT((there * com - start * com - Vec3(0, 0, 0.05)).norm(), 1e-15);
  // The clutch moves the place of rest.
  EXPECT_TRUE(same(motion.move(pushed(along(2, 0.1), 1), 0.001).X_FM, there));
  expect_near(motion.move(pushed(along(2, -0.2)), 0.001).X_FM, there);
  const Pose rest = motion.move(pushed(SixAxes::Zero()), 0.001).X_FM;
  EXPECT_LT((rest * com - there * com - Vec3(0, 0, 0.02)).norm(), 1e-15);
}

TEST(DeviceMotion, a_silent_puck_is_let_go_and_an_absent_one_is_not_trusted) {
  DeviceMotion motion(in_scene(), com, start);
  const Pose before = motion.move(pushed(along(0, 1)), 0.001).X_FM;
  DeviceSample silent = pushed(SixAxes::Zero());
  silent.state = DeviceState::silent;
  const HandSample still = motion.move(silent, 0.001);
  EXPECT_TRUE(still.trusted);
  EXPECT_TRUE(same(still.X_FM, before));
  silent.state = DeviceState::absent;
  EXPECT_FALSE(motion.move(silent, 0.001).trusted);
}

TEST(DeviceMotion, smoothing_is_a_first_order_lag_that_ends) {
  DeviceSettings settings = in_scene();
  settings.control = DeviceSettings::Control::position;
  settings.reach = 1;
  settings.smoothing = 0.03;
  DeviceMotion motion(settings, com, start);
  motion.move(pushed(SixAxes::Zero()), 0);
  Pose at;
  for (int i = 0; i < 30; ++i) at = motion.move(pushed(along(0, 1)), 0.001).X_FM;
  EXPECT_NEAR(at.p.x() - start.p.x(), 1 - std::exp(-1), 1e-12);
  for (int i = 0; i < 400; ++i) at = motion.move(pushed(SixAxes::Zero()), 0.001).X_FM;
  EXPECT_TRUE(same(motion.move(pushed(SixAxes::Zero()), 0.001).X_FM, at));
  expect_near(at, start);
}

TEST(DeviceMotion, right_away_and_up_lie_where_the_frame_says) {
  // The picture is seen from the scene's +x, z up: its right is y, its eye x.
  Mat3 R_FV;
  R_FV << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  struct Case {
    DeviceSettings::Frame frame;
    Vec3 right, away, up;
  };
  using Frame = DeviceSettings::Frame;
  for (const Case& c : {Case{Frame::scene, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                        Case{Frame::y_up, {1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
                        Case{Frame::view, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}}) {
    DeviceSettings settings = in_scene();
    settings.frame = c.frame;
    settings.reach = 100;
    DeviceMotion motion(settings, com, start);
    motion.set_view(Quat(R_FV));
    const Vec3 expected[] = {c.right, c.away, c.up};
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 before = motion.move(pushed(SixAxes::Zero()), 0).X_FM.p;
      const Vec3 after = motion.move(pushed(along(axis, 1)), 0.01).X_FM.p;
      EXPECT_LT((after - before - expected[axis]).norm(), 1e-14) << axis;
      motion.move(handle_at({0, 0, 0}), 0.001);
      const Vec3 handle = motion.move(handle_at(Vec3::Unit(axis)), 0.001).X_FM.p;
      EXPECT_LT((handle - after - expected[axis]).norm(), 1e-14) << axis;
    }
  }
}

TEST(DeviceMotion, what_turns_the_force_lets_go_for_a_tick) {
  DeviceSettings settings = in_scene();
  DeviceMotion motion(settings, com, start);
  const auto held = [&] { return !motion.move(handle_at({0, 0, 0}), 0.001).changed; };
  EXPECT_TRUE(held());
  settings.axes.axes[0].inverted = true;
  motion.set_settings(settings);
  EXPECT_FALSE(held());
  EXPECT_TRUE(held());
  settings.axes.axes[0].inverted = false;
  motion.set_settings(settings);
  EXPECT_FALSE(motion.move(pushed(SixAxes::Zero()), 0.001).changed) << "a puck has no force";
}

// The torque on such a handle depends on the turn since the anchor, and any setting anchors anew.
TEST(DeviceMotion, of_a_handle_whose_turns_are_inverted_any_setting_takes_the_force) {
  for (const bool inverted : {false, true}) {
    DeviceSettings settings = in_scene();
    settings.axes.axes[5].inverted = inverted;
    DeviceMotion motion(settings, com, start);
    motion.move(handle_at({0, 0, 0}, 1.2), 0.001);
    motion.move(handle_at({0, 0, 0}, 1.2), 0.001);
    settings.smoothing = 0.1;
    motion.set_settings(settings);
    EXPECT_EQ(motion.move(handle_at({0, 0, 0}, 1.2), 0.001).changed, inverted);
  }
}

TEST(DeviceMotion, another_scaling_alone_is_told_and_takes_no_force) {
  DeviceSettings settings = in_scene();
  DeviceMotion motion(settings, com, start);
  EXPECT_EQ(motion.move(handle_at({0, 0, 0}), 0.001).rescaled, 1);
  settings.scaling *= 3;
  settings.smoothing *= 2;
  motion.set_settings(settings);
  settings.scaling /= 2;
  motion.set_settings(settings);
  const HandSample told = motion.move(handle_at({0, 0, 0}), 0.001);
  EXPECT_FALSE(told.changed);
  EXPECT_DOUBLE_EQ(told.rescaled, 1.5);
  EXPECT_EQ(motion.move(handle_at({0, 0, 0}), 0.001).rescaled, 1);
  settings.scaling *= 2;
  settings.frame = DeviceSettings::Frame::y_up;
  motion.set_settings(settings);
  EXPECT_TRUE(motion.move(handle_at({0, 0, 0}), 0.001).changed) << "the force turns too";
}

TEST(DeviceMotion, a_late_tick_does_not_fling_the_probe) {
  DeviceSettings settings = in_scene();
  settings.reach = 1;
  DeviceMotion motion(settings, com, start);
  const Vec3 before = motion.move(pushed(SixAxes::Zero()), 0).X_FM.p;
  const Vec3 after = motion.move(pushed(along(0, 1)), 0.19).X_FM.p;
  EXPECT_GT((after - before).norm(), 0.005);
  EXPECT_LT((after - before).norm(), 0.011);
}

// The servo samples more often than a device reports.
TEST(DeviceMotion, it_says_how_long_a_report_took) {
  DeviceMotion motion(in_scene(), com, start);
  using namespace std::chrono_literals;
  DeviceSample report = handle_at({0, 0, 0});
  const auto moved = [&] { return motion.move(report, 2.5e-4).since; };
  const auto next = [&](DeviceClock::duration after) {
    ++report.count;
    report.time += after;
  };
  motion.move(report, 0);
  next(1ms);
  EXPECT_DOUBLE_EQ(moved(), 1e-3);
  EXPECT_EQ(moved(), 0) << "the same report";
  next(4ms);
  EXPECT_DOUBLE_EQ(moved(), 4e-3);
  next(10s);
  ++report.session;
  EXPECT_EQ(moved(), 0) << "a gap is no motion";
  next(1ms);
  EXPECT_DOUBLE_EQ(moved(), 1e-3);
}

TEST(DeviceMotion, it_neither_allocates_nor_frees) {
  DeviceMotion motion(in_scene(), com, start);
  DeviceWrench felt;
  test::AllocationCounter counter;
  for (int i = 0; i < 100; ++i) {
    motion.set_settings(DeviceSettings{});
    motion.set_view(start.q);
    motion.place(start);
    motion.move(handle_at({0.001 * i, 0, 0}, 0.1 * i, i % 7 == 0), 0.001);
    motion.move(handle_at({0.001 * i, 0, 0}, 0.1 * i + 0.01), 0.001);
    felt = motion.on_handle({.force = Vec3(1, 2, 3)});
    motion.move(pushed(along(i % 6, 0.5)), 0.001);
  }
  counter.stop();
  EXPECT_EQ(counter.allocations(), 0U);
  EXPECT_EQ(counter.frees(), 0U);
  EXPECT_NE(felt.force, Vec3(0, 0, 0));
}

}  // namespace
}  // namespace sonde
