// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/force_protocol.hpp"

#include <gmock/gmock.h>

#include <limits>

namespace sonde::test {
namespace {

using namespace force_protocol;
using testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

template <class Array>
Bytes bytes_of(const Array& array) {
  return {array.begin(), array.end()};
}

Limits limits() {
  return {.rate_hz = 1000,
          .max_force = 8,
          .max_torque = 0.25,
          .reach = {0.125, 0.25, 0.5},
          .max_stiffness = 2048,
          .buttons = 3};
}

// The bytes are those of the examples in resources/docs/develop/force-device-protocol.md, written
// out by hand from the tables there.
TEST(ForceProtocol, a_pose_report_is_as_documented) {
  const PoseReport report{.sequence = 0x0102,
                          .time_us = 0x03040506,
                          .buttons = 5,
                          .X_BH = {Quat(0.5, -0.5, 0.5, -0.5), Vec3(0.125, -0.25, 2)}};
  const Bytes expected{0x01, 0x02, 0x01, 0x06, 0x05, 0x04, 0x03, 0x05, 0x00, 0x01, 0x00, 0x00, 0x00,
                       0x3e, 0x00, 0x00, 0x80, 0xbe, 0x00, 0x00, 0x00, 0x40, 0x00, 0x00, 0x00, 0x3f,
                       0x00, 0x00, 0x00, 0xbf, 0x00, 0x00, 0x00, 0x3f, 0x00, 0x00, 0x00, 0xbf};
  EXPECT_EQ(bytes_of(encode(report)), expected);
  const auto back = decode_pose(expected);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->sequence, report.sequence);
  EXPECT_EQ(back->time_us, report.time_us);
  EXPECT_EQ(back->buttons, report.buttons);
  EXPECT_TRUE(back->valid);
  EXPECT_FALSE(back->fault);
  EXPECT_EQ(back->X_BH.p, report.X_BH.p);
  EXPECT_EQ(back->X_BH.q.coeffs(), report.X_BH.q.coeffs());
}

TEST(ForceProtocol, a_wrench_report_is_as_documented) {
  const WrenchReport report{
      .sequence = 7, .answers = 0x0102, .on = true, .wrench = {{1, -2, 0.5}, {0.25, 0, -0.125}}};
  const Bytes expected{0x02, 0x07, 0x00, 0x02, 0x01, 0x01, 0x00, 0x00, 0x80, 0x3f,
                       0x00, 0x00, 0x00, 0xc0, 0x00, 0x00, 0x00, 0x3f, 0x00, 0x00,
                       0x80, 0x3e, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xbe};
  EXPECT_EQ(bytes_of(encode(report)), expected);
  const auto back = decode_wrench(expected);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->answers, report.answers);
  EXPECT_TRUE(back->on);
  EXPECT_EQ(back->wrench.force, report.wrench.force);
  EXPECT_EQ(back->wrench.torque, report.wrench.torque);
}

TEST(ForceProtocol, a_limits_report_is_as_documented) {
  const Bytes expected{0x03, 'S',  '6',  'D',  'F',  0x01, 0x00, 0xe8, 0x03, 0x00, 0x00, 0x00,
                       0x41, 0x00, 0x00, 0x80, 0x3e, 0x00, 0x00, 0x00, 0x3e, 0x00, 0x00, 0x80,
                       0x3e, 0x00, 0x00, 0x00, 0x3f, 0x00, 0x00, 0x00, 0x45, 0x03};
  EXPECT_EQ(bytes_of(encode(limits())), expected);
  const auto back = decode_limits(expected);
  ASSERT_TRUE(back);
  EXPECT_EQ(fault_of(*back), "");
  EXPECT_EQ(back->reach, limits().reach);
  EXPECT_EQ(back->buttons, 3);
}

TEST(ForceProtocol, a_report_cut_off_or_of_another_kind_is_none_and_a_longer_one_is_read) {
  Bytes pose = bytes_of(encode(PoseReport{}));
  Bytes mark = bytes_of(encode(limits()));
  pose.push_back(0xff);  // a later minor version
  EXPECT_TRUE(decode_pose(pose));
  EXPECT_FALSE(decode_wrench(pose));
  pose.resize(PoseReport::bytes - 1);
  EXPECT_FALSE(decode_pose(pose));
  EXPECT_FALSE(decode_pose({}));
  mark[1] = 'X';
  EXPECT_FALSE(decode_limits(mark));
}

TEST(ForceProtocol, another_major_version_is_named) {
  Limits other = limits();
  other.major = 2;
  other.minor = 7;
  EXPECT_THAT(fault_of(other), HasSubstr("version 2.7"));
  other.major = 1;
  EXPECT_EQ(fault_of(other), "") << "a later minor version";
}

TEST(ForceProtocol, limits_that_cannot_be_are_named) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto with = [](auto change) {
    Limits changed = limits();
    change(changed);
    return fault_of(changed);
  };
  EXPECT_THAT(with([&](Limits& l) { l.max_force = nan; }), HasSubstr("force"));
  EXPECT_THAT(with([&](Limits& l) { l.max_force = 1e4; }), HasSubstr("force"));
  EXPECT_THAT(with([&](Limits& l) { l.max_torque = -1; }), HasSubstr("torque"));
  EXPECT_THAT(with([&](Limits& l) { l.reach.y() = nan; }), HasSubstr("volume"));
  EXPECT_THAT(with([&](Limits& l) { l.reach.z() = 0; }), HasSubstr("volume"));
  EXPECT_THAT(with([&](Limits& l) { l.max_stiffness = nan; }), HasSubstr("stiffness"));
  EXPECT_THAT(with([&](Limits& l) { l.rate_hz = 0; }), HasSubstr("rate"));
}

TEST(ForceProtocol, its_descriptor_declares_its_reports_and_a_lying_one_is_named) {
  const auto own = report_descriptor();
  const Bytes bytes(own.begin(), own.end());
  const HidReportDescriptor parsed = parse_hid_report_descriptor(bytes);
  EXPECT_EQ(parsed.application, usage);
  EXPECT_EQ(fault_of(parsed), "");
  EXPECT_EQ(parsed.report(HidReportKind::input, pose_id)->bytes(), PoseReport::bytes);
  EXPECT_EQ(parsed.report(HidReportKind::output, wrench_id)->bytes(), WrenchReport::bytes);
  EXPECT_EQ(parsed.report(HidReportKind::feature, limits_id)->bytes(), Limits::bytes);

  Bytes shorter = bytes;
  shorter[19] = 0x10;  // report 1: 16 bytes
  EXPECT_THAT(fault_of(parse_hid_report_descriptor(shorter)), HasSubstr("pose report"));
  const Bytes cut(own.begin(), own.end() - 1);
  EXPECT_THAT(fault_of(parse_hid_report_descriptor(cut)), HasSubstr("malformed"));
}

}  // namespace
}  // namespace sonde::test
