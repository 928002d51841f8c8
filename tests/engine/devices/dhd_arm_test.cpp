// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/dhd_arm.hpp"

#include <gmock/gmock.h>

#include "tests/engine/devices/loaded_standin.hpp"

namespace sonde::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using Kind = ArmReading::Kind;

struct DhdArms : testing::Test {
  LoadedStandin standin{STANDIN_DHD};
  std::shared_ptr<const DhdLibrary> library = std::make_shared<DhdLibrary>(STANDIN_DHD);
};

TEST_F(DhdArms, an_arm_says_what_it_is_and_can) {
  EXPECT_EQ(library->version(), "3.14.1.0");
  const DhdArm arm(library, 0);
  EXPECT_EQ(arm.identity().name, "sigma.7 right-handed");
  EXPECT_EQ(arm.identity().serial, "4000");
  EXPECT_EQ(arm.identity().capabilities.max_force, 12);
  EXPECT_EQ(arm.identity().capabilities.max_torque, 0.2);
  EXPECT_TRUE(standin->gravity);
  EXPECT_FALSE(standin->force_on) << "not before a force is wanted";
}

TEST_F(DhdArms, an_omega_takes_no_torque) {
  standin->model = 35;
  DhdArm arm(library, 0);
  EXPECT_EQ(arm.identity().capabilities.max_torque, 0);
  arm.write({{1, 0, 0}, {0, 0, 0.1}}, true);
  EXPECT_EQ(standin.torque(), Vec3::Zero());
  EXPECT_NE(standin.force(), Vec3::Zero());
}

// By their numbers in the library (forcedimension_core, constants.py) and CHAI3D's limits: a
// Falcon, which bears 8 N, and a sigma.3 and a lambda.3, of which no limits are published.
TEST_F(DhdArms, an_arm_that_is_not_known_gets_no_more_than_the_weakest) {
  for (const int model : {60, 206, 203, 999}) {
    standin->model = model;
    DhdArm arm(library, 0);
    EXPECT_EQ(arm.identity().capabilities.max_force, 8) << model;
    EXPECT_EQ(arm.identity().capabilities.max_torque, 0) << model;
    arm.write({{0, 30, 40}, {0, 0, 1}}, true);
    EXPECT_NEAR(standin.force().norm(), 8, 1e-12) << model;
    EXPECT_EQ(standin.torque(), Vec3::Zero()) << model;
  }
}

// x of the library is towards the user, y to the right, z up; ours right, away, up.
TEST_F(DhdArms, poses_come_in_our_frame_and_metres) {
  DhdArm arm(library, 0);
  standin.move_to({0.01, 0.02, 0.03});
  standin->angle = 0.4;
  standin->buttons = 1;
  const ArmReading reading = awaited(arm, Kind::pose);
  EXPECT_LT((reading.X_BH.p - Vec3(0.02, -0.01, 0.03)).norm(), 1e-15);
  const Quat expected(Eigen::AngleAxisd(0.4, Vec3::UnitZ()));
  EXPECT_LT(reading.X_BH.q.angularDistance(expected), 1e-12);
  EXPECT_EQ(reading.buttons, 1U);
}

TEST_F(DhdArms, a_wrench_goes_out_in_the_librarys_frame_and_within_the_limits) {
  DhdArm arm(library, 0);
  EXPECT_TRUE(arm.write({{1, 2, 3}, {0.01, 0.02, 0.03}}, true));
  EXPECT_TRUE(standin->force_on);
  EXPECT_LT((standin.force() - Vec3(-2, 1, 3)).norm(), 1e-15);
  EXPECT_LT((standin.torque() - Vec3(-0.02, 0.01, 0.03)).norm(), 1e-15);
  arm.write({{0, 300, 400}, {0, 0, 5}}, true);
  EXPECT_NEAR(standin.force().norm(), 12, 1e-12);
  EXPECT_NEAR(standin.torque().norm(), 0.2, 1e-12);
  arm.write({{std::nan(""), 1, 1}, {0, 0, 0}}, true);
  EXPECT_EQ(standin.force(), Vec3::Zero());
  arm.write({{1, 1, 1}, {0, 0, 0}}, true);
  arm.write({{1, 1, 1}, {0, 0, 0}}, false);
  EXPECT_EQ(standin.force(), Vec3::Zero());
}

/// The work of a wrench on a motion is the same in both frames: the maps of poses and wrenches
/// belong together.
TEST_F(DhdArms, the_work_is_the_same_in_both_frames) {
  DhdArm arm(library, 0);
  const Vec3 in_theirs(0.01, -0.02, 0.005);
  standin.move_to(in_theirs);
  const Vec3 in_ours = awaited(arm, Kind::pose).X_BH.p;
  const Vec3 force(0.3, 1.1, -0.7);
  arm.write({force, Vec3::Zero()}, true);
  EXPECT_NEAR(standin.force().dot(in_theirs), force.dot(in_ours), 1e-15);
}

TEST_F(DhdArms, a_clock_that_stands_gives_no_pose) {
  DhdArm arm(library, 0);
  standin->frozen = true;
  for (int i = 0; i < 20; ++i) EXPECT_EQ(arm.read().kind, Kind::nothing);
}

TEST_F(DhdArms, what_cannot_be_used_says_why) {
  DhdArm arm(library, 0);
  standin->uncalibrated = true;
  EXPECT_THAT(awaited(arm, Kind::fault).words, HasSubstr("not calibrated"));
  standin->uncalibrated = false;
  awaited(arm, Kind::pose);
  standin->skewed = true;
  EXPECT_THAT(awaited(arm, Kind::fault).words, HasSubstr("rotation"));
}

TEST_F(DhdArms, an_exceeded_velocity_is_told_and_the_force_stays_off_for_a_while) {
  DhdArm arm(library, 0);
  arm.write({{1, 0, 0}, {0, 0, 0}}, true);
  ASSERT_TRUE(standin->force_on);
  standin->fault = 2;  // DHD's cause: velocity
  EXPECT_THAT(awaited(arm, Kind::fault).words, HasSubstr("velocity limit was exceeded"));
  EXPECT_FALSE(standin->force_on);
  arm.write({{1, 0, 0}, {0, 0, 0}}, true);
  EXPECT_FALSE(standin->force_on);
  EXPECT_EQ(awaited(arm, Kind::pose).words, "");
}

TEST_F(DhdArms, one_that_is_unplugged_is_gone) {
  DhdArm arm(library, 0);
  awaited(arm, Kind::pose);
  standin->unplugged = true;
  EXPECT_THAT(awaited(arm, Kind::gone).words, HasSubstr("communication error"));
  EXPECT_FALSE(arm.write({{1, 0, 0}, {0, 0, 0}}, true));
}

TEST_F(DhdArms, one_that_does_not_open_gives_the_librarys_word) {
  EXPECT_THAT(refusal([&] { DhdArm(library, 3); }),
              AllOf(HasSubstr("libdhd/3"), HasSubstr("no device found")));
  const DhdArm first(library, 0);
  EXPECT_THAT(refusal([&] { DhdArm(library, 0); }), HasSubstr("device in use"));
}

TEST_F(DhdArms, a_version_that_is_not_known_is_refused_before_anything_is_opened) {
  for (const auto& [major, minor] : {std::pair(3, 2), std::pair(4, 0), std::pair(2, 9)}) {
    standin->major = major;
    standin->minor = minor;
    EXPECT_THAT(refusal([] { DhdLibrary{STANDIN_DHD}; }),
                AllOf(HasSubstr(STANDIN_DHD), HasSubstr("version is")));
  }
  EXPECT_EQ(standin->opened, 0);
}

TEST(DhdLibraries, one_without_a_function_names_it) {
  EXPECT_THAT(refusal([] { DhdLibrary{STANDIN_DHD_WITHOUT}; }),
              AllOf(HasSubstr(STANDIN_DHD_WITHOUT), HasSubstr("dhdErrorGetLastStr")));
  EXPECT_THAT(refusal([] { DhdLibrary{STANDIN_HD}; }), HasSubstr("dhdGetSDKVersion"));
}

}  // namespace
}  // namespace sonde::test
