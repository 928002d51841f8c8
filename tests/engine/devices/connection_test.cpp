// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/connection.hpp"

#include <gmock/gmock.h>

#include "engine/base/error.hpp"
#include "tests/engine/devices/controller_descriptors.hpp"
#include "tests/engine/devices/descriptors.hpp"
#include "tests/engine/devices/mock_hid.hpp"

namespace sonde::test {
namespace {

using testing::HasSubstr;

force_protocol::Limits limits() {
  return {.max_force = 8, .max_torque = 0.25, .reach = Vec3::Constant(0.2), .buttons = 2};
}

MockHid force_device(const force_protocol::Limits& limits) {
  const auto descriptor = force_protocol::report_descriptor();
  const auto feature = force_protocol::encode(limits);
  return {.vendor = 0x1209,
          .product = 0x0001,
          .name = "Home-made",
          .descriptor = {descriptor.begin(), descriptor.end()},
          .feature = {feature.begin(), feature.end()}};
}

/// The one device that is listed.
DeviceListing only(const MockHid& device) {
  MockSystem system;
  system.plug(device);
  const auto all = list_devices();
  if (all.size() != 1) throw std::runtime_error(std::to_string(all.size()) + " devices listed");
  return all[0];
}

TEST(Connection, every_known_id_opens_in_both_layouts) {
  struct Family {
    std::uint16_t vendor;
    std::vector<std::uint16_t> products;
  };
  const Family families[] = {
      {0x046d,
       {0xc603, 0xc605, 0xc606, 0xc621, 0xc623, 0xc625, 0xc626, 0xc627, 0xc628, 0xc629, 0xc62b,
        0xc640}},
      {0x256f, {0xc62e, 0xc62f, 0xc631, 0xc632, 0xc633, 0xc635, 0xc636, 0xc638, 0xc63a, 0xc652}},
  };
  for (const Family& family : families)
    for (const std::uint16_t product : family.products)
      for (const Bytes& descriptor : {split_descriptor(), joint_descriptor()}) {
        const DeviceListing listing =
            only({.vendor = family.vendor, .product = product, .descriptor = descriptor});
        EXPECT_TRUE(listing.opens) << listing.reason;
        EXPECT_EQ(listing.kind, DeviceKind::space_mouse);
        EXPECT_TRUE(listing.capabilities.led);
        EXPECT_STREQ(name_of(listing.info).c_str(), space_mouse_name(family.vendor, product));
      }
}

TEST(Connection, of_a_receivers_interfaces_only_that_with_the_axes_is_a_device) {
  MockSystem system;
  const auto interface = [&](int number, int which, const Bytes& descriptor) {
    system.plug({.number = number,
                 .product = 0xc652,
                 .name = "Universal Receiver",
                 .interface = which,
                 .descriptor = descriptor});
  };
  interface(4, 0, mouse_descriptor());
  interface(5, 1, joint_descriptor());
  interface(6, 2,
            {0x06, 0x00, 0xff, 0x09, 0x01, 0xa1, 0x01, 0x75, 0x08, 0x95, 0x06, 0x09, 0x02, 0x81,
             0x02, 0xc0});
  const auto all = list_devices();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].info.path, "/dev/hidraw5");
  EXPECT_TRUE(all[0].opens);
}

TEST(Connection, mice_and_keyboards_are_left_alone) {
  MockSystem system;
  system.plug({.number = 1, .product = 0xc654, .descriptor = joint_descriptor()});
  system.plug({.number = 2, .vendor = 0x046d, .product = 0xc077, .descriptor = mouse_descriptor()});
  EXPECT_TRUE(list_devices().empty());
}

TEST(Connection, an_unknown_puck_is_taken_if_its_descriptor_names_six_axes) {
  EXPECT_TRUE(only({.vendor = 0x1234, .product = 5, .descriptor = joint_descriptor()}).opens);
  Bytes five = joint_descriptor();
  five[27] = 0x30;  // X a second time, in place of Rz
  const DeviceListing listing = only({.vendor = 0x1234, .product = 5, .descriptor = five});
  EXPECT_FALSE(listing.opens);
  EXPECT_THAT(listing.reason, HasSubstr("does not name six axes"));
}

TEST(Connection, joysticks_and_game_pads_open_if_they_have_sticks_enough) {
  const auto listing = [](const Bytes& descriptor) {
    return only({.vendor = 0x1234, .product = 6, .name = "Pad", .descriptor = descriptor});
  };
  for (const Bytes& descriptor :
       {dualshock_descriptor(), xbox_descriptor(), xbox_windows_descriptor(), f310_descriptor(),
        twist_descriptor(), six_axis_joystick_descriptor()}) {
    const DeviceListing pad = listing(descriptor);
    EXPECT_TRUE(pad.opens) << pad.reason;
    EXPECT_EQ(pad.kind, DeviceKind::controller);
    EXPECT_FALSE(pad.capabilities.position || pad.capabilities.force);
    EXPECT_EQ(pad.name, "Pad");
  }
  const DeviceListing cross = listing(cross_pad_descriptor());
  EXPECT_FALSE(cross.opens);
  EXPECT_THAT(cross.reason, HasSubstr("nor two sticks"));
}

TEST(Connection, garbage_for_a_descriptor_is_refused_in_a_line) {
  for (std::size_t kept : {6U, 20U, 25U}) {
    Bytes cut = dualshock_descriptor();
    cut.resize(kept);
    const DeviceListing pad = only({.vendor = 0x054c, .product = 0x09cc, .descriptor = cut});
    EXPECT_FALSE(pad.opens);
    EXPECT_THAT(pad.reason, HasSubstr("/dev/hidraw7: its report descriptor names neither"));
  }
}

TEST(Connection, what_is_made_for_six_degrees_comes_before_a_game_pad) {
  MockSystem system;
  system.plug({.number = 3, .vendor = 1, .product = 2, .descriptor = f310_descriptor()});
  system.plug({.number = 4, .descriptor = joint_descriptor()});
  const auto all = connected_devices();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].kind, DeviceKind::space_mouse);
  EXPECT_EQ(all[1].kind, DeviceKind::controller);
}

TEST(Connection, a_force_device_tells_what_it_can) {
  const DeviceListing listing = only(force_device(limits()));
  ASSERT_TRUE(listing.opens) << listing.reason;
  EXPECT_EQ(listing.kind, DeviceKind::force_device);
  EXPECT_EQ(name_of(listing.info), "Home-made");
  EXPECT_TRUE(listing.capabilities.position);
  EXPECT_EQ(listing.capabilities.max_force, 8);
  EXPECT_EQ(listing.capabilities.max_torque, 0.25);
  EXPECT_EQ(listing.capabilities.buttons, 2U);
  EXPECT_EQ(listing.capabilities.rate_hz, 1000);
}

TEST(Connection, a_force_device_that_is_not_what_it_says_is_refused_with_the_reason) {
  MockHid device = force_device(limits());
  device.feature.clear();
  EXPECT_THAT(only(device).reason, HasSubstr("does not answer"));
  device.feature = {3, 'n', 'o'};
  EXPECT_THAT(only(device).reason, HasSubstr("limits report"));
  auto other = limits();
  other.major = 9;
  EXPECT_THAT(only(force_device(other)).reason, HasSubstr("version 9.0"));
  other = limits();
  other.max_force = -1;
  EXPECT_THAT(only(force_device(other)).reason, HasSubstr("largest force"));
  device = force_device(limits());
  device.descriptor[19] = 0x04;  // report 1: four bytes
  EXPECT_THAT(only(device).reason, HasSubstr("pose report"));
}

}  // namespace
}  // namespace sonde::test
