// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/hd_arm.hpp"

#include <gmock/gmock.h>

#include "tests/engine/devices/loaded_standin.hpp"

namespace sonde::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using Kind = ArmReading::Kind;

constexpr const char* the_default = "Default Device";

struct HdArms : testing::Test {
  LoadedStandin standin{STANDIN_HD};
  std::shared_ptr<const HdLibrary> library = std::make_shared<HdLibrary>(STANDIN_HD);

  /// Two frames from now: what was written has reached the device.
  void frames_pass() {
    const int before = standin->frames;
    for (int i = 0; i < 20000 && standin->frames < before + 3; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
};

TEST_F(HdArms, a_touch_says_what_it_is_and_takes_no_torque) {
  HdArm arm(library, the_default);
  EXPECT_EQ(library->version(), "3.4.0");
  EXPECT_EQ(arm.identity().name, "Touch");
  EXPECT_EQ(arm.identity().serial, "S1");
  EXPECT_EQ(arm.identity().capabilities.max_force, 3.3);
  EXPECT_EQ(arm.identity().capabilities.max_torque, 0);
  // (minX, minY, minZ, maxX, maxY, maxZ) of the stand-in, y up and z to the user.
  EXPECT_LT((arm.identity().capabilities.reach - Vec3(0.21, 0.1075, 0.1575)).norm(), 1e-12);
  awaited(arm, Kind::pose);
  arm.write({{1, 0, 0}, {0, 0, 0.1}}, true);
  frames_pass();
  EXPECT_EQ(standin.force(), Vec3(1, 0, 0));
}

TEST_F(HdArms, the_stiffness_and_damping_that_the_library_recommends_are_limits) {
  {
    HdArm arm(library, the_default);
    EXPECT_EQ(arm.identity().capabilities.max_stiffness, 0) << "it does not know them";
    EXPECT_EQ(arm.identity().capabilities.max_damping, 0);
  }
  standin->stiffest = 0.5;       // N/mm
  standin->most_damped = 0.002;  // N per mm/s
  {
    HdArm arm(library, the_default);
    EXPECT_DOUBLE_EQ(arm.identity().capabilities.max_stiffness, 500);
    EXPECT_DOUBLE_EQ(arm.identity().capabilities.max_damping, 2);
    awaited(arm, Kind::pose);
  }
  for (const double wrong : {-1.0, 1e9, double(NAN)}) {
    standin->stiffest = standin->most_damped = wrong;
    HdArm arm(library, the_default);
    EXPECT_EQ(arm.identity().capabilities.max_stiffness, 0) << wrong;
    EXPECT_EQ(arm.identity().capabilities.max_damping, 0) << wrong;
  }
}

TEST_F(HdArms, poses_come_in_our_frame_and_metres) {
  HdArm arm(library, the_default);
  standin.move_to({10, 20, 30});  // mm: right, up, to the user
  standin->angle = 0.4;           // about the axis to the user
  standin->buttons = 3;
  frames_pass();
  const ArmReading reading = awaited(arm, Kind::pose);
  EXPECT_LT((reading.X_BH.p - Vec3(0.01, -0.03, 0.02)).norm(), 1e-15);
  const Quat expected(Eigen::AngleAxisd(0.4, -Vec3::UnitY()));
  EXPECT_LT(reading.X_BH.q.angularDistance(expected), 1e-12);
  EXPECT_EQ(reading.buttons, 3U);
}

TEST_F(HdArms, a_premium_gets_its_torque_in_millinewton_metres) {
  standin->model = 6;
  HdArm arm(library, the_default);
  EXPECT_EQ(arm.identity().capabilities.max_torque, 0.188);
  awaited(arm, Kind::pose);
  arm.write({{1, 2, 3}, {0.01, 0.02, 0.03}}, true);
  frames_pass();
  // Right, up, to the user; 3.3 N at most.
  EXPECT_LT((standin.force() - 3.3 / std::sqrt(14) * Vec3(1, 3, -2)).norm(), 1e-12);
  EXPECT_LT((standin.torque() - Vec3(10, 30, -20)).norm(), 1e-12);
  arm.write({{0, 0, 0}, {0, 0, 5}}, true);
  frames_pass();
  EXPECT_NEAR(standin.torque().norm(), 188, 1e-9);
}

TEST_F(HdArms, a_wrench_that_nobody_renews_ends_in_the_librarys_own_thread) {
  HdArm arm(library, the_default);
  awaited(arm, Kind::pose);
  arm.write({{1, 0, 0}, {0, 0, 0}}, true);
  frames_pass();
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
  frames_pass();
  EXPECT_EQ(standin.force(), Vec3::Zero());
}

TEST_F(HdArms, what_the_maker_calls_an_error_is_told_in_words) {
  HdArm arm(library, the_default);
  struct Case {
    int code;
    const char* words;
  };
  for (const Case& bad : {Case{0x0200, "too warm"}, Case{0x0203, "velocity limit was exceeded"},
                          Case{0x0201, "limit was exceeded"}, Case{0x0204, "libHD: "}}) {
    standin->fault = bad.code;
    EXPECT_THAT(awaited(arm, Kind::fault).words, HasSubstr(bad.words));
    awaited(arm, Kind::pose);
  }
}

TEST_F(HdArms, without_calibration_there_is_no_pose_and_no_force) {
  standin->uncalibrated = true;
  HdArm arm(library, the_default);
  EXPECT_THAT(awaited(arm, Kind::fault).words, HasSubstr("inkwell"));
  arm.write({{1, 0, 0}, {0, 0, 0}}, true);
  frames_pass();
  EXPECT_EQ(standin.force(), Vec3::Zero());
  standin->uncalibrated = false;
  awaited(arm, Kind::pose);
}

TEST_F(HdArms, no_number_and_no_rotation_are_faults_and_a_clock_that_stands_gives_nothing) {
  HdArm arm(library, the_default);
  standin->skewed = true;
  EXPECT_THAT(awaited(arm, Kind::fault).words, HasSubstr("rotation"));
  standin->skewed = false;
  awaited(arm, Kind::pose);
  standin->frozen = true;
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  arm.read();
  // Where the test itself is held up it may be gone by then; it gives no pose either way.
  for (int i = 0; i < 5; ++i) {
    const Kind kind = arm.read().kind;
    EXPECT_TRUE(kind == Kind::nothing || kind == Kind::gone);
  }
}

TEST_F(HdArms, one_that_is_unplugged_is_gone) {
  HdArm arm(library, the_default);
  awaited(arm, Kind::pose);
  standin->unplugged = true;
  EXPECT_THAT(awaited(arm, Kind::gone).words, HasSubstr("communication error"));
}

TEST_F(HdArms, one_that_does_not_open_gives_the_librarys_word_and_leaves_nothing_open) {
  EXPECT_THAT(refusal([&] { HdArm(library, "Second"); }),
              AllOf(HasSubstr("libHD/Second"), HasSubstr("no such configuration")));
  standin->arms = 2;
  {
    const HdArm arm(library, "Second");
    EXPECT_EQ(arm.identity().serial, "S2");
    EXPECT_THAT(refusal([&] { HdArm(library, the_default); }), HasSubstr("open already"));
  }
  const HdArm again(library, the_default);
  EXPECT_EQ(again.identity().serial, "S1");
}

TEST_F(HdArms, a_version_that_is_not_known_is_refused) {
  standin->major = 2;
  EXPECT_THAT(refusal([&] { HdArm(library, the_default); }),
              AllOf(HasSubstr("libHD/Default Device"), HasSubstr("version of libHD is 2")));
}

TEST(HdLibraries, one_without_a_function_names_it) {
  EXPECT_THAT(refusal([] { HdLibrary{STANDIN_DHD}; }),
              AllOf(HasSubstr(STANDIN_DHD), HasSubstr("hdInitDevice")));
}

}  // namespace
}  // namespace sonde::test
