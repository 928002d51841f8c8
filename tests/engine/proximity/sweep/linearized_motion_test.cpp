// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/sweep/linearized_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/proximity/queries/placement.hpp"
#include "tests/engine/proximity/small_motions.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/pairs.hpp"

namespace sonde {
namespace {

using test::nudged;
using test::rolled;
using test::rounding_at;

// Reference: where the points of the probe are at any part of the way, by the motion itself.
TEST(Course, no_point_goes_further_than_displacement_along_says) {
  std::mt19937_64 random(5);
  for (const auto& pair : test::body_pairs(55))
    for (int i = 0; i < 50; ++i) {
      const double radius = pair.a->mass.radius;
      const Pose start = test::random_pose(random, *pair.a, *pair.b, 1);
      const Vec3 centre = pair.a->mass.com + test::random_in_ball(random, 2 * radius);
      const double size = std::pow(10, test::uniform(random, -4, -0.3));
      Chart chart(pair.a->mass, nudged(random, *pair.a, start, 0.1 * radius));
      chart.absorb_free_spin(start);
      const Vec6 from = chart.coordinates(start);
      Vec6 to = from + chart.coordinates(
                           rolled(random, chart.device(), centre, 0.1 * size * radius, size));
      const Motion motion(chart, from, to);
      const DisplacementBound most = displacement_bound_along(motion, centre);
      double furthest = 0;  // of what is allowed
      for (int k = 0; k < 20; ++k) {
        const Vec3 x = centre + test::random_in_ball(random, radius);
        const double s = test::uniform(random, 0, 1);
        const double gone = (motion.at(s) * x - motion.at(0) * x).norm();
        const double allowed = s * most.of((x - centre).norm());
        EXPECT_LE(gone, allowed + rounding_at(pair, start)) << pair.name << " " << s;
        furthest = std::max(furthest, gone / allowed);
      }
      EXPECT_GT(furthest, 0.2) << pair.name;  // the bound is of use
    }
}

/// A course of about so much (of the radius; rad), most of it in one of its parts at times.
Course random_course(std::mt19937_64& random, double radius, double size) {
  return {test::random_in_ball(random, size * radius * test::uniform(random, 0, 1)),
          test::random_in_ball(random, size * test::uniform(random, 0, 1))};
}

/// The probe at `u` of a course from X, to first order turned by as much about the centre.
Pose at_part(const Pose& X, const Course& course, const Vec3& centre, double u) {
  const Vec3 turn = u * course.turn;
  const double angle = turn.norm();
  const Vec3 axis = angle > 0 ? Vec3(turn / angle) : Vec3::UnitX();
  const Quat q = (Quat(Eigen::AngleAxisd(angle, axis)) * X.q).normalized();
  return {q, X * centre + u * course.linear - q * centre};
}

/// The least that any point of the probe, of some, is beyond what is allowed from the course, over
/// all of the course: negative where all are within.
double beyond(const Transform& from, const Course& course, const Transform& at, const Vec3& centre,
              const DisplacementBound& allowed, const std::vector<Vec3>& points) {
  constexpr int parts = 2000;
  double least = 1e30;
  for (int k = 0; k <= parts; ++k) {
    const double u = static_cast<double>(k) / parts;
    double most = -1e30;
    for (const Vec3& x : points) {
      const Vec3 there = from * x + u * course.of(from.R * (x - centre));
      most = std::max(most, (at * x - there).norm() - allowed.of((x - centre).norm()));
    }
    least = std::min(least, most);
  }
  return least;
}

// Reference: points of the probe on the motion, and on 2000 parts of the course.
TEST(Course, a_path_goes_no_further_from_it_than_its_deviation) {
  std::mt19937_64 random(6);
  int on_course = 0;
  for (const auto& pair : test::body_pairs(55))
    for (int i = 0; i < 20; ++i) {
      const double radius = pair.a->mass.radius;
      const Pose from = test::random_pose(random, *pair.a, *pair.b, 1);
      const Vec3 centre = pair.a->mass.com + test::random_in_ball(random, radius);
      const double size = std::pow(10, test::uniform(random, -4, -0.5));
      const Course course = random_course(random, radius, size);
      const double off = test::uniform(random, 0, 1) < 0.5 ? 0.01 : 1;
      const Pose start =
          nudged(random, *pair.a, at_part(from, course, centre, test::uniform(random, -0.2, 0.6)),
                 off * 0.1 * size * radius);
      Chart chart(pair.a->mass, nudged(random, *pair.a, start, 0.1 * radius));
      chart.absorb_free_spin(start);
      const Vec6 y = chart.coordinates(start);
      const Pose end =
          nudged(random, *pair.a, at_part(start, course, centre, 0.3), off * 0.1 * size * radius);
      const Motion motion(chart, y, chart.coordinates(end));
      const Transform X(from), begin = motion.at(0);
      const LinearizedMotion path = linearized(motion, centre);
      const double arm = radius + (centre - pair.a->mass.com).norm();
      const DisplacementBound allowed = deviation(X, course, begin, path, centre, arm);
      std::vector<Vec3> points{centre};
      for (int k = 0; k < 12; ++k) points.push_back(centre + test::random_in_ball(random, radius));
      const double step = course.size().of(radius) / 2000 + rounding_at(pair, from);
      for (const double s : {0.0, 0.3, 0.7, 1.0})
        EXPECT_LE(beyond(X, course, motion.at(s), centre, allowed, points), step) << s;
      on_course += allowed.of(arm) < 0.2 * course.size().of(arm);
    }
  EXPECT_GT(on_course, 20);  // the bound is of use
}

// Reference: a closed form. On the course itself the deviation is what a turn by θ leaves of first
// order: of its sine θ³/6, and √2 (1 − cos θ) across; off it by a shift, the shift.
TEST(Course, on_the_course_the_deviation_is_of_second_order) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 200; ++i) {
    const Pose from{test::random_rotation(random), test::random_in_ball(random, 1)};
    const Vec3 centre = test::random_in_ball(random, 1);
    const Course course = random_course(random, 1, std::pow(10, test::uniform(random, -4, -1)));
    const double u = test::uniform(random, 0, 1);
    const Vec3 shift = 0.1 * course.linear.norm() * course.linear.unitOrthogonal();
    Pose at = at_part(from, course, centre, u);
    at.p += shift;
    const DisplacementBound off = deviation(Transform(from), course, Transform(at), {}, centre, 1);
    const double angle = u * course.turn.norm();
    const double second = std::sqrt(2) * (1 - std::cos(angle)) + std::pow(angle, 3) / 6;
    EXPECT_GE(off.linear, shift.norm() * (1 - 1e-9));
    EXPECT_LE(off.linear, (1 + 1e-6) * shift.norm() + second * angle + 1e-12);
    EXPECT_LE(off.turn, 1.1 * second + 1e-12);
    EXPECT_GE(off.turn, 0.9 * std::sqrt(2) * (1 - std::cos(angle)) - 1e-12);
  }
}

}  // namespace
}  // namespace sonde
