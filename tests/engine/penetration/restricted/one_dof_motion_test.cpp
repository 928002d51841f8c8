// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/restricted/one_dof_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/exact_reference.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

Pose start_pose_anywhere(std::mt19937_64& random) {
  return {test::random_rotation(random), test::random_in_ball(random, 1)};
}
Vec3 unit_direction(std::mt19937_64& random) {
  return test::random_rotation(random) * Vec3::UnitZ();
}

// Reference: Eigen's rotation of points about a line.
TEST(OneDofMotion, slides_along_its_line_and_turns_about_its_axis) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 100; ++i) {
    const Pose X = start_pose_anywhere(random);
    const Vec3 d = unit_direction(random), p = test::random_in_ball(random, 1);
    const Vec3 x = test::random_in_ball(random, 1);
    const double s = test::uniform(random, -3, 3);
    const OneDofMotion slide = OneDofMotion::along(X, d), turn = OneDofMotion::about(X, p, d);
    EXPECT_FALSE(slide.turns());
    EXPECT_TRUE(turn.turns());
    EXPECT_LT((slide.at(s) * x - (X * x + s * d)).norm(), 1e-14);
    const Eigen::AngleAxisd about(s, d);
    EXPECT_LT((turn.at(s) * x - (p + about * (X * x - p))).norm(), 1e-14);
    for (const OneDofMotion& motion : {slide, turn}) {
      EXPECT_LT((motion.at(0) * x - X * x).norm(), 1e-14);
      EXPECT_LT((motion.back().at(s) * x - motion.at(-s) * x).norm(), 1e-14);
      EXPECT_EQ(motion.back().turns(), motion.turns());
    }
  }
}

// Reference: differences of the places of points.
TEST(OneDofMotion, no_point_is_faster_than_its_speed_and_one_is_as_fast) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 50; ++i) {
    const Pose X = start_pose_anywhere(random);
    const Vec3 d = unit_direction(random), p = test::random_in_ball(random, 1);
    const Vec3 center = test::random_in_ball(random, 1);
    const double radius = test::uniform(random, 0.1, 2), step = 1e-6;
    EXPECT_EQ(OneDofMotion::along(X, d).speed(center, radius), 1);
    const OneDofMotion turn = OneDofMotion::about(X, p, d);
    const auto speed_of = [&](const Vec3& x) {
      return (turn.at(step) * x - turn.at(-step) * x).norm() / (2 * step);
    };
    const double most = turn.speed(center, radius);
    for (int k = 0; k < 20; ++k)
      EXPECT_LE(speed_of(center + test::random_in_ball(random, radius)), most + 1e-9);
    // The farthest from the axis.
    const Vec3 arm = X * center - p, out = (arm - d * d.dot(arm)).normalized();
    EXPECT_NEAR(speed_of(center + radius * (X.q.conjugate() * out)), most, 1e-8);
  }
}

std::vector<double> events_within(const OneDofMotion& motion, const Corners& a, const Corners& b,
                                  double from, double to, double flat) {
  std::vector<double> out;
  motion.events(a, b, OneDofMotion::Interval(from, to), flat, out);
  std::ranges::sort(out);
  return out;
}

// Reference: by hand. The lowest corner is 0.25 above the plane, the others 1 and 2.
TEST(OneDofMotion, corners_pass_through_a_plane_at_their_heights) {
  const Corners a{Vec3(0, 0, 0.25), Vec3(0.5, 0.1, 1), Vec3(-0.5, 0.2, 2)};
  const Corners b{Vec3(-9, -9, 0), Vec3(9, -9, 0), Vec3(0, 9, 0)};
  const OneDofMotion down = OneDofMotion::along({}, -Vec3::UnitZ());
  const std::vector<double> all = events_within(down, a, b, -10, 10, 0);
  for (const double height : {0.25, 1.0, 2.0})
    EXPECT_TRUE(std::ranges::any_of(all, [&](double s) { return std::abs(s - height) < 1e-14; }))
        << height;
  for (const double s : events_within(down, a, b, 0.5, 1.5, 0)) {
    EXPECT_GT(s, 0.5);
    EXPECT_LT(s, 1.5);
  }
  // About the x axis, the corner at y = 1, z = 0 meets the plane z = −0.5 at 30° and at 150°.
  const Corners arm{Vec3(0, 1, 0), Vec3(0.1, 0, 0), Vec3(-0.1, 0, 0)};
  Corners floor = b;
  for (Vec3& x : floor) x.z() = -0.5;
  const OneDofMotion turn = OneDofMotion::about({}, Vec3::Zero(), -Vec3::UnitX());
  const std::vector<double> turned = events_within(turn, arm, floor, 0, std::numbers::pi, 0);
  for (const double degrees : {30.0, 150.0})
    EXPECT_TRUE(std::ranges::any_of(turned, [&](double s) {
      return std::abs(s - degrees * std::numbers::pi / 180) < 1e-14;
    })) << degrees;
}

/// Where two triangles begin or cease to meet on a motion, by exact predicates (CGAL) at `samples`
/// values of s, and by bisection between these.
std::vector<double> changes_of_meeting(const OneDofMotion& motion, const Corners& a,
                                       const Corners& b, double to, int samples) {
  const Transform start_back(inverse(motion.at(0)));
  const auto meet = [&](double s) {
    const Transform X(motion.at(s));
    Corners moved = a;
    for (Vec3& x : moved) x = X * (start_back * x);
    return test::meet_by_edges(moved, b);
  };
  std::vector<double> out;
  bool before = meet(0);
  for (int k = 1; k <= samples; ++k) {
    double low = to * (k - 1) / samples, high = to * k / samples;
    const bool now = meet(high);
    if (now == before) continue;
    while (high - low > 1e-10) {
      const double middle = 0.5 * (low + high);
      (meet(middle) == before ? low : high) = middle;
    }
    out.push_back(low);
    before = now;
  }
  return out;
}

double nearest_to(const std::vector<double>& events, double s) {
  double least = 1e300;
  for (const double e : events) least = std::min(least, std::abs(e - s));
  return least;
}

// Reference: exact predicates along the way. Bisection and the rounding of poses leave 1e-9.
TEST(OneDofMotion, triangles_begin_and_cease_to_meet_at_its_events_alone) {
  std::mt19937_64 random(3);
  int of_slides = 0, of_turns = 0;
  for (int i = 0; i < 300; ++i) {
    Corners a, b;
    for (Vec3& x : a) x = test::random_in_ball(random, 1);
    for (Vec3& x : b) x = test::random_in_ball(random, 1);
    const Pose X = start_pose_anywhere(random);
    const Vec3 d = unit_direction(random);
    const bool turning = i % 2 == 0;
    const OneDofMotion motion = turning ? OneDofMotion::about(X, test::random_in_ball(random, 1), d)
                                        : OneDofMotion::along(X, d);
    const double to = turning ? 2 * std::numbers::pi : 2;
    const std::vector<double> events = events_within(motion, a, b, 0, to, 0);
    for (const double s : changes_of_meeting(motion, a, b, to, 120)) {
      EXPECT_LT(nearest_to(events, s), 1e-9) << i << " " << turning;
      ++(turning ? of_turns : of_slides);
    }
  }
  EXPECT_GT(of_slides, 50);
  EXPECT_GT(of_turns, 50);
}

// The same for triangles that stay in one plane, z = 0, whose coordinates are exact: they meet
// where a corner passes over a side.
TEST(OneDofMotion, triangles_in_one_plane_meet_where_a_corner_passes_a_side) {
  std::mt19937_64 random(4);
  int changes = 0;
  for (int i = 0; i < 100; ++i) {
    const auto flat = [&] {
      Corners t;
      for (Vec3& x : t) x = {test::uniform(random, -1, 1), test::uniform(random, -1, 1), 0};
      return t;
    };
    const Corners a = flat(), b = flat();
    const double angle = test::uniform(random, 0, 6);
    const Vec3 in_plane(std::cos(angle), std::sin(angle), 0);
    const bool turning = i % 2 == 0;
    const OneDofMotion motion =
        turning ? OneDofMotion::about({}, Vec3(0.3, test::uniform(random, -1, 1), 0), Vec3::UnitZ())
                : OneDofMotion::along({}, in_plane);
    const double to = turning ? 2 * std::numbers::pi : 2;
    const std::vector<double> events = events_within(motion, a, b, 0, to, 1e-12);
    for (const double s : changes_of_meeting(motion, a, b, to, 120)) {
      EXPECT_LT(nearest_to(events, s), 1e-9) << i << " " << turning;
      ++changes;
    }
  }
  EXPECT_GT(changes, 40);
}

}  // namespace
}  // namespace sonde
