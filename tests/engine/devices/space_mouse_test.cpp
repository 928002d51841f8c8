// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/space_mouse.hpp"

#include <gmock/gmock.h>

#include <random>

#include "tests/engine/devices/descriptors.hpp"
#include "tests/engine/devices/six.hpp"

namespace sonde::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

SpaceMouse mouse(const Bytes& descriptor) {
  return SpaceMouse(parse_hid_report_descriptor(descriptor));
}

/// One device and the sample it makes.
struct Puck {
  SpaceMouse driver;
  DeviceSample sample{};
  Heard hear(const Bytes& report) { return driver.accept(report, DeviceClock::now(), sample); }
};

using Ids = std::vector<std::uint16_t>;

TEST(SpaceMouse, every_id_has_a_name_and_plain_mice_have_none) {
  for (const std::uint16_t product : Ids{0xc603, 0xc605, 0xc606, 0xc621, 0xc623, 0xc625, 0xc626,
                                         0xc627, 0xc628, 0xc629, 0xc62b, 0xc640})
    EXPECT_NE(space_mouse_name(0x046d, product), nullptr) << std::hex << product;
  for (const std::uint16_t product :
       Ids{0xc62e, 0xc62f, 0xc631, 0xc632, 0xc633, 0xc635, 0xc636, 0xc638, 0xc63a, 0xc652}) {
    EXPECT_NE(space_mouse_name(0x256f, product), nullptr) << std::hex << product;
    EXPECT_FALSE(is_plain_3dconnexion(0x256f, product));
  }
  for (const std::uint16_t product :
       Ids{0xc650, 0xc651, 0xc654, 0xc655, 0xc656, 0xc657, 0xc658, 0xc664, 0xc665, 0xc668}) {
    EXPECT_TRUE(is_plain_3dconnexion(0x256f, product)) << std::hex << product;
    EXPECT_EQ(space_mouse_name(0x256f, product), nullptr);
  }
  EXPECT_EQ(space_mouse_name(0x046d, 0xc077), nullptr) << "another mouse of that maker";
}

TEST(SpaceMouse, both_layouts_give_the_same_deflections) {
  // The device's y points to the user, its z down; a sample's the other way.
  const SixAxes expected = six(1, -0.5, 0.2, -1, 0.1, -0.6);
  Puck split{mouse(split_descriptor())};
  EXPECT_EQ(split.hear(words(1, {350, 175, -70})), Heard::sample);
  EXPECT_EQ(split.hear(words(2, {-350, -35, 210})), Heard::sample);
  EXPECT_LT((split.sample.deflection - expected).norm(), 1e-15);
  Puck joint{mouse(joint_descriptor())};
  EXPECT_EQ(joint.hear(words(1, {350, 175, -70, -350, -35, 210})), Heard::sample);
  EXPECT_LT((joint.sample.deflection - expected).norm(), 1e-15);
  EXPECT_EQ(joint.sample.state, DeviceState::ready);
}

TEST(SpaceMouse, without_a_descriptor_the_known_layouts_are_tried) {
  const SixAxes expected = six(1, -0.5, 0.2, -1, 0.1, -0.6);
  for (const Bytes& descriptor : {Bytes{}, mouse_descriptor()}) {
    Puck split{mouse(descriptor)};
    EXPECT_EQ(split.hear(words(1, {350, 175, -70})), Heard::sample);
    EXPECT_EQ(split.hear(words(2, {-350, -35, 210})), Heard::sample);
    EXPECT_LT((split.sample.deflection - expected).norm(), 1e-15);
    Puck joint{mouse(descriptor)};
    EXPECT_EQ(joint.hear(words(1, {350, 175, -70, -350, -35, 210})), Heard::sample);
    EXPECT_LT((joint.sample.deflection - expected).norm(), 1e-15);
    EXPECT_EQ(joint.hear({3, 0x05, 0x80}), Heard::sample);
    EXPECT_EQ(joint.sample.buttons, 0x8005U);
    EXPECT_EQ(joint.driver.led_report(true), (Bytes{4, 1}));
  }
}

TEST(SpaceMouse, a_descriptor_that_lies_about_the_layout_is_seen_through) {
  Puck puck{mouse(split_descriptor())};
  EXPECT_EQ(puck.hear(words(1, {350, 175, -70, -350, -35, 210})), Heard::sample);
  EXPECT_LT((puck.sample.deflection - six(1, -0.5, 0.2, -1, 0.1, -0.6)).norm(), 1e-15);
}

TEST(SpaceMouse, a_range_of_nothing_is_not_believed) {
  Bytes flat = joint_descriptor();
  flat[11] = flat[12] = flat[14] = flat[15] = 0;  // logical minimum and maximum
  Puck puck{mouse(flat)};
  EXPECT_EQ(puck.hear(words(1, {350, 0, 0, 0, 0, -175})), Heard::sample);
  EXPECT_LT((puck.sample.deflection - six(1, 0, 0, 0, 0, 0.5)).norm(), 1e-15);
}

TEST(SpaceMouse, a_range_without_negative_numbers_rests_in_its_middle) {
  Bytes bytes = joint_descriptor();
  bytes[11] = bytes[12] = 0;           // 0
  bytes[14] = 0xe8, bytes[15] = 0x03;  // to 1000
  Puck puck{mouse(bytes)};
  EXPECT_EQ(puck.hear(words(1, {500, 500, 500, 500, 500, 0})), Heard::sample);
  EXPECT_LT((puck.sample.deflection - six(0, 0, 0, 0, 0, 1)).norm(), 1e-15);
}

TEST(SpaceMouse, a_little_out_of_range_is_clamped_and_far_out_is_refused) {
  Puck puck{mouse(joint_descriptor())};
  EXPECT_EQ(puck.hear(words(1, {500, 0, 0, 0, 0, 0})), Heard::sample);
  EXPECT_EQ(puck.sample.deflection[0], 1);
  const std::uint64_t count = puck.sample.count;
  EXPECT_EQ(puck.hear(words(1, {32767, 100, 0, 0, 0, 0})), Heard::refused);
  EXPECT_EQ(puck.sample.deflection, six(1, 0, 0, 0, 0, 0)) << "the last one holds, whole";
  EXPECT_EQ(puck.sample.count, count);
  EXPECT_EQ(puck.sample.state, DeviceState::ready) << "one glitch is no fault";
}

TEST(SpaceMouse, garbage_that_goes_on_is_a_fault_until_something_true_comes) {
  Puck puck{mouse(split_descriptor())};
  EXPECT_EQ(puck.hear(words(1, {350, 0, 0})), Heard::sample);
  for (int i = 0; i < SpaceMouse::most_refused; ++i) {
    EXPECT_EQ(puck.hear({0xee, 1, 2, 3}), Heard::refused);
    EXPECT_STRNE(puck.driver.complaint(), "");
  }
  EXPECT_EQ(puck.sample.state, DeviceState::faulty);
  EXPECT_EQ(puck.sample.deflection, SixAxes::Zero());
  EXPECT_EQ(puck.hear(words(1, {0, 0, 350})), Heard::sample);
  EXPECT_EQ(puck.sample.state, DeviceState::ready);
}

TEST(SpaceMouse, a_level_of_a_battery_is_no_deflection_and_no_fault) {
  Puck known{mouse(split_descriptor())};
  for (int i = 0; i < 2 * SpaceMouse::most_refused; ++i)
    EXPECT_EQ(known.hear({0x17, 90, 0}), Heard::nothing);
  EXPECT_EQ(known.sample.count, 0U);
}

TEST(SpaceMouse, buttons_by_bits_and_by_numbers) {
  Puck bits{mouse(joint_descriptor())};
  EXPECT_EQ(bits.driver.capabilities().buttons, 15U);
  EXPECT_EQ(bits.hear({3, 0x01, 0x40}), Heard::sample);
  EXPECT_EQ(bits.sample.buttons, 0x4001U);
  EXPECT_EQ(bits.hear({3, 0, 0}), Heard::sample);
  EXPECT_EQ(bits.sample.buttons, 0U);

  // Two slots that hold the numbers of the buttons held, 1 to 20.
  Bytes numbers = joint_descriptor();
  numbers.pop_back();
  const Bytes slots{0x05, 0x09, 0x85, 0x1c, 0x19, 0x01, 0x29, 0x14, 0x15, 0x01,
                    0x25, 0x14, 0x75, 0x08, 0x95, 0x02, 0x81, 0x00, 0xc0};
  numbers.insert(numbers.end(), slots.begin(), slots.end());
  Puck arrays{mouse(numbers)};
  EXPECT_EQ(arrays.driver.capabilities().buttons, 20U);
  EXPECT_EQ(arrays.hear({0x1c, 20, 2}), Heard::sample);
  EXPECT_EQ(arrays.sample.buttons, (1U << 19) | 2U);
  EXPECT_EQ(arrays.hear({0x1c, 0, 0}), Heard::sample);
  EXPECT_EQ(arrays.sample.buttons, 0U);
}

TEST(SpaceMouse, the_light_is_where_the_descriptor_says) {
  const SpaceMouse with = mouse(split_descriptor());
  EXPECT_TRUE(with.capabilities().led);
  EXPECT_EQ(with.led_report(true), (Bytes{4, 1}));
  EXPECT_EQ(with.led_report(false), (Bytes{4, 0}));
  const Bytes lit = split_descriptor();
  Bytes dark(lit.begin(), lit.end() - 27);  // without the light's collection and the end of all
  dark.push_back(0xc0);
  const SpaceMouse without = mouse(dark);
  EXPECT_FALSE(without.capabilities().led);
  EXPECT_TRUE(without.led_report(true).empty());
}

/// Whatever is sent, each number of a sample stays within -1 and 1.
void hear_random_reports(unsigned seed, int rounds) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> byte(0, 255), length(0, 20), id(0, 5);
  for (const Bytes& descriptor : {Bytes{}, split_descriptor(), joint_descriptor()}) {
    Puck puck{mouse(descriptor)};
    for (int round = 0; round < rounds; ++round) {
      Bytes report(static_cast<std::size_t>(length(random)));
      for (std::uint8_t& one : report) one = static_cast<std::uint8_t>(byte(random));
      if (!report.empty()) report[0] = static_cast<std::uint8_t>(id(random));
      puck.hear(report);
      ASSERT_TRUE((puck.sample.deflection.array().abs() <= 1).all());
    }
  }
}

TEST(SpaceMouse, random_reports_do_no_harm) { hear_random_reports(1, 20000); }
TEST(SpaceMouse, Fuzz_random_reports_do_no_harm) { hear_random_reports(2, 5000000); }

}  // namespace
}  // namespace sonde::test
