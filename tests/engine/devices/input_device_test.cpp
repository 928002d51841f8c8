// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/input_device.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <thread>

#include "engine/devices/force_protocol.hpp"
#include "tests/engine/devices/descriptors.hpp"
#include "tests/engine/devices/mock_hid.hpp"
#include "tests/support/allocation_counter.hpp"

namespace sonde::test {
namespace {

using namespace std::chrono_literals;
using force_protocol::PoseReport;
using force_protocol::WrenchReport;
using testing::HasSubstr;

/// Waits for something another thread does. The limit is for a test that fails.
template <class Condition>
bool comes_true(const Condition& condition) {
  const auto end = DeviceClock::now() + 30s;
  while (!condition()) {
    if (DeviceClock::now() > end) return false;
    std::this_thread::sleep_for(500us);
  }
  return true;
}

bool reaches(InputDevice& device, DeviceState state) {
  return comes_true([&] { return device.latest().state == state; });
}

/// A puck, and the host that reads it.
struct PuckTest : testing::Test {
  MockSystem system;
  MockHid puck{.descriptor = split_descriptor()};

  /// Comes back after unplug(), under the next number.
  void plug() {
    ++puck.number;
    system.plug(puck);
  }
  void unplug() { system.unplug(puck.number); }
  void send(const InputDevice& device, const Bytes& report) {
    const std::uint64_t before = device.status().reports;
    system.send(puck.number, report);
    ASSERT_TRUE(comes_true([&] { return device.status().reports > before; }));
  }
};
using SpaceMouseOverHid = PuckTest;

TEST_F(SpaceMouseOverHid, deflections_and_buttons_come_in_both_layouts) {
  const std::vector<Bytes> joint{words(1, {350, 175, -70, -350, -35, 210})};
  const std::vector<Bytes> split{words(1, {350, 175, -70}), words(2, {-350, -35, 210})};
  SixAxes expected;
  expected << 1, -0.5, 0.2, -1, 0.1, -0.6;
  for (const bool both : {true, false}) {
    puck.descriptor = both ? joint_descriptor() : split_descriptor();
    plug();
    InputDevice device;
    ASSERT_TRUE(reaches(device, DeviceState::ready)) << device.status().reason;
    EXPECT_EQ(device.status().name, "SpaceMouse Compact");
    EXPECT_EQ(device.status().path, puck.path());
    for (const Bytes& report : both ? joint : split) send(device, report);
    send(device, {3, 2, 0});
    ASSERT_TRUE(comes_true([&] { return device.latest().buttons == 2; }));
    // Held at the moment of the last report: how long ago that is depends on the machine.
    const DeviceSample last = device.latest(device.latest().time);
    EXPECT_LT((last.deflection - expected).norm(), 1e-15);
    EXPECT_EQ(device.status().refused, 0U);
    unplug();
  }
}

TEST_F(SpaceMouseOverHid, a_deflection_that_is_not_renewed_is_none_soon) {
  plug();
  InputDevice device;
  ASSERT_TRUE(reaches(device, DeviceState::ready));
  send(device, words(1, {350, 0, 0}));
  ASSERT_TRUE(reaches(device, DeviceState::silent));
  EXPECT_EQ(device.latest().deflection, SixAxes::Zero());
  ASSERT_TRUE(comes_true([&] { return device.status().state == DeviceState::silent; }));
  EXPECT_THAT(device.status().reason, HasSubstr("200 ms"));
  send(device, words(1, {0, 0, 0}));
  EXPECT_TRUE(reaches(device, DeviceState::ready));
}

TEST_F(SpaceMouseOverHid, at_62_hz_a_deflection_holds_from_one_report_to_the_next) {
  puck.descriptor = joint_descriptor();
  plug();
  InputDevice device;
  ASSERT_TRUE(reaches(device, DeviceState::ready));
  for (int i = 1; i <= 62; ++i) {
    send(device, words(1, {i, 0, 0, 0, 0, 0}));
    ASSERT_TRUE(comes_true([&] { return device.latest().count == static_cast<unsigned>(i); }));
    const auto arrived = device.latest().time;
    for (int ms = 0; ms <= 17; ++ms) {
      const DeviceSample sample = device.latest(arrived + ms * 1ms);
      ASSERT_EQ(sample.state, DeviceState::ready);
      ASSERT_DOUBLE_EQ(sample.deflection[0], i / 350.0);
    }
    std::this_thread::sleep_for(16ms);
  }
  EXPECT_EQ(device.status().connections, 1U);
}

TEST_F(SpaceMouseOverHid, unplugged_in_the_middle_it_is_found_again_under_another_path) {
  plug();
  InputDevice device;
  ASSERT_TRUE(reaches(device, DeviceState::ready));
  send(device, words(1, {350, 0, 0}));
  const std::uint32_t session = device.latest().session;
  unplug();
  ASSERT_TRUE(reaches(device, DeviceState::absent));
  EXPECT_EQ(device.latest().deflection, SixAxes::Zero());
  EXPECT_THAT(device.status().reason, HasSubstr("unplugged"));
  plug();
  ASSERT_TRUE(reaches(device, DeviceState::ready));
  EXPECT_EQ(device.status().path, puck.path());
  EXPECT_EQ(device.status().connections, 2U);
  EXPECT_GT(device.latest().session, session);
  EXPECT_EQ(device.latest().deflection, SixAxes::Zero()) << "of another connection";
  send(device, words(1, {0, 350, 0}));
  ASSERT_TRUE(comes_true([&] { return device.latest().count > 1; }));
  EXPECT_EQ(device.latest(device.latest().time).deflection[1], -1);
}

TEST_F(SpaceMouseOverHid, plugged_in_later_it_is_found) {
  InputDevice device;
  ASSERT_TRUE(comes_true([&] { return !device.status().reason.empty(); }));
  EXPECT_THAT(device.status().reason, HasSubstr("no 6-DoF device"));
  EXPECT_EQ(device.latest().state, DeviceState::absent);
  plug();
  EXPECT_TRUE(reaches(device, DeviceState::ready));
}

TEST_F(SpaceMouseOverHid, garbage_is_no_deflection_and_is_told) {
  plug();
  InputDevice device;
  ASSERT_TRUE(reaches(device, DeviceState::ready));
  send(device, words(1, {350, 0, 0}));
  for (int i = 0; i < 12; ++i) send(device, {0xee, 0xff, 0x00, 0x12});
  ASSERT_TRUE(reaches(device, DeviceState::faulty));
  EXPECT_EQ(device.latest().deflection, SixAxes::Zero());
  EXPECT_THAT(device.status().reason, HasSubstr("neither"));
  EXPECT_EQ(device.status().refused, 12U);
  send(device, words(1, {0, 0, 0}));
  EXPECT_TRUE(reaches(device, DeviceState::ready));
  EXPECT_EQ(device.status().reason, "");
}

TEST_F(SpaceMouseOverHid, the_light_goes_on_and_off_and_on_again_after_a_reconnection) {
  plug();
  InputDevice device;
  ASSERT_TRUE(reaches(device, DeviceState::ready));
  device.set_led(true);
  EXPECT_EQ(system.written(puck.number, 30000), (Bytes{4, 1}));
  device.set_led(false);
  EXPECT_EQ(system.written(puck.number, 30000), (Bytes{4, 0}));
  device.set_led(true);
  EXPECT_EQ(system.written(puck.number, 30000), (Bytes{4, 1}));
  unplug();
  plug();
  ASSERT_TRUE(comes_true([&] { return device.status().connections == 2; }));
  EXPECT_EQ(system.written(puck.number, 30000), (Bytes{4, 1}));
}

TEST_F(SpaceMouseOverHid, of_two_the_chosen_one_is_opened) {
  plug();
  puck.serial = "B2";
  plug();
  InputDevice device({.vendor = 0x256f, .product = 0xc635, .serial = "B2"});
  ASSERT_TRUE(reaches(device, DeviceState::ready));
  EXPECT_EQ(device.status().path, puck.path());
}

TEST_F(SpaceMouseOverHid, one_that_does_not_open_is_told_and_tried_again) {
  puck.descriptor_in_sysfs = false;
  plug();
  InputDevice device;
  ASSERT_TRUE(reaches(device, DeviceState::refused));
  EXPECT_THAT(device.status().reason, HasSubstr(puck.path() + ": its report descriptor"));
  unplug();
  puck.descriptor_in_sysfs = true;
  plug();
  EXPECT_TRUE(reaches(device, DeviceState::ready));
}

/// The reference device of the open force protocol: what a firmware does, on the other end of a
/// node that the real hidapi has open.
struct ForceTest : testing::Test {
  int number = 7;
  MockSystem system;
  PoseReport pose;
  WrenchReport heard;  ///< the newest
  int wrenches = 0;
  Bytes arrived;  ///< the node knows no ends of reports: a wrench may come in two parts

  void plug() {
    const auto descriptor = force_protocol::report_descriptor();
    // By its own word slow, so that it is half a second until a busy machine makes it silent.
    const auto feature = force_protocol::encode(force_protocol::Limits{.rate_hz = 10,
                                                                       .max_force = 8,
                                                                       .max_torque = 0.25,
                                                                       .reach = Vec3::Constant(0.2),
                                                                       .buttons = 2});
    system.plug({.number = ++number,
                 .vendor = 0x1209,
                 .product = 0x0001,
                 .name = "Home-made",
                 .descriptor = {descriptor.begin(), descriptor.end()},
                 .feature = {feature.begin(), feature.end()}});
  }

  /// Reads the wrenches sent so far.
  void listen(int milliseconds) {
    const Bytes more = system.written(number, milliseconds);
    arrived.insert(arrived.end(), more.begin(), more.end());
    for (; arrived.size() >= WrenchReport::bytes;
         arrived.erase(arrived.begin(), arrived.begin() + WrenchReport::bytes)) {
      const auto report = force_protocol::decode_wrench(arrived);
      ASSERT_TRUE(report);
      if (wrenches++ > 0) {
        ASSERT_EQ(report->sequence, static_cast<std::uint16_t>(heard.sequence + 1));
      }
      heard = *report;
    }
  }

  /// Sends the pose as the next one, and waits until the host has read it.
  void step(const InputDevice& device) {
    ++pose.sequence;
    pose.time_us += 1000;
    const std::uint64_t before = device.status().reports;
    system.send(number, force_protocol::encode(pose));
    ASSERT_TRUE(comes_true([&] {
      listen(0);
      return device.status().reports > before;
    }));
  }

  /// Sends poses until the host has understood them.
  void settle(InputDevice& device) {
    ASSERT_TRUE(comes_true([&] { return device.status().connections > connections; }));
    connections = device.status().connections;
    wrenches = 0;
    heard = {};
    arrived.clear();
    ASSERT_TRUE(comes_true([&] {
      step(device);
      return device.latest().state == DeviceState::ready;
    }));
  }
  std::uint32_t connections = 0;
};
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
