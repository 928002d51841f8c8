// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/hid_report_descriptor.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/engine/devices/descriptors.hpp"

namespace sonde::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

const HidField& field(const HidReportDescriptor& descriptor, HidUsage usage) {
  for (const HidField& one : descriptor.inputs)
    if (one.usage == usage) return one;
  throw std::out_of_range("no such usage");
}

TEST(HidReportDescriptor, the_mouse_of_the_standard_is_laid_out_as_the_standard_says) {
  const auto mouse = parse_hid_report_descriptor(mouse_descriptor());
  EXPECT_TRUE(mouse.whole);
  EXPECT_FALSE(mouse.numbered());
  EXPECT_EQ(mouse.application, (HidUsage{1, 2}));
  ASSERT_EQ(mouse.inputs.size(), 5U) << "padding is no field";
  EXPECT_EQ(mouse.report(HidReportKind::input, 0)->bytes(), 3U);
  const Bytes report{0x05, 0x7f, 0x81};
  EXPECT_EQ(value_of(field(mouse, {9, 1}), report), 1);
  EXPECT_EQ(value_of(field(mouse, {9, 2}), report), 0);
  EXPECT_EQ(value_of(field(mouse, {9, 3}), report), 1);
  EXPECT_EQ(value_of(field(mouse, {1, 0x30}), report), 127);
  EXPECT_EQ(value_of(field(mouse, {1, 0x31}), report), -127);
}

TEST(HidReportDescriptor, a_numbered_device_keeps_its_reports_apart) {
  const auto puck = parse_hid_report_descriptor(split_descriptor());
  EXPECT_TRUE(puck.whole);
  EXPECT_TRUE(puck.numbered());
  EXPECT_EQ(puck.application, (HidUsage{1, 8}));
  EXPECT_EQ(puck.report(HidReportKind::input, 1)->bytes(), 7U);
  EXPECT_EQ(puck.report(HidReportKind::input, 2)->bytes(), 7U);
  EXPECT_EQ(puck.report(HidReportKind::input, 3)->bytes(), 3U);
  EXPECT_EQ(puck.report(HidReportKind::output, 4)->bytes(), 2U);
  EXPECT_EQ(puck.report(HidReportKind::input, 9), nullptr);
  const HidField& ry = field(puck, {1, 0x34});
  EXPECT_EQ(ry.report_id, 2);
  EXPECT_EQ(ry.bit, 8U + 16U);
  EXPECT_EQ(ry.logical_min, -350);
  EXPECT_EQ(ry.logical_max, 350);
  EXPECT_EQ(value_of(ry, words(2, {1, -350, 3})), -350);
  EXPECT_FALSE(value_of(ry, words(1, {1, -350, 3}))) << "another report";
  EXPECT_FALSE(value_of(ry, Bytes{2, 0, 0, 1})) << "cut off";
  EXPECT_FALSE(value_of(ry, Bytes{}));
}

TEST(HidReportDescriptor, a_field_may_lie_across_bytes) {
  // 4 bits of padding, then one field of 12 bits, of 0 to FFF.
  const auto odd = parse_hid_report_descriptor(
      Bytes{0x05, 0x01, 0x09, 0x04, 0xa1, 0x01, 0x75, 0x04, 0x95, 0x01, 0x81, 0x01, 0x09,
            0x30, 0x15, 0x00, 0x26, 0xff, 0x0f, 0x75, 0x0c, 0x95, 0x01, 0x81, 0x02, 0xc0});
  ASSERT_EQ(odd.inputs.size(), 1U);
  EXPECT_EQ(value_of(odd.inputs[0], Bytes{0x5f, 0xa9}), 0xa95);
}

TEST(HidReportDescriptor, a_maximum_of_ff_is_255_where_nothing_is_negative) {
  const auto byte =
      parse_hid_report_descriptor(Bytes{0x05, 0x01, 0x09, 0x04, 0xa1, 0x01, 0x09, 0x30, 0x15, 0x00,
                                        0x25, 0xff, 0x75, 0x08, 0x95, 0x01, 0x81, 0x02, 0xc0});
  ASSERT_EQ(byte.inputs.size(), 1U);
  EXPECT_EQ(byte.inputs[0].logical_max, 255);
  EXPECT_EQ(value_of(byte.inputs[0], Bytes{0xff}), 255);
}

TEST(HidReportDescriptor, pushed_globals_come_back) {
  // Size 8, pushed; size 16 for X; popped, and Y has 8 again.
  const auto two = parse_hid_report_descriptor(Bytes{0x05, 0x01, 0x09, 0x04, 0xa1, 0x01, 0x75, 0x08,
                                                     0x95, 0x01, 0xa4, 0x75, 0x10, 0x09, 0x30, 0x81,
                                                     0x02, 0xb4, 0x09, 0x31, 0x81, 0x02, 0xc0});
  ASSERT_EQ(two.inputs.size(), 2U);
  EXPECT_EQ(two.inputs[0].bits, 16U);
  EXPECT_EQ(two.inputs[1].bits, 8U);
  EXPECT_TRUE(two.whole);
}

TEST(HidReportDescriptor, an_array_keeps_the_first_of_its_usages) {
  const auto keys = parse_hid_report_descriptor(
      Bytes{0x05, 0x01, 0x09, 0x08, 0xa1, 0x01, 0x05, 0x09, 0x19, 0x03, 0x29, 0x0a,
            0x15, 0x01, 0x25, 0x08, 0x75, 0x08, 0x95, 0x02, 0x81, 0x00, 0xc0});
  ASSERT_EQ(keys.inputs.size(), 2U);
  for (const HidField& key : keys.inputs) {
    EXPECT_TRUE(key.array);
    EXPECT_EQ(key.usage, (HidUsage{9, 3}));
  }
}

TEST(HidReportDescriptor, what_cannot_be_is_left_out_with_all_that_follows) {
  const Bytes axis{0x05, 0x01, 0x09, 0x30, 0x75, 0x08, 0x95, 0x01, 0x81, 0x02};
  const Bytes bad_ends[] = {
      {0x27, 0x01},                                            // an item cut off
      {0xfe},                                                  // a long item without its size
      {0xfe, 0x20, 0x00, 0x01},                                // a long item cut off
      {0xb4},                                                  // nothing was pushed
      {0xc0},                                                  // nothing to end
      {0xa1, 0x01},                                            // never ended
      {0x75, 0x20, 0x97, 0xff, 0xff, 0xff, 0xff, 0x81, 0x02},  // four billion numbers
      {0x77, 0xff, 0xff, 0xff, 0xff, 0x95, 0x02, 0x81, 0x02},  // numbers of four billion bits
      {0x86, 0x00, 0x01},                                      // a report's id above 255
  };
  for (const Bytes& end : bad_ends) {
    Bytes bytes = axis;
    bytes.insert(bytes.end(), end.begin(), end.end());
    const auto parsed = parse_hid_report_descriptor(bytes);
    EXPECT_FALSE(parsed.whole) << static_cast<int>(end[0]);
    EXPECT_EQ(parsed.inputs.size(), 1U) << "what came before stays";
  }
}

/// Any bytes: it comes to an end, its lists are short, and every field it names can be read.
void parse_random_bytes(unsigned seed, int rounds) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> byte(0, 255), length(0, 400), change(0, 7);
  for (int round = 0; round < rounds; ++round) {
    // Half of them real ones with some bytes changed: random ones seldom get far.
    Bytes bytes =
        round % 2 == 0 ? joint_descriptor() : Bytes(static_cast<std::size_t>(length(random)));
    for (std::uint8_t& one : bytes)
      if (round % 2 == 1 || change(random) == 0) one = static_cast<std::uint8_t>(byte(random));
    const auto parsed = parse_hid_report_descriptor(bytes);
    Bytes report(64);
    for (std::uint8_t& one : report) one = static_cast<std::uint8_t>(byte(random));
    for (const auto* fields : {&parsed.inputs, &parsed.outputs, &parsed.features}) {
      ASSERT_LE(fields->size(), 4096U);
      for (const HidField& one : *fields) {
        ASSERT_GE(one.bits, 1U);
        ASSERT_LE(one.bits, 32U);
        const auto value = value_of(one, report);
        ASSERT_TRUE(!value || std::abs(*value) < std::int64_t{1} << 32);
      }
    }
    for (const HidReport& one : parsed.reports) ASSERT_LE(one.bytes(), 16384U);
  }
}

TEST(HidReportDescriptor, random_bytes_do_no_harm) { parse_random_bytes(1, 20000); }
TEST(HidReportDescriptor, Fuzz_random_bytes_do_no_harm) { parse_random_bytes(2, 5000000); }

}  // namespace
}  // namespace sonde::test
