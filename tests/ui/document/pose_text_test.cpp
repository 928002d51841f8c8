// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/pose_text.hpp"

#include <gmock/gmock.h>

#include <numbers>
#include <random>
#include <stdexcept>

namespace sonde::ui {
namespace {

using testing::HasSubstr;

constexpr double degree = std::numbers::pi / 180;

std::string complaint(std::string_view text) {
  try {
    pose_in(text);
  } catch (const std::invalid_argument& bad) {
    return bad.what();
  }
  return {};
}

TEST(PoseText, comes_back) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 200; ++i) {
    const Pose pose{
        Quat(normal(random), normal(random), normal(random), normal(random)).normalized(),
        Vec3(normal(random), normal(random), normal(random))};
    const Pose back = pose_in(pose_text(pose));
    EXPECT_EQ(back.p, pose.p);
    EXPECT_LT((back.q.coeffs() - pose.q.coeffs()).norm(), 3e-16) << "normalised once more";
  }
}

TEST(PoseText, takes_what_people_copy) {
  for (const char* text : {"1 2 3 1 0 0 0", "[1, 2, 3, 1, 0, 0, 0]", "1;2;3;1;0;0;0",
                           "px,py,pz,qw,qx,qy,qz\r\n1,2,3,1,0,0,0\r\n", "(1\t2\t3\n+1 0 0 0)"})
    EXPECT_EQ(pose_in(text).p, Vec3(1, 2, 3)) << text;
}

// Reference: the rotation itself, on a point.
TEST(PoseText, a_matrix_goes_to_numpy_and_comes_back) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 200; ++i) {
    const Pose pose{
        Quat(normal(random), normal(random), normal(random), normal(random)).normalized(),
        Vec3(normal(random), normal(random), normal(random))};
    const Pose back = pose_in(matrix_text(pose));
    EXPECT_EQ(back.p, pose.p);
    const Vec3 x(1, -2, 3);
    EXPECT_LT((back * x - pose * x).norm(), 1e-14);
  }
  const std::string text = matrix_text({Quat::Identity(), {1, 2, 3}});
  EXPECT_EQ(text,
            "np.array([[1, 0, 0, 1],\n          [0, 1, 0, 2],\n          [0, 0, 1, 3],\n"
            "          [0, 0, 0, 1]])\n");
}

TEST(PoseText, takes_a_matrix_as_numpy_prints_it) {
  for (const char* text :
       {"[[ 0. -1.  0.  1.]\n [ 1.  0.  0.  2.]\n [ 0.  0.  1.  3.]\n [ 0.  0.  0.  1.]]",
        "array([[0., -1., 0., 1.], [1., 0., 0., 2.], [0., 0., 1., 3.]], dtype=float32)",
        "numpy.array([[0,-1,0,1],[1,0,0,2],[0,0,1,3],[0,0,0,1]])"}) {
    const Pose pose = pose_in(text);
    EXPECT_EQ(pose.p, Vec3(1, 2, 3)) << text;
    EXPECT_LT((pose.q * Vec3::UnitX() - Vec3::UnitY()).norm(), 1e-15) << text;
  }
  EXPECT_THAT(complaint("1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1"), HasSubstr("last row"));
  EXPECT_THAT(complaint("2 0 0 0 0 2 0 0 0 0 2 0"), HasSubstr("length 1"));
  EXPECT_THAT(complaint("1 0 0 0 0 1 0 0 0 0 -1 0"), HasSubstr("mirrors"));
  EXPECT_THAT(complaint("nan 0 0 0 0 1 0 0 0 0 1 0"), HasSubstr("not finite"));
}

TEST(PoseText, says_what_is_wrong) {
  EXPECT_THAT(complaint(""), HasSubstr("there are 0"));
  EXPECT_THAT(complaint("1 2 3"), HasSubstr("there are 3"));
  EXPECT_THAT(complaint("1 2 3 1 0 0 0 4"), HasSubstr("there are 8"));
  EXPECT_THAT(complaint("1 2 x 1 0 0 0"), HasSubstr("\"x\" is no number"));
  EXPECT_THAT(complaint("1 2 3 4 5 6 7"), HasSubstr("length"));
  EXPECT_THAT(complaint("nan 2 3 1 0 0 0"), HasSubstr("not finite"));
}

/// The reference is Eigen's own product of three turns, and the convention's words: roll about x
/// first, then pitch about the fixed y, then yaw about the fixed z.
TEST(PoseText, roll_pitch_and_yaw_are_about_the_fixed_axes) {
  const Quat yaw = of_roll_pitch_yaw(Vec3(0, 0, 90) * degree);
  EXPECT_LT((yaw * Vec3::UnitX() - Vec3::UnitY()).norm(), 1e-15);
  const Quat roll_then_yaw = of_roll_pitch_yaw(Vec3(90, 0, 90) * degree);
  EXPECT_LT((roll_then_yaw * Vec3::UnitY() - Vec3::UnitZ()).norm(), 1e-15);
  for (double roll = -170; roll < 180; roll += 40)
    for (double pitch = -80; pitch < 90; pitch += 20)
      for (double turn = -170; turn < 180; turn += 40) {
        const Vec3 angles = Vec3(roll, pitch, turn) * degree;
        EXPECT_LT((roll_pitch_yaw(of_roll_pitch_yaw(angles)) - angles).norm(), 1e-12);
      }
}

TEST(PoseText, straight_up_still_gives_the_same_turn) {
  for (const double pitch : {90.0, -90.0}) {
    const Quat q = of_roll_pitch_yaw(Vec3(30, pitch, 20) * degree);
    EXPECT_LT(q.angularDistance(of_roll_pitch_yaw(roll_pitch_yaw(q))), 1e-7);
  }
}

}  // namespace
}  // namespace sonde::ui
