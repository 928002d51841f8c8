// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <limits>

#include "tests/engine/devices/over_hid.hpp"
#include "tests/support/allocation_counter.hpp"

namespace sonde::test {
namespace {

using force_protocol::PoseReport;
using testing::HasSubstr;
using ForceDeviceOverHid = ForceTest;

/// Something to feel: a spring towards the origin, in translation and rotation.
DeviceWrench spring(const Pose& X_BH) {
  return {-20 * X_BH.p, -0.1 * 2 * X_BH.q.w() * X_BH.q.vec()};
}

TEST_F(ForceDeviceOverHid, the_loop_is_closed_pose_in_wrench_out) {
  plug();
  InputDevice device;
  settle(device);
  EXPECT_EQ(device.status().name, "Home-made");
  EXPECT_EQ(device.status().capabilities.max_force, 8);
  for (int i = 0; i < 200; ++i) {
    pose.X_BH.p = Vec3(0.15 * std::sin(0.02 * i), 0.001 * (i % 20), -0.0005 * i);
    pose.X_BH.q = Quat(Eigen::AngleAxisd(0.01 * i, Vec3(1, 2, 2) / 3));
    const std::uint64_t count = device.latest().count;
    step(device);
    ASSERT_TRUE(comes_true([&] {
      // A machine that stood still for too long makes the host ask for a new run of poses.
      if (device.latest().state != DeviceState::ready) step(device);
      return device.latest().count > count;
    }));
    device.set_wrench(spring(device.latest().X_BH));
    // The device checks what it gets against its own pose; both are rounded to float 32.
    const DeviceWrench expected = spring(pose.X_BH);
    ASSERT_TRUE(comes_true([&] {
      if (device.latest().state != DeviceState::ready) step(device);
      device.set_wrench(spring(device.latest().X_BH));
      listen(10);
      return heard.on && (heard.wrench.force - expected.force).norm() < 1e-5 &&
             (heard.wrench.torque - expected.torque).norm() < 1e-6;
    })) << i;
  }
  EXPECT_EQ(device.status().lost, 0U);
  EXPECT_EQ(device.status().refused, 0U);
}

TEST_F(ForceDeviceOverHid, a_wrench_is_limited_to_what_the_device_can) {
  plug();
  InputDevice device;
  settle(device);
  ASSERT_TRUE(comes_true([&] {
    device.set_wrench({{300, 0, 400}, {0, 3, 0}});
    step(device);
    return heard.on;
  }));
  EXPECT_LT((heard.wrench.force - Vec3(4.8, 0, 6.4)).norm(), 1e-5);
  EXPECT_LT((heard.wrench.torque - Vec3(0, 0.25, 0)).norm(), 1e-6);
}

TEST_F(ForceDeviceOverHid, a_pose_that_cannot_be_true_switches_the_force_off) {
  struct Case {
    const char* reason;
    void (*spoil)(PoseReport&);
  };
  const Case cases[] = {
      {"finite", [](PoseReport& r) { r.X_BH.p.z() = std::numeric_limits<double>::quiet_NaN(); }},
      {"1000 mm", [](PoseReport& r) { r.X_BH.p.x() = 1; }},
      {"jumped 200 mm", [](PoseReport& r) { r.X_BH.p.x() = 0.2; }},
      {"fault of its own", [](PoseReport& r) { r.fault = true; }},
  };
  plug();
  InputDevice device;
  settle(device);
  for (const Case& bad : cases) {
    ASSERT_TRUE(comes_true([&] {
      device.set_wrench({{1, 0, 0}, {0, 0, 0}});
      step(device);
      return heard.on;
    })) << bad.reason;
    const std::uint32_t session = device.latest().session;
    const PoseReport good = pose;
    bad.spoil(pose);
    device.set_wrench({{1, 0, 0}, {0, 0, 0}});
    step(device);
    ASSERT_TRUE(comes_true([&] {
      device.set_wrench({{1, 0, 0}, {0, 0, 0}});
      listen(10);
      return !heard.on;
    }));
    EXPECT_EQ(heard.wrench.force, Vec3::Zero());
    EXPECT_EQ(device.latest().state, DeviceState::faulty);
    EXPECT_THAT(device.status().reason, HasSubstr(bad.reason));
    pose.X_BH = good.X_BH;
    pose.fault = false;
    ASSERT_TRUE(comes_true([&] {
      step(device);
      return device.latest().state == DeviceState::ready;
    }));
    EXPECT_GT(device.latest().session, session) << "what came before is no neighbour";
  }
  EXPECT_EQ(device.status().connections, 1U);
}

TEST_F(ForceDeviceOverHid, garbage_and_silence_switch_the_force_off) {
  plug();
  InputDevice device;
  settle(device);
  const auto pull = [&] {
    device.set_wrench({{1, 0, 0}, {0, 0, 0}});
    step(device);
    return heard.on;
  };
  const auto off = [&] {
    device.set_wrench({{1, 0, 0}, {0, 0, 0}});
    listen(10);
    return !heard.on;
  };
  ASSERT_TRUE(comes_true(pull));
  system.send(number, Bytes{9, 8, 7});
  ASSERT_TRUE(comes_true(off));
  EXPECT_THAT(device.status().reason, HasSubstr("no pose report"));
  ASSERT_TRUE(comes_true(pull));
  ASSERT_TRUE(comes_true(off)) << "nothing more is sent";
  EXPECT_EQ(device.latest().state, DeviceState::silent);
}

TEST_F(ForceDeviceOverHid, a_wrench_that_is_not_renewed_is_switched_off) {
  plug();
  InputDevice device;
  settle(device);
  ASSERT_TRUE(comes_true([&] {
    device.set_wrench({{1, 0, 0}, {0, 0, 0}});
    step(device);
    return heard.on;
  }));
  ASSERT_TRUE(comes_true([&] {
    step(device);
    return !heard.on && device.latest().state == DeviceState::ready;
  }));
}

TEST_F(ForceDeviceOverHid, vanished_in_the_middle_it_works_again_when_it_is_back) {
  plug();
  InputDevice device;
  settle(device);
  for (int round = 0; round < 2; ++round) {
    system.unplug(number);
    ASSERT_TRUE(reaches(device, DeviceState::absent));
    plug();
    settle(device);
    ASSERT_TRUE(comes_true([&] {
      device.set_wrench({{1, 0, 0}, {0, 0, 0}});
      step(device);
      return heard.on;
    }));
  }
  EXPECT_EQ(device.status().connections, 3U);
}

TEST_F(ForceDeviceOverHid, the_force_is_off_when_the_program_closes_it) {
  plug();
  {
    InputDevice device;
    settle(device);
    ASSERT_TRUE(comes_true([&] {
      device.set_wrench({{1, 0, 0}, {0, 0, 0}});
      step(device);
      return heard.on;
    }));
    device.set_wrench({{1, 0, 0}, {0, 0, 0}});
  }
  EXPECT_TRUE(comes_true([&] {
    listen(10);
    return !heard.on;
  }));
}

TEST_F(ForceDeviceOverHid, the_servos_side_allocates_nothing) {
  plug();
  InputDevice device;
  settle(device);
  AllocationCounter counter;
  double sum = 0;
  for (int i = 0; i < 1000; ++i) {
    sum += device.latest().X_BH.p.x();
    device.set_wrench({{sum, 0, 0}, {0, 0, 0}});
  }
  counter.stop();
  EXPECT_EQ(counter.allocations() + counter.frees(), 0U);
}

}  // namespace
}  // namespace sonde::test
