// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "engine/devices/force_protocol.hpp"
#include "engine/devices/input_device.hpp"
#include "tests/engine/devices/descriptors.hpp"
#include "tests/engine/devices/mock_hid.hpp"

namespace sonde::test {

/// Waits for something another thread does. The limit is for a test that fails.
template <class Condition>
bool comes_true(const Condition& condition) {
  const auto end = DeviceClock::now() + std::chrono::seconds(30);
  while (!condition()) {
    if (DeviceClock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::microseconds(500));
  }
  return true;
}

inline bool reaches(InputDevice& device, DeviceState state) {
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
/// The reference device of the open force protocol: what a firmware does, on the other end of a
/// node that the real hidapi has open.
struct ForceTest : testing::Test {
  int number = 7;
  MockSystem system;
  force_protocol::PoseReport pose;
  force_protocol::WrenchReport heard;  ///< the newest
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
    using force_protocol::WrenchReport;
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
}  // namespace sonde::test
