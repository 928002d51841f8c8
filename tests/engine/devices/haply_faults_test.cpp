// SPDX-License-Identifier: GPL-3.0-or-later
// What a HaplyArm makes of faults: of the arm, of its grip, and of the service.
#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "engine/devices/haply_arm.hpp"
#include "engine/platform/real_time.hpp"
#include "tests/engine/devices/haply_arms.hpp"

namespace sonde::test {
namespace {

using Kind = ArmReading::Kind;
using Manner = HaplyStandin::Manner;
using testing::AllOf;
using testing::HasSubstr;

TEST_F(HaplyArms, one_that_does_not_open_says_why) {
  EXPECT_THAT(refusal([] { HaplyArm("1234"); }),
              AllOf(HasSubstr("haply/1234"), HasSubstr("knows no arm of this id")));
  standin.say("{\"hello\": \"world\"}");
  EXPECT_THAT(refusal([] { HaplyArm("049D"); }), HasSubstr("knows no arm"));
  standin.say("hello");
  EXPECT_THAT(refusal([] { HaplyArm("049D"); }), HasSubstr("not Haply's service"));
  standin.behave(Manner::mute);
  EXPECT_THAT(refusal([] { HaplyArm("049D"); }), HasSubstr("does not answer"));
  ::setenv("SONDE_HAPLY_PORT", "ten", 1);
  EXPECT_THAT(refusal([] { HaplyArm("049D"); }), HasSubstr("SONDE_HAPLY_PORT is no port: ten"));
}

TEST_F(HaplyArms, the_service_is_found_with_what_is_connected) {
  const HaplyService service = find_haply_service();
  EXPECT_TRUE(service.answers) << service.reason;
  EXPECT_EQ(service.address, "ws://127.0.0.1:" + std::to_string(standin.port()));
  ASSERT_EQ(service.arms.size(), 1U);
  EXPECT_EQ(service.arms[0].id, "049D");
  ::setenv("SONDE_HAPLY_PORT", "0", 1);
  EXPECT_THAT(find_haply_service().reason, HasSubstr("it is not looked for"));
}

TEST_F(HaplyArms, what_keeps_it_from_being_used_is_said_and_passes) {
  struct Fault {
    const char* place;
    const char* bad;
    const char* words;
  };
  for (const Fault& fault :
       {Fault{"/inverse3/0/status/calibrated", "false", "it is not calibrated"},
        Fault{"/inverse3/0/status/power_supply", "false", "it has no power"},
        Fault{"/wireless_verse_grip/0/status/awake", "false", "its VerseGrip sleeps"},
        Fault{"/inverse3/0/config/mount/scale/y", "2", "scales its movements"},
        Fault{"/inverse3/0/state/transform/scale/x", "0.5", "scales its movements"}}) {
    HaplyArm arm("049D");
    awaited(arm, Kind::pose);
    const bool number = std::string(fault.bad).find_first_of("0123456789") == 0;
    standin.set(fault.place, fault.bad);
    EXPECT_EQ(until_said(arm, fault.words).kind, Kind::fault);
    standin.set(fault.place, number ? "1" : "true");
    awaited(arm, Kind::pose);
  }
}

/// Another program has turned the axes; where the service takes ours, it goes on with them.
TEST_F(HaplyArms, axes_in_another_order_are_set_to_ours) {
  standin.set("/inverse3/0/config/basis/permutation", "\"XZY\"");
  HaplyArm arm("049D");
  awaited(arm, Kind::pose);
  standin.say(R"({"inverse3": [{"device_id": "049D", "config": {"basis": {"permutation": "XZY"}},
      "state": {"cursor_position": {"x": 0, "y": 0, "z": 0}}}]})");
  EXPECT_THAT(awaited(arm, Kind::fault).words, HasSubstr("in the order XZY"));
}

TEST_F(HaplyArms, a_grip_that_goes_missing_ends_the_poses) {
  HaplyArm arm("049D");
  awaited(arm, Kind::pose);
  standin.set("/wireless_verse_grip", "[]");
  EXPECT_EQ(until_said(arm, "does not say how it is turned").kind, Kind::fault);
}

TEST_F(HaplyArms, messages_that_are_none_are_faults_and_pass) {
  HaplyArm arm("049D");
  awaited(arm, Kind::pose);
  for (const char* text :
       {" ", "{", "7", R"({"inverse3": [{"device_id": "049D"}]})", R"({"inverse3": []})",
        R"({"inverse3": [{"device_id": "049D", "state":
            {"cursor_position": {"x": 1e999, "y": 0, "z": 0}}}]})"}) {
    standin.say(text);
    EXPECT_EQ(awaited(arm, Kind::fault).kind, Kind::fault) << text;
    standin.say("");
    awaited(arm, Kind::pose);
  }
}

TEST_F(HaplyArms, one_that_is_unplugged_is_gone) {
  HaplyArm arm("049D");
  awaited(arm, Kind::pose);
  standin.set("/inverse3", "[]");
  EXPECT_THAT(awaited(arm, Kind::gone).words, HasSubstr("no longer knows the arm"));
}

TEST_F(HaplyArms, a_service_that_is_silent_is_told_that_the_force_is_zero) {
  HaplyArm arm("049D");
  arm.write({.force = {0, 0, 2}}, true);
  exchange(arm);
  standin.behave(Manner::silent);
  until_said(arm, "does not answer");
  for (int i = 0; i < 20000 && !standin.until_zero(); ++i) arm.read();
  EXPECT_TRUE(standin.force().isZero(0));
  EXPECT_THAT(awaited(arm, Kind::gone).words, HasSubstr("has not answered for 0.1 s"));
}

TEST_F(HaplyArms, a_service_that_answers_late_gives_no_pose) {
  HaplyArm arm("049D");
  awaited(arm, Kind::pose);
  standin.behave(Manner::late);
  until_said(arm, "answers late");
  for (int i = 0; i < 100; ++i) EXPECT_NE(arm.read().kind, Kind::pose);
  standin.behave(Manner::usual);
  awaited(arm, Kind::pose);
}

TEST_F(HaplyArms, a_service_that_floods_or_closes_is_gone) {
  {
    HaplyArm arm("049D");
    awaited(arm, Kind::pose);
    standin.behave(Manner::floods);
    EXPECT_THAT(awaited(arm, Kind::gone).words, HasSubstr("nobody asked for"));
  }
  {
    standin.behave(Manner::usual);
    HaplyArm arm("049D");
    awaited(arm, Kind::pose);
    standin.behave(Manner::pings);
    until_said(arm, "does not answer");
    standin.behave(Manner::usual);
  }
  standin.behave(Manner::usual);
  HaplyArm arm("049D");
  awaited(arm, Kind::pose);
  standin.behave(Manner::closes);
  EXPECT_NE(awaited(arm, Kind::gone).words, "");
}

/// A service that stands still altogether: the force cannot be ended by a word. The end of the
/// connection is what is left.
TEST_F(HaplyArms, a_service_that_does_not_even_read_is_given_up) {
  HaplyArm arm("049D");
  awaited(arm, Kind::pose);
  standin.behave(Manner::deaf);
  awaited(arm, Kind::gone);
  standin.behave(Manner::usual);
}

TEST_F(HaplyArms, Soak_from_silence_to_no_force) {
  const Promptness prompt(true);
  std::vector<double> until;  // ms
  for (int i = 0; i < 50; ++i) {
    standin.behave(Manner::usual);
    HaplyArm arm("049D");
    for (int k = 0; k < 30; ++k) {
      awaited(arm, Kind::pose);
      arm.write({.force = {0, 0, 1}}, true);
    }
    standin.behave(Manner::silent);
    while (!standin.until_zero()) arm.read();
    until.push_back(std::chrono::duration<double, std::milli>(*standin.until_zero()).count());
  }
  std::ranges::sort(until);
  std::printf("from silence to no force: median %.1f, longest %.1f ms\n", until[25], until.back());
  EXPECT_LE(until.back(), 20);
}

}  // namespace
}  // namespace sonde::test
