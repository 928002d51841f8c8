// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/force_device.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <random>

namespace sonde::test {
namespace {

using namespace std::chrono_literals;
using force_protocol::Limits;
using force_protocol::PoseReport;
using testing::HasSubstr;

/// A device at 1 kHz, the host that hears it, and a clock that both go by.
struct Session {
  ForceDevice driver{Limits{.max_force = 8, .max_torque = 0.25, .reach = Vec3::Constant(0.2)}};
  DeviceSample sample{};
  PoseReport next{};
  DeviceClock::time_point now = DeviceClock::now();

  Heard send(const PoseReport& report) {
    return driver.accept(force_protocol::encode(report), now, sample);
  }
  /// The next report of a device that works.
  Heard step() {
    now += 1ms;
    ++next.sequence;
    next.time_us += 1000;
    return send(next);
  }
  void begin() {
    for (int i = 0; i < ForceDevice::enough_in_a_row; ++i) step();
  }
  bool ready() const { return aged(sample, now).state == DeviceState::ready; }
};

TEST(ForceDevice, is_ready_after_a_run_of_reports_that_agree) {
  Session session;
  for (int i = 1; i < ForceDevice::enough_in_a_row; ++i) {
    EXPECT_EQ(session.step(), Heard::nothing);
    EXPECT_FALSE(session.ready());
  }
  session.next.X_BH.p = {0.001, 0.002, 0.003};
  session.next.buttons = 2;
  EXPECT_EQ(session.step(), Heard::sample);
  EXPECT_TRUE(session.ready());
  EXPECT_LT((session.sample.X_BH.p - Vec3(0.001, 0.002, 0.003)).norm(), 1e-9);
  EXPECT_EQ(session.sample.buttons, 2U);
}

TEST(ForceDevice, a_report_that_cannot_be_true_ends_the_force_at_once_and_the_reason_is_told) {
  struct Case {
    const char* reason;
    void (*spoil)(PoseReport&);
  };
  const Case cases[] = {
      {"finite", [](PoseReport& r) { r.X_BH.p.x() = std::numeric_limits<double>::quiet_NaN(); }},
      {"finite", [](PoseReport& r) { r.X_BH.q.w() = std::numeric_limits<double>::infinity(); }},
      {"unit length", [](PoseReport& r) { r.X_BH.q.coeffs() *= 1.02; }},
      {"unit length", [](PoseReport& r) { r.X_BH.q.coeffs().setZero(); }},
      {"1000 mm", [](PoseReport& r) { r.X_BH.p.y() = 1; }},
      {"jumped 150 mm", [](PoseReport& r) { r.X_BH.p.y() = 0.15; }},
      {"rotation", [](PoseReport& r) { r.X_BH.q = Quat(0, 1, 0, 0); }},
      {"go back", [](PoseReport& r) { r.sequence -= 5; }},
      {"fault of its own", [](PoseReport& r) { r.fault = true; }},
      {"does not know its pose", [](PoseReport& r) { r.valid = false; }},
  };
  for (const Case& bad : cases) {
    Session session;
    session.begin();
    ASSERT_TRUE(session.ready());
    PoseReport spoilt = session.next;
    ++spoilt.sequence;
    spoilt.time_us += 1000;
    bad.spoil(spoilt);
    EXPECT_EQ(session.send(spoilt), Heard::refused) << bad.reason;
    EXPECT_THAT(session.driver.complaint(), HasSubstr(bad.reason));
    EXPECT_EQ(session.sample.state, DeviceState::faulty);
    EXPECT_EQ(session.sample.X_BH.p, Vec3::Zero()) << "the last true pose stays";
    for (int i = 0; i < 2 * ForceDevice::enough_in_a_row; ++i) session.step();
    EXPECT_TRUE(session.ready()) << "once it makes sense again: " << bad.reason;
  }
}

TEST(ForceDevice, a_clock_that_lies_does_not_excuse_a_jump) {
  Session session;
  session.begin();
  session.next.time_us += 60'000'000;
  session.next.X_BH.p.x() = -0.2;
  session.step();
  session.next.X_BH.p.x() = 0.2;
  session.next.time_us += 60'000'000;
  EXPECT_EQ(session.step(), Heard::refused);
  EXPECT_THAT(session.driver.complaint(), HasSubstr("jumped 400 mm"));
}

// 12 mm in a millisecond: a tenth of the reach and what a hand moves is 10 mm of this, 25 mm of
// that.
TEST(ForceDevice, what_is_a_jump_follows_the_reach_of_the_device) {
  for (const double reach : {0.05, 0.2}) {
    Session session;
    session.driver =
        ForceDevice(Limits{.max_force = 3, .max_torque = 0, .reach = Vec3::Constant(reach)});
    session.begin();
    session.next.X_BH.p.x() = 0.012;
    EXPECT_EQ(session.step() == Heard::refused, reach < 0.1) << reach;
  }
}

TEST(ForceDevice, a_fast_hand_is_no_jump) {
  Session session;
  session.begin();
  for (int i = 0; i < 100; ++i) {
    session.next.X_BH.p.x() = 0.003 * (i % 50);  // 3 m/s, and back from 147 mm
    const bool back = i > 0 && i % 50 == 0;
    EXPECT_EQ(session.step() == Heard::refused, back) << i;
    if (back) break;
  }
}

TEST(ForceDevice, a_gap_is_counted_and_a_repeat_is_silence) {
  Session session;
  session.begin();
  session.next.sequence = 65533;
  session.driver = Session{}.driver;
  session.begin();  // over the end of the numbers
  EXPECT_EQ(session.driver.lost(), 0U);
  EXPECT_TRUE(session.ready());
  session.next.sequence += 3;
  EXPECT_EQ(session.step(), Heard::sample);
  EXPECT_EQ(session.driver.lost(), 3U);
  for (int i = 0; i < 30; ++i) {
    session.now += 1ms;
    EXPECT_EQ(session.send(session.next), Heard::nothing);
  }
  EXPECT_FALSE(session.ready()) << "the same report over and over is not the hand's";
  EXPECT_EQ(aged(session.sample, session.now).state, DeviceState::silent);
}

TEST(ForceDevice, after_silence_the_handle_may_be_anywhere_but_must_show_itself_steady) {
  Session session;
  session.begin();
  session.now += 1s;
  session.next.X_BH.p.x() = 0.2;
  EXPECT_EQ(session.step(), Heard::nothing);
  EXPECT_FALSE(session.ready());
  session.begin();
  EXPECT_TRUE(session.ready());
}

TEST(ForceDevice, another_report_or_none_is_refused) {
  Session session;
  session.begin();
  for (const std::size_t size : {0U, 1U, 37U}) {
    const std::vector<std::uint8_t> bytes(size, 1);
    EXPECT_EQ(session.driver.accept(bytes, session.now, session.sample), Heard::refused);
    EXPECT_EQ(session.sample.state, DeviceState::faulty);
  }
}

TEST(ForceDevice, a_slow_device_is_given_five_periods) {
  ForceDevice slow(Limits{.rate_hz = 20, .max_force = 1, .reach = Vec3::Constant(0.2)});
  DeviceSample sample;
  PoseReport report;
  const auto start = DeviceClock::now();
  for (int i = 0; i < ForceDevice::enough_in_a_row; ++i) {
    ++report.sequence;
    report.time_us += 50000;
    slow.accept(force_protocol::encode(report), start + i * 50ms, sample);
  }
  EXPECT_EQ(sample.state, DeviceState::ready);
  EXPECT_EQ(sample.stale_after, 250ms);
}

TEST(ForceDevice, a_wrench_goes_out_numbered_limited_and_only_when_on) {
  Session session;
  session.begin();
  const DeviceWrench wanted{{0, 0, 80}, {0.1, 0, 0}};
  const auto on = force_protocol::decode_wrench(session.driver.wrench_report(wanted, true));
  ASSERT_TRUE(on);
  EXPECT_TRUE(on->on);
  EXPECT_EQ(on->wrench.force, Vec3(0, 0, 8));
  EXPECT_NEAR(on->wrench.torque.x(), 0.1, 1e-8);
  EXPECT_EQ(on->answers, session.next.sequence);
  const auto off = force_protocol::decode_wrench(session.driver.wrench_report(wanted, false));
  ASSERT_TRUE(off);
  EXPECT_FALSE(off->on);
  EXPECT_EQ(off->wrench.force, Vec3::Zero());
  EXPECT_EQ(off->sequence, on->sequence + 1);
}

/// Whatever bits a pose holds, a sample's pose is finite, of unit length and within reach.
void hear_random_poses(unsigned seed, int rounds) {
  Session session;
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> byte(0, 255), chance(0, 99);
  for (int round = 0; round < rounds; ++round) {
    ++session.next.sequence;
    session.next.time_us += 1000;
    session.now += 1ms;
    auto bytes = force_protocol::encode(session.next);
    if (chance(random) < 2)
      for (int i = 0; i < 4; ++i)
        bytes[static_cast<std::size_t>(1 + byte(random) % 37)] =
            static_cast<std::uint8_t>(byte(random));
    session.driver.accept(bytes, session.now, session.sample);
    ASSERT_TRUE(session.sample.X_BH.p.cwiseAbs().maxCoeff() <= 0.26 + 1e-6);
    ASSERT_NEAR(session.sample.X_BH.q.norm(), 1, 1e-6);
  }
  EXPECT_GT(session.sample.count, static_cast<std::uint64_t>(rounds) / 4)
      << "it gets back to work after each";
}

TEST(ForceDevice, random_bits_do_no_harm) { hear_random_poses(1, 50000); }
TEST(ForceDevice, Fuzz_random_bits_do_no_harm) { hear_random_poses(2, 10000000); }

}  // namespace
}  // namespace sonde::test
