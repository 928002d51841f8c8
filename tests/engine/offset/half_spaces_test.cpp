// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/offset/half_spaces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

constexpr double rounding = 1e-12;

double most_missed(const std::vector<HalfSpace3>& spaces, const Vec3& x) {
  double most = 0;
  for (const HalfSpace3& s : spaces) most = std::max(most, s.least - s.normal.dot(x));
  return most;
}

/// Brute force: the nearest of all points that one, two or three of the planes determine.
std::optional<Vec3> nearest_of_all(const std::vector<HalfSpace3>& spaces, const Vec3& from) {
  std::optional<Vec3> best;
  const auto offer = [&](const Vec3& x) {
    if (!x.allFinite() || most_missed(spaces, x) > 1e-9) return;
    if (!best || (x - from).norm() < (*best - from).norm()) best = x;
  };
  offer(from);
  const std::size_t n = spaces.size();
  for (std::size_t i = 0; i < n; ++i) {
    offer(from + (spaces[i].least - spaces[i].normal.dot(from)) * spaces[i].normal);
    for (std::size_t j = 0; j < i; ++j) {
      Eigen::Matrix<double, 2, 3> two;
      two << spaces[i].normal.transpose(), spaces[j].normal.transpose();
      const Eigen::Vector2d least(spaces[i].least, spaces[j].least);
      offer(from + two.transpose() * (two * two.transpose()).inverse() * (least - two * from));
      for (std::size_t k = 0; k < j; ++k) {
        Mat3 three;
        three << two, spaces[k].normal.transpose();
        offer(three.inverse() * Vec3(least.x(), least.y(), spaces[k].least));
      }
    }
  }
  return best;
}

TEST(HalfSpaces, the_nearest_point_is_that_of_brute_force) {
  std::mt19937_64 random(1);
  int without = 0;
  for (int round = 0; round < 3000; ++round) {
    std::vector<HalfSpace3> spaces;
    const int n = 1 + round % 12;
    for (int i = 0; i < n; ++i)
      spaces.push_back(
          {test::random_in_ball(random, 1).normalized(), test::uniform(random, -0.5, 1)});
    const Vec3 from = test::random_in_ball(random, 2);
    const auto found = nearest_in(spaces, from, rounding), expected = nearest_of_all(spaces, from);
    ASSERT_EQ(found.has_value(), expected.has_value()) << round;
    without += !found;
    if (!found) continue;
    EXPECT_LE(most_missed(spaces, *found), 1e-9) << round;
    EXPECT_NEAR((*found - from).norm(), (*expected - from).norm(), 1e-8) << round;
  }
  EXPECT_GT(without, 300) << "both answers occur";
  EXPECT_LT(without, 2700);
}

TEST(HalfSpaces, planes_of_a_cone_meet_in_its_tip) {
  for (const int sides : {3, 17, 64, 1000}) {
    std::vector<HalfSpace3> spaces;
    const double slope = 0.3;
    for (int i = 0; i < sides; ++i) {
      const double a = test::two_pi * i / sides;
      spaces.push_back(
          {Vec3(std::cos(slope) * std::cos(a), std::cos(slope) * std::sin(a), std::sin(slope)),
           0.01});
    }
    const Vec3 tip(0, 0, 0.01 / std::sin(slope));
    EXPECT_LT((nearest_to_planes(spaces) - tip).norm(), 1e-14) << sides;
    const auto found = nearest_in(spaces, Vec3::Zero(), 1e-14);
    ASSERT_TRUE(found) << sides;
    EXPECT_LT((*found - tip).norm(), 1e-10) << sides;
  }
}

TEST(HalfSpaces, opposite_ones_that_leave_nothing_have_no_point) {
  std::vector<HalfSpace3> spaces{{Vec3::UnitX(), 1}, {-Vec3::UnitX(), -0.5}};
  EXPECT_FALSE(nearest_in(spaces, Vec3::Zero(), rounding));
  spaces[1].least = -1;
  ASSERT_TRUE(nearest_in(spaces, Vec3::Zero(), rounding));
  EXPECT_EQ(*nearest_in(spaces, Vec3(0, 3, 4), rounding), Vec3(1, 3, 4));
  EXPECT_EQ(*nearest_in({}, Vec3(0, 3, 4), rounding), Vec3(0, 3, 4));
}

TEST(HalfSpaces, two_planes_meet_nearest_in_the_plane_of_their_normals) {
  for (const double angle : {0.1, 1.0, 2.0, 3.0}) {
    const std::vector<HalfSpace3> spaces{{Vec3::UnitX(), 1},
                                         {Vec3(std::cos(angle), std::sin(angle), 0), 1}};
    const Vec3 expected = Vec3(std::cos(angle / 2), std::sin(angle / 2), 0) / std::cos(angle / 2);
    EXPECT_LT((nearest_to_planes(spaces) - expected).norm(), 1e-12 * expected.norm());
  }
}

}  // namespace
}  // namespace sonde
