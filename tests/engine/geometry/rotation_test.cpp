// SPDX-License-Identifier: GPL-3.0-or-later
// References: half angles written out; Eigen's angle and axis, which are exact away from no turn.
#include "engine/geometry/rotation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "engine/geometry/random.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

TEST(Rotation, no_turn_is_zero_both_ways) {
  EXPECT_EQ(rotation_vector(Quat::Identity()), Vec3(0, 0, 0));
  EXPECT_EQ(rotation_vector(Quat(-1, 0, 0, 0)), Vec3(0, 0, 0));
  EXPECT_EQ(rotation_by(Vec3::Zero()).coeffs(), Quat::Identity().coeffs());
}

TEST(Rotation, small_turns_and_half_turns_keep_their_digits) {
  for (const double angle : {1e-100, 1e-12, 1e-3, 1.0, std::numbers::pi}) {
    const Quat q(std::cos(angle / 2), 0, std::sin(angle / 2), 0);
    EXPECT_NEAR(rotation_vector(q).y() / angle, 1, 1e-15) << angle;
    EXPECT_NEAR(rotation_by(Vec3(0, angle, 0)).y() / q.y(), 1, 1e-15) << angle;
  }
}

TEST(Rotation, the_shorter_way_round_whatever_the_sign) {
  const double angle = 2;
  const Quat q(std::cos(angle / 2), std::sin(angle / 2), 0, 0);
  EXPECT_NEAR(rotation_vector(Quat(-q.coeffs())).x(), angle, 1e-15);
  const double more = 2 * std::numbers::pi - 1;
  const Quat far(std::cos(more / 2), std::sin(more / 2), 0, 0);
  EXPECT_NEAR(rotation_vector(far).x(), -1, 1e-15);
}

TEST(Rotation, one_undoes_the_other_and_is_that_of_eigen) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 vector = test::random_in_ball(random, 3.1);
    const Quat q = rotation_by(vector);
    EXPECT_LT((rotation_vector(q) - vector).norm(), 1e-13);
    const Eigen::AngleAxisd reference(q);
    EXPECT_LT((reference.angle() * reference.axis() - vector).norm(), 1e-7);
  }
}

/// The reference is Eigen's, by the C library.
TEST(Rotation, about_an_axis_between_two_and_the_angle_between_them_are_as_eigen_has_them) {
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const Quat q = random.rotation(), r = random.rotation();
    const Vec3 axis = q * Vec3::UnitX();
    const double angle = random.uniform(-7, 7), part = random.uniform(0, 1);
    const Quat about(Eigen::AngleAxisd(angle, axis));
    EXPECT_LT((rotation_about(axis, angle).coeffs() - about.coeffs()).norm(), 1e-15);
    const Quat near = rotation_by(random.uniform(0, 1e-8) * axis) * q;
    for (const Quat& to : {r, near, q, Quat(-r.coeffs())}) {
      EXPECT_LT((rotation_between(q, to, part).coeffs() - q.slerp(part, to).coeffs()).norm(),
                1e-14);
      EXPECT_NEAR(angle_between(q, to), q.angularDistance(to), 1e-14);
    }
  }
}

}  // namespace
}  // namespace sonde
