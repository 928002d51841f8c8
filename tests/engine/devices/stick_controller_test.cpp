// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/stick_controller.hpp"

#include <gmock/gmock.h>

#include <random>

#include "tests/engine/devices/controller_descriptors.hpp"
#include "tests/engine/devices/descriptors.hpp"
#include "tests/engine/devices/six.hpp"

namespace sonde::test {
namespace {

using namespace std::chrono_literals;
using Bytes = std::vector<std::uint8_t>;

/// One controller and the sample it makes; each report comes 4 ms after the one before.
struct Pad {
  explicit Pad(const Bytes& descriptor) : driver(parse_hid_report_descriptor(descriptor)) {}
  StickController driver;
  DeviceSample sample{.state = DeviceState::ready};
  DeviceClock::time_point now = DeviceClock::now();
  Heard hear(const Bytes& report) { return driver.accept(report, now += 4ms, sample); }
};

/// A DualShock's report 1.
Bytes dualshock(int lx, int ly, int rx, int ry, int hat = 8, int left = 0, int right = 0) {
  Bytes bytes(64);
  const int told[] = {1, lx, ly, rx, ry, hat, 0, 0, left, right};
  for (std::size_t i = 0; i < std::size(told); ++i) bytes[i] = static_cast<std::uint8_t>(told[i]);
  return bytes;
}
constexpr int mid = 128;  // nothing of 0 to 255 is its middle
const double off = 0.5 / 127.5;

TEST(StickController, of_a_dualshock_both_sticks_triggers_and_hat_move_along_six_axes) {
  Pad pad(dualshock_descriptor());
  EXPECT_EQ(pad.driver.capabilities().buttons, 14U);
  EXPECT_EQ(pad.hear(dualshock(255, mid, mid, mid)), Heard::sample);
  EXPECT_LT((pad.sample.deflection - six(1, -off, 0, off, 0, -off)).norm(), 1e-12);
  pad.hear(dualshock(mid, 0, mid, mid));
  EXPECT_LT((pad.sample.deflection - six(off, 1, 0, off, 0, -off)).norm(), 1e-12) << "away";
  pad.hear(dualshock(mid, mid, 255, mid));
  EXPECT_LT((pad.sample.deflection - six(off, -off, 0, off, 0, -1)).norm(), 1e-12)
      << "to the right: clockwise from above";
  pad.hear(dualshock(mid, mid, mid, 0));
  EXPECT_LT((pad.sample.deflection - six(off, -off, 0, -1, 0, -off)).norm(), 1e-12)
      << "forwards: the top goes away";
  pad.hear(dualshock(mid, mid, mid, mid, 8, 51, 255));
  EXPECT_NEAR(pad.sample.deflection[2], 0.8, 1e-12) << "right trigger up, left one down";
  pad.hear(dualshock(mid, mid, mid, mid, 2));
  EXPECT_NEAR(pad.sample.deflection[4], 1, 1e-12) << "the hat to the right";
  pad.hear(dualshock(mid, mid, mid, mid, 5));
  EXPECT_NEAR(pad.sample.deflection[4], -std::sqrt(0.5), 1e-12) << "down and to the left";
  EXPECT_EQ(pad.sample.deflection[2], 0) << "which has the triggers";
}

TEST(StickController, an_xbox_pad_is_the_same_in_both_of_its_modes) {
  // Stick values to 65535, triggers to 1023, hat 1 to 8.
  const auto report = [](int lx, int ly, int rx, int ry, int left, int right, int hat) {
    Bytes bytes = words(1, {lx, ly, rx, ry, left, right});
    bytes.push_back(static_cast<std::uint8_t>(hat));
    bytes.insert(bytes.end(), {0x41, 0, 0});
    return bytes;
  };
  const int half = 49151;  // three quarters of the way: half of the deflection
  for (const Bytes& descriptor : {xbox_descriptor(), xbox_windows_descriptor()}) {
    Pad pad(descriptor);
    EXPECT_EQ(pad.hear(report(half, 0, half, 65535, 1023, 0, 7)), Heard::sample)
        << pad.driver.complaint();
    EXPECT_LT((pad.sample.deflection - six(0.5, 1, -1, 1, -1, -0.5)).norm(), 1e-4);
    EXPECT_EQ(pad.sample.buttons, 0x41U);
    pad.hear(report(32767, 32767, 32767, 32767, 0, 0, 0));
    EXPECT_LT(pad.sample.deflection.norm(), 1e-4) << "the hat's 0 is no direction";
    EXPECT_EQ(pad.hear(descriptor == xbox_descriptor() ? Bytes{4, 90} : Bytes{2, 1}),
              Heard::nothing);
  }
}

TEST(StickController, an_f310_has_no_triggers_with_a_way_so_its_hat_lifts) {
  Pad pad(f310_descriptor());
  EXPECT_EQ(pad.driver.capabilities().buttons, 12U);
  EXPECT_EQ(pad.hear({255, 0, 0, 255, 0x10, 0x80, 0, 0xff}), Heard::sample);
  EXPECT_LT((pad.sample.deflection - six(1, 1, 1, 1, 0, 1)).norm(), 1e-12);
  EXPECT_EQ(pad.sample.buttons, 0x801U);
  EXPECT_EQ(pad.hear({mid, mid, mid, mid, 0x06, 0, 0, 0xff}), Heard::sample);
  EXPECT_NEAR(pad.sample.deflection[4], -1, 1e-12);
  EXPECT_NEAR(pad.sample.deflection[2], 0, 1e-12);
}

TEST(StickController, a_joystick_with_a_twist_leaves_its_throttle_out) {
  Pad pad(twist_descriptor());
  EXPECT_EQ(pad.driver.capabilities().buttons, 12U);
  // X 1023, Y 0, hat 4 (down), twist 255, button 1, slider 200, button 12.
  EXPECT_EQ(pad.hear({0xff, 0x03, 0x40, 0xff, 0x01, 200, 0x08}), Heard::sample);
  EXPECT_LT((pad.sample.deflection - six(1, 1, -1, 0, 0, -1)).norm(), 1e-12);
  EXPECT_EQ(pad.sample.buttons, 0x801U);
}

TEST(StickController, six_axes_in_order_are_what_they_are_called) {
  Pad pad(six_axis_joystick_descriptor());
  EXPECT_EQ(pad.hear({127, 0x81, 0, 127, 0x81, 127}), Heard::sample);
  EXPECT_LT((pad.sample.deflection - six(1, 1, 0, 1, 1, -1)).norm(), 1e-12)
      << "as of a puck: y points away, z up";
}

TEST(StickController, too_few_axes_are_no_controller) {
  EXPECT_TRUE(stick_layout(parse_hid_report_descriptor(cross_pad_descriptor())).empty());
  EXPECT_TRUE(stick_layout(parse_hid_report_descriptor(mouse_descriptor())).empty());
  EXPECT_TRUE(stick_layout({}).empty());
}

TEST(StickController, one_that_tells_only_changes_may_be_held_still_for_as_long_as_one_likes) {
  Pad pad(f310_descriptor());
  for (int x = mid; x < 256; ++x) pad.hear({std::uint8_t(x), mid, mid, mid, 8, 0, 0, 0xff});
  EXPECT_EQ(aged(pad.sample, pad.now + 1h).state, DeviceState::ready);
  EXPECT_EQ(aged(pad.sample, pad.now + 1h).deflection[0], 1);
}

TEST(StickController, one_that_repeats_itself_and_falls_silent_has_let_go) {
  Pad pad(dualshock_descriptor());
  for (int i = 0; i <= StickController::enough_repeats; ++i) pad.hear(dualshock(255, 0, mid, mid));
  EXPECT_EQ(aged(pad.sample, pad.now + 199ms).state, DeviceState::ready);
  const DeviceSample later = aged(pad.sample, pad.now + 201ms);
  EXPECT_EQ(later.state, DeviceState::silent);
  EXPECT_TRUE(later.deflection.isZero(0));
}

TEST(StickController, short_reports_are_refused_and_a_row_of_them_is_a_fault) {
  Pad pad(dualshock_descriptor());
  pad.hear(dualshock(255, mid, mid, mid));
  Bytes cut = dualshock(0, mid, mid, mid);
  cut.resize(9);
  for (int i = 1; i < StickController::most_refused; ++i) {
    EXPECT_EQ(pad.hear(i % 2 == 0 ? cut : Bytes{}), Heard::refused);
    EXPECT_EQ(pad.sample.state, DeviceState::ready);
    EXPECT_EQ(pad.sample.deflection[0], 1) << "the last one holds, whole";
  }
  EXPECT_EQ(pad.hear(cut), Heard::refused);
  EXPECT_EQ(pad.sample.state, DeviceState::faulty);
  EXPECT_TRUE(pad.sample.deflection.isZero(0));
  EXPECT_THAT(pad.driver.complaint(), testing::HasSubstr("shorter than its descriptor says"));
  EXPECT_EQ(pad.hear(dualshock(mid, 0, mid, mid)), Heard::sample);
  EXPECT_EQ(pad.sample.state, DeviceState::ready);
  EXPECT_EQ(pad.sample.deflection[1], 1);
}

TEST(StickController, a_mode_that_the_descriptor_leaves_out_is_named) {
  Pad pad(dualshock_descriptor());
  Bytes other(78);
  other[0] = 0x11;
  for (int i = 1; i < StickController::most_unread; ++i) EXPECT_EQ(pad.hear(other), Heard::nothing);
  EXPECT_EQ(pad.sample.state, DeviceState::ready);
  EXPECT_EQ(pad.hear(other), Heard::refused);
  EXPECT_EQ(pad.sample.state, DeviceState::faulty);
  EXPECT_THAT(pad.driver.complaint(), testing::HasSubstr("by cable"));
}

TEST(StickController, a_level_of_a_battery_now_and_then_is_no_fault) {
  Pad pad(xbox_descriptor());
  for (int i = 0; i < 200; ++i) {
    EXPECT_EQ(pad.hear({4, 90}), Heard::nothing);
    pad.now += 60s;
  }
  EXPECT_EQ(pad.sample.state, DeviceState::ready);
}

/// Whatever is sent, each number of a sample stays within -1 and 1.
void hear_random(const Bytes& descriptor, std::mt19937& random, int rounds) {
  std::uniform_int_distribution<int> byte(0, 255), length(0, 70);
  Pad pad(descriptor);
  for (int round = 0; round < rounds; ++round) {
    Bytes report(static_cast<std::size_t>(length(random)));
    for (std::uint8_t& one : report) one = static_cast<std::uint8_t>(byte(random));
    if (!report.empty() && round % 2 == 0) report[0] = 1;
    pad.hear(report);
    ASSERT_TRUE((pad.sample.deflection.array().abs() <= 1).all());
  }
}

/// Real descriptors with some bytes changed, cut and doubled, and reports by them.
void break_descriptors(unsigned seed, int rounds) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> byte(0, 255);
  const std::vector<Bytes> real{dualshock_descriptor(), xbox_descriptor(),
                                xbox_windows_descriptor(), f310_descriptor(), twist_descriptor()};
  for (int round = 0; round < rounds; ++round) {
    Bytes broken = real[static_cast<std::size_t>(round) % real.size()];
    std::uniform_int_distribution<std::size_t> place(0, broken.size() - 1);
    for (int i = 0; i < 3; ++i) broken[place(random)] = static_cast<std::uint8_t>(byte(random));
    if (round % 3 == 0) broken.resize(place(random));
    const HidReportDescriptor parsed = parse_hid_report_descriptor(broken);
    for (const StickSource& source : stick_layout(parsed)) {
      ASSERT_GT(source.field.logical_max, source.field.logical_min);
      ASSERT_TRUE(source.axis >= 0 && source.axis < 6);
    }
    hear_random(broken, random, 20);
  }
}

TEST(StickController, random_reports_do_no_harm) {
  std::mt19937 random(1);
  hear_random(dualshock_descriptor(), random, 20000);
  hear_random(xbox_descriptor(), random, 20000);
}
TEST(StickController, broken_descriptors_do_no_harm) { break_descriptors(2, 3000); }
TEST(StickController, Fuzz_broken_descriptors_do_no_harm) { break_descriptors(3, 1000000); }

}  // namespace
}  // namespace sonde::test
