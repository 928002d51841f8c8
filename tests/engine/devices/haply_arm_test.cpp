// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/haply_arm.hpp"

#include <gmock/gmock.h>

#include <cstdio>
#include <limits>
#include <memory>
#include <thread>

#include "engine/haptics/loop/time_histogram.hpp"
#include "engine/platform/real_time.hpp"
#include "tests/engine/devices/haply_arms.hpp"

namespace sonde::test {
namespace {

using Kind = ArmReading::Kind;
using Manner = HaplyStandin::Manner;
using testing::HasSubstr;
using namespace std::chrono_literals;

TEST_F(HaplyArms, one_says_what_it_is_and_takes_no_torque) {
  HaplyArm arm("049D");
  EXPECT_EQ(HaplyArm::open(), 1);
  EXPECT_EQ(arm.identity().name, "Haply Inverse3");
  EXPECT_EQ(arm.identity().serial, "haply-049D");
  EXPECT_EQ(arm.identity().capabilities.max_force, 10);
  EXPECT_EQ(arm.identity().capabilities.max_torque, 0);
  EXPECT_EQ(arm.identity().capabilities.buttons, 3U);
  arm.write({{1, -2, 3}, {0.1, 0, 0}}, true);
  exchange(arm);
  EXPECT_EQ(standin.force(), Vec3(1, -2, 3)) << "its axes are ours";
}

TEST_F(HaplyArms, its_pose_is_the_cursor_turned_as_the_grip) {
  const Quat q(Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()));
  standin.move_to({0.01, -0.12, 0.15});
  standin.turn_to(q);
  standin.set("/wireless_verse_grip/0/state/buttons/b", "true");
  HaplyArm arm("049D");
  const ArmReading reading = awaited(arm, Kind::pose);
  EXPECT_EQ(reading.X_BH.p, Vec3(0.01, -0.12, 0.15));
  EXPECT_EQ(reading.X_BH.q.coeffs(), q.coeffs());
  EXPECT_EQ(reading.buttons, 2U);
}

TEST_F(HaplyArms, each_message_has_one_answer) {
  HaplyArm arm("049D");
  std::uint64_t answers = 0;
  for (int i = 0; i < 500; ++i) answers += arm.read().kind == Kind::nothing ? 0 : 1;
  EXPECT_GT(answers, 100U);
  EXPECT_LE(standin.answered(), standin.asked());
  EXPECT_LE(standin.asked(), answers + 1) << "none is asked twice";
}

/// Reading and writing in turn, as fast as it goes, is still one message a millisecond.
TEST_F(HaplyArms, nobody_makes_it_ask_more_often) {
  HaplyArm arm("049D");
  const auto begin = DeviceClock::now();
  for (int i = 0; i < 200; ++i) {
    awaited(arm, Kind::pose);
    arm.write({.force = {0, 0, 1}}, true);
  }
  const std::chrono::duration<double, std::milli> passed = DeviceClock::now() - begin;
  EXPECT_GE(passed.count(), 199);
  EXPECT_LE(static_cast<double>(standin.asked()), passed.count() + 2);
}

TEST_F(HaplyArms, a_force_is_within_the_models_limit_and_none_where_it_is_no_number) {
  HaplyArm arm("049D");
  arm.write({.force = {0, 30, 40}}, true);
  exchange(arm);
  EXPECT_LT((standin.force() - Vec3(0, 6, 8)).norm(), 1e-12) << "10 N in its direction";
  arm.write({.force = {0, std::numeric_limits<double>::quiet_NaN(), 1}}, true);
  exchange(arm);
  EXPECT_TRUE(standin.force().isZero(0));
  arm.write({.force = {0, 0, 1}}, true);
  exchange(arm);
  arm.write({.force = {0, 0, 1}}, false);
  exchange(arm);
  EXPECT_TRUE(standin.force().isZero(0));
}

/// The service reads nothing for a while, and then one message in 5 ms: what it answers first is
/// old. There is a pose only where nothing is left to come.
TEST_F(HaplyArms, answers_to_earlier_messages_are_no_poses) {
  HaplyArm arm("049D");
  awaited(arm, Kind::pose);
  standin.behave(Manner::deaf);
  for (int i = 0; i < 20; ++i) arm.read();
  standin.behave(Manner::slow);
  std::uint64_t others = 0;
  ArmReading reading;
  for (int i = 0; i < 20000 && reading.kind != Kind::pose; ++i) {
    reading = arm.read();
    others += reading.kind == Kind::fault ? 1 : 0;
  }
  EXPECT_GE(others, 3U);
  EXPECT_EQ(standin.asked(), standin.answered()) << "nothing is left to come";
}

TEST_F(HaplyArms, a_program_opens_one_only_once) {
  const HaplyArm arm("049D");
  EXPECT_THAT(refusal([] { HaplyArm("049D"); }), HasSubstr("has it open already"));
}

/// Another program may hold it, and its force is nobody else's to end.
TEST_F(HaplyArms, one_that_was_only_looked_at_was_told_nothing) {
  { const HaplyArm arm("049D"); }
  { const HaplyArm again("049D"); }
  find_haply_service();
  EXPECT_EQ(standin.asked(), 0U);
}

TEST_F(HaplyArms, one_of_a_model_that_is_not_told_gets_the_least_force) {
  standin.set("/inverse3/0/config/type", "null");
  EXPECT_EQ(HaplyArm("049D").identity().capabilities.max_force, 3);
}

/// The mount is told once in many messages: it is not forgotten meanwhile.
TEST_F(HaplyArms, a_scaled_mount_never_gives_a_pose) {
  standin.set("/inverse3/0/config/mount/scale/z", "2");
  HaplyArm arm("049D");
  for (int i = 0; i < 500; ++i) EXPECT_NE(arm.read().kind, Kind::pose) << i;
}

TEST_F(HaplyArms, a_grip_with_a_cable_and_one_that_comes_later_count) {
  standin.set("/wireless_verse_grip", "[]");
  HaplyArm arm("049D");
  awaited(arm, Kind::pose);
  standin.set("/verse_grip", R"([{"device_id": "7", "state": {"button": true, "hall": 1,
      "orientation": {"w": 0, "x": 0, "y": 0, "z": 1}}}])");
  ArmReading reading;
  for (int i = 0; i < 20000 && reading.buttons == 0; ++i) reading = arm.read();
  EXPECT_EQ(reading.buttons, 1U);
  EXPECT_EQ(reading.X_BH.q.z(), 1);
}

TEST_F(HaplyArms, of_two_grips_the_one_that_is_awake_counts) {
  standin.set("/wireless_verse_grip/0/status/awake", "false");
  standin.set("/verse_grip", R"([{"device_id": "7", "status": {"connected": true},
      "state": {"orientation": {"w": 0, "x": 1, "y": 0, "z": 0}}}])");
  HaplyArm arm("049D");
  EXPECT_EQ(awaited(arm, Kind::pose).X_BH.q.x(), 1);
}

/// As where it falls asleep, or is swapped for another: first no pose, for the handle did not turn.
TEST_F(HaplyArms, another_grip_takes_over) {
  const std::string other = R"([{"device_id": "7", "status": {"connected": true},
      "state": {"orientation": {"w": 0, "x": 1, "y": 0, "z": 0}}}])";
  for (const auto& [place, value] : {std::pair("/wireless_verse_grip/0/status/awake", "false"),
                                     std::pair("/wireless_verse_grip", "[]")}) {
    HaplyArm arm("049D");
    EXPECT_EQ(awaited(arm, Kind::pose).X_BH.q.x(), 0);
    standin.set("/verse_grip", other);
    standin.set(place, value);
    EXPECT_EQ(awaited(arm, Kind::fault).kind, Kind::fault) << place;
    EXPECT_EQ(awaited(arm, Kind::pose).X_BH.q.x(), 1) << place;
    standin.set("/verse_grip", "[]");
    if (place == std::string("/wireless_verse_grip")) continue;
    standin.set(place, "true");
    awaited(arm, Kind::fault);
    EXPECT_EQ(awaited(arm, Kind::pose).X_BH.q.x(), 0) << "and back";
  }
}

constexpr const char* wired_grip = R"([{"device_id": "7", "status": {"connected": true},
      "state": {"orientation": {"w": 0, "x": 1, "y": 0, "z": 0}}}])";

/// Each hand turns its own: the stand-in knows which grip is turned by which quarter.
TEST_F(HaplyArms, two_arms_follow_two_grips) {
  standin.add_arm("0BB2");
  standin.set("/verse_grip", wired_grip);
  HaplyArm first("049D"), second("0BB2");
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(awaited(first, Kind::pose).X_BH.q.x(), 0);
    EXPECT_EQ(awaited(second, Kind::pose).X_BH.q.x(), 1);
  }
}

TEST_F(HaplyArms, a_second_arm_does_not_take_the_grip_of_the_first_until_that_closes) {
  standin.add_arm("0BB2");
  standin.turn_to(Quat(0, 0, 1, 0));
  auto first = std::make_unique<HaplyArm>("049D");
  HaplyArm second("0BB2");
  EXPECT_EQ(second.identity().name, "Haply Inverse3 without a VerseGrip");
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(awaited(*first, Kind::pose).X_BH.q.y(), 1);
    EXPECT_EQ(awaited(second, Kind::pose).X_BH.q.y(), 0);
  }
  // A grip that falls asleep is no reason to take that of the other hand.
  standin.set("/verse_grip", wired_grip);
  for (int i = 0; i < 20000 && awaited(second, Kind::pose).X_BH.q.x() != 1; ++i) continue;
  EXPECT_EQ(awaited(second, Kind::pose).X_BH.q.x(), 1);
  standin.set("/wireless_verse_grip/0/status/awake", "false");
  EXPECT_EQ(until_said(*first, "its VerseGrip sleeps").kind, Kind::fault);
  first.reset();
  standin.set("/wireless_verse_grip/0/status/awake", "true");
  standin.set("/verse_grip", "[]");
  for (int i = 0; i < 20000 && awaited(second, Kind::pose).X_BH.q.y() != 1; ++i) continue;
  EXPECT_EQ(awaited(second, Kind::pose).X_BH.q.y(), 1) << "nobody follows it now";
}

/// The slow service reads the zero only after it has answered the message before.
TEST_F(HaplyArms, it_closes_with_its_force_off) {
  for (const Manner manner : {Manner::usual, Manner::slow}) {
    {
      HaplyArm arm("049D");
      arm.write({.force = {0, 0, 2}}, true);
      exchange(arm);
      EXPECT_EQ(standin.force(), Vec3(0, 0, 2));
      standin.behave(manner);
      arm.write({.force = {0, 0, 1}}, true);
    }
    EXPECT_EQ(HaplyArm::open(), 0);
    for (int i = 0; i < 20000 && !standin.force().isZero(0); ++i) std::this_thread::sleep_for(1ms);
    EXPECT_TRUE(standin.force().isZero(0));
    standin.behave(Manner::usual);
  }
}

/// Its own thread's delay is no silence of the service.
TEST_F(HaplyArms, who_asks_late_is_not_answered_late) {
  HaplyArm arm("049D");
  int poses = 0;
  for (int i = 0; i < 5; ++i) {
    awaited(arm, Kind::pose);
    std::this_thread::sleep_for(50ms);
    ArmReading reading;
    while (reading.kind == Kind::nothing) reading = arm.read();
    poses += reading.kind == Kind::pose ? 1 : 0;
  }
  EXPECT_GT(poses, 0) << "the machine may be slow, but not each time";
}

TEST_F(HaplyArms, the_models_are_told_apart) {
  for (const auto& [type, name, force] : {std::tuple("inverse3x", "Haply Inverse3x", 10.),
                                          std::tuple("minverse", "Haply Minverse", 3.),
                                          std::tuple("inverse9", "Haply arm (inverse9)", 3.)}) {
    standin.set("/inverse3/0/config/type", '"' + std::string(type) + '"');
    const HaplyArm arm("049D");
    EXPECT_EQ(arm.identity().name, name);
    EXPECT_EQ(arm.identity().capabilities.max_force, force);
  }
}

TEST_F(HaplyArms, without_a_grip_it_does_not_turn) {
  standin.set("/wireless_verse_grip", "[]");
  HaplyArm arm("049D");
  EXPECT_EQ(arm.identity().name, "Haply Inverse3 without a VerseGrip");
  EXPECT_EQ(awaited(arm, Kind::pose).X_BH.q.coeffs(), Quat::Identity().coeffs());
}

/// Ten minutes at 1 kHz, from a message to its answer. This thread is as prompt as the one that
/// reads a device, and so is the stand-in's.
TEST_F(HaplyArms, Soak_ten_minutes_at_a_kilohertz) {
  HaplyArm arm("049D");
  const Promptness prompt(true);
  TimeHistogram times;
  const auto lasting = 10min;
  const auto begin = DeviceClock::now();
  std::uint64_t poses = 0, others = 0;
  while (DeviceClock::now() - begin < lasting) {
    const ArmReading reading = arm.read();
    reading.kind == Kind::pose ? ++poses : ++others;
    if (reading.kind == Kind::pose) times.add(arm.round_trip().count());
    arm.write({.force = {0, 0, 1}}, true);
  }
  std::printf("%llu poses, %llu other readings; round trip: median %.3f, 99.9 %% %.3f, %s\n",
              static_cast<unsigned long long>(poses), static_cast<unsigned long long>(others),
              1e-3 * times.quantile(0.5), 1e-3 * times.quantile(0.999), "ms");
  EXPECT_GT(static_cast<double>(poses), 570000);
  EXPECT_LE(times.quantile(0.999), 1000);
}

}  // namespace
}  // namespace sonde::test
