// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/device_hand.hpp"

#include "tests/engine/devices/over_hid.hpp"
#include "tests/support/allocation_counter.hpp"

namespace sonde::test {
namespace {

using DeviceHandOverHid = ForceTest;
using PuckHandOverHid = PuckTest;

const Vec3 com(0.01, -0.02, 0.03);
const Pose start{Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized())), Vec3(0.1, 0.2, 0.3)};

/// The device's axes in the scene are turned by a quarter about x, its ways five times as long.
DeviceSettings in_y_up() {
  DeviceSettings settings;
  settings.frame = DeviceSettings::Frame::y_up;
  settings.scaling = 5;
  return settings;
}

TEST_F(DeviceHandOverHid, the_handle_moves_the_probe_and_feels_its_wrench) {
  plug();
  const auto device = std::make_shared<InputDevice>();
  settle(*device);
  DeviceHand by_device(device, in_y_up(), com, start);
  const Hand hand = by_device.hand();
  // Follows to where the handle stands: any number of ticks may fall between two reports.
  const auto probe_moved_by = [&](const Vec3& by) {
    return comes_true([&] {
      step(*device);
      const HandSample now = hand.sample(0.001);
      return now.trusted && (now.X_FM * com - start * com - by).norm() < 1e-6;
    });
  };
  ASSERT_TRUE(probe_moved_by(Vec3::Zero()));
  pose.X_BH.p = Vec3(0.001, 0.002, 0.003);
  ASSERT_TRUE(probe_moved_by(5 * Vec3(0.001, 0.003, -0.002)));
  // Five times the force, in the device's axes; the torque as it is.
  const Wrench wrench{.force = Vec3(0.1, 0.2, 0.3), .torque = Vec3(0.01, 0.02, 0.03)};
  ASSERT_TRUE(comes_true([&] {
    step(*device);
    const bool trusted = hand.sample(0.001).trusted;
    hand.render(wrench);
    return trusted && heard.on && (heard.wrench.force - Vec3(0.5, -1.5, 1)).norm() < 1e-5 &&
           (heard.wrench.torque - Vec3(0.01, -0.03, 0.02)).norm() < 1e-6;
  }));
}

TEST_F(DeviceHandOverHid, the_button_opens_the_clutch_and_the_force_is_zero) {
  plug();
  const auto device = std::make_shared<InputDevice>();
  settle(*device);
  DeviceHand by_device(device, in_y_up(), com, start);
  const Hand hand = by_device.hand();
  HandSample now;
  const auto tick = [&] {
    step(*device);
    now = hand.sample(0.001);
    hand.render({.force = now.held ? Vec3(1, 0, 0) : Vec3(0, 0, 0)});
  };
  ASSERT_TRUE(comes_true([&] {
    tick();
    return now.trusted && heard.on && heard.wrench.force.norm() > 4;
  }));
  pose.buttons = 1;
  ASSERT_TRUE(comes_true([&] {
    tick();
    return by_device.clutch_open();
  }));
  EXPECT_FALSE(now.held);
  for (int i = 0; i < 10; ++i) {
    pose.X_BH.p.x() += 0.002;
    tick();
  }
  EXPECT_LT((now.X_FM * com - start * com).norm(), 1e-14);
  EXPECT_TRUE(comes_true([&] {
    tick();
    return heard.wrench.force.isZero(0);
  }));
  pose.buttons = 0;
  ASSERT_TRUE(comes_true([&] {
    tick();
    return !by_device.clutch_open() && now.trusted;
  }));
  EXPECT_LT((now.X_FM * com - start * com).norm(), 1e-14) << "released, it does not jump";
}

TEST_F(PuckHandOverHid, a_push_moves_the_probe_until_the_puck_is_unplugged) {
  plug();
  const auto device = std::make_shared<InputDevice>();
  ASSERT_TRUE(reaches(*device, DeviceState::ready));
  DeviceSettings settings;
  settings.frame = DeviceSettings::Frame::scene;
  DeviceHand by_device(device, settings, com, start);
  const Hand hand = by_device.hand();
  send(*device, words(1, {350, 0, 0}));
  HandSample now;
  ASSERT_TRUE(comes_true([&] {
    now = hand.sample(0.001);
    if (device->latest().state == DeviceState::silent) send(*device, words(1, {350, 0, 0}));
    return (now.X_FM.p - start.p).x() > 0.01;
  }));
  EXPECT_TRUE(now.trusted);
  unplug();
  ASSERT_TRUE(comes_true([&] { return !hand.sample(0.001).trusted; }));
  const Vec3 there = hand.sample(0.001).X_FM.p;
  EXPECT_EQ(hand.sample(0.001).X_FM.p, there);
  plug();
  EXPECT_TRUE(comes_true([&] { return hand.sample(0.001).trusted; }));
  EXPECT_LT((hand.sample(0.001).X_FM.p - there).norm(), 1e-14);
}

TEST_F(PuckHandOverHid, its_servo_side_neither_allocates_nor_frees) {
  plug();
  const auto device = std::make_shared<InputDevice>();
  ASSERT_TRUE(reaches(*device, DeviceState::ready));
  DeviceHand by_device(device, {}, com, start);
  const Hand hand = by_device.hand();
  send(*device, words(1, {350, 0, 0}));
  Vec3 sum = Vec3::Zero();
  AllocationCounter counter;
  for (int i = 0; i < 1000; ++i) {
    if (i % 10 == 0) by_device.set_settings(in_y_up());
    by_device.set_view(start.q);
    sum += hand.sample(0.001).X_FM.p;
    hand.render({.force = Vec3(1, 0, 0)});
  }
  counter.stop();
  EXPECT_EQ(counter.allocations() + counter.frees(), 0U);
  EXPECT_TRUE(sum.allFinite());
}

}  // namespace
}  // namespace sonde::test
