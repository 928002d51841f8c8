// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "tests/engine/devices/over_hid.hpp"

namespace sonde::test {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
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

TEST_F(SpaceMouseOverHid, of_two_alike_the_node_asked_for_is_opened_and_never_the_other) {
  puck.descriptor = joint_descriptor();
  puck.serial = "";
  plug();
  const int first = puck.number;
  plug();
  const int second = puck.number;
  for (const int number : {first, second}) {
    const std::string node = "/dev/hidraw" + std::to_string(number);
    InputDevice device({.vendor = 0x256f, .product = 0xc635, .path = node});
    ASSERT_TRUE(reaches(device, DeviceState::ready));
    EXPECT_EQ(device.status().path, node);
  }
  InputDevice device({.path = "/dev/hidraw" + std::to_string(second)});
  ASSERT_TRUE(reaches(device, DeviceState::ready));
  unplug();  // the second
  ASSERT_TRUE(reaches(device, DeviceState::absent));
  plug();  // under a number of its own, as the system may give it
  ASSERT_TRUE(reaches(device, DeviceState::ready));
  EXPECT_EQ(device.status().path, puck.path()) << "not the first, which was there before";
  send(device, words(1, {350, 0, 0, 0, 0, 0}));
  system.send(first, words(1, {0, 350, 0, 0, 0, 0}));
  ASSERT_TRUE(comes_true([&] { return device.latest().count >= 1; }));
  EXPECT_EQ(device.status().reports, 1u);
  system.unplug(first);
}

TEST_F(SpaceMouseOverHid, two_alike_without_serial_numbers_are_told_apart_by_their_ports) {
  puck.serial = "";
  const auto plug_into = [&](const char* port) {
    puck.port = port;
    plug();
    return puck.number;
  };
  const int left = plug_into("1"), right = plug_into("2");
  InputDevice device({.path = "/dev/hidraw" + std::to_string(right)});
  ASSERT_TRUE(reaches(device, DeviceState::ready));
  EXPECT_EQ(device.status().port, "usb-0000:00:14.0-2/input0");
  // The hub loses power: both are back under new nodes, the other one first.
  system.unplug(left);
  system.unplug(right);
  ASSERT_TRUE(reaches(device, DeviceState::absent));
  const int left_again = plug_into("1");
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));  // it has looked in the meantime
  EXPECT_EQ(device.status().state, DeviceState::absent) << "not the other one's port";
  const int right_again = plug_into("2");
  ASSERT_TRUE(reaches(device, DeviceState::ready));
  EXPECT_EQ(device.status().path, "/dev/hidraw" + std::to_string(right_again));
  // Into a third port, the other one staying: it is the one that was not there.
  system.unplug(right_again);
  ASSERT_TRUE(reaches(device, DeviceState::absent));
  const int moved = plug_into("3");
  ASSERT_TRUE(reaches(device, DeviceState::ready));
  EXPECT_EQ(device.status().path, "/dev/hidraw" + std::to_string(moved));
  system.unplug(left_again);
}

TEST_F(SpaceMouseOverHid, back_under_another_node_before_its_loss_is_noticed_it_is_taken) {
  puck.serial = "";
  plug();
  InputDevice device({.vendor = 0x256f, .product = 0xc635, .path = puck.path()});
  ASSERT_TRUE(reaches(device, DeviceState::ready));
  const int before = puck.number;
  plug();
  system.unplug(before);
  ASSERT_TRUE(comes_true([&] { return device.status().connections == 2; }));
  EXPECT_EQ(device.status().path, puck.path());
}

TEST_F(SpaceMouseOverHid, a_serial_number_is_known_again_whatever_the_node) {
  plug();
  const int by_cable = puck.number;
  plug();  // the same one, by radio
  InputDevice device({.serial = "A1", .path = puck.path()});
  ASSERT_TRUE(reaches(device, DeviceState::ready));
  ASSERT_EQ(device.status().path, puck.path());
  unplug();
  ASSERT_TRUE(comes_true([&] { return device.status().connections == 2; }));
  EXPECT_EQ(device.status().path, "/dev/hidraw" + std::to_string(by_cable));
}

TEST_F(SpaceMouseOverHid, a_node_that_is_not_there_is_not_made_up_for_by_another) {
  puck.serial = "";
  plug();
  InputDevice device({.path = "/dev/hidraw99"});
  ASSERT_TRUE(comes_true([&] { return !device.status().reason.empty(); }));
  EXPECT_EQ(device.status().state, DeviceState::absent);
  EXPECT_THAT(device.status().reason, HasSubstr("/dev/hidraw99"));
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

}  // namespace
}  // namespace sonde::test
