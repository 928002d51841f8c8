// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/sweep/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/geometry/chart_cases.hpp"

namespace sonde {
namespace {

using test::chart_cases::any_pose;
using test::chart_cases::bodies;
using test::chart_cases::random_y;
using test::chart_cases::size_of;

/// Motions that the chart allows, up to |v| = 0.9 at both ends.
template <class Each>
void for_motions(std::uint64_t seed, int count, const Each& each) {
  std::mt19937_64 random(seed);
  for (const auto& [name, body] : bodies())
    for (int i = 0; i < count; ++i) {
      const double r = body->mass.radius;
      const Chart chart(body->mass, any_pose(random, r));
      const Vec6 from = random_y(random, *body, 0.9, r), to = random_y(random, *body, 0.9, r);
      each(name, *body, chart, from, to, Motion(chart, from, to), random);
    }
}

TEST(Motion, is_the_straight_path_in_the_chart) {
  for_motions(6, 50,
              [](const char* name, const Body& body, const Chart& chart, const Vec6& from,
                 const Vec6& to, const Motion& motion, std::mt19937_64& random) {
                const double s = test::uniform(random, 0, 1);
                const Transform expected(chart.pose(from + s * (to - from))), X = motion.at(s);
                for (const Vec3& x : body.soup.vertices)
                  EXPECT_LT((X * x - expected * x).norm(), 1e-13 * size_of(body)) << name;
                EXPECT_NEAR(motion.linear_distance(), (to - from).tail<3>().norm(),
                            1e-13 * size_of(body));
                EXPECT_LT((motion.com() - body.mass.com).norm(), 1e-15 * size_of(body));
              });
}

// Reference: differences along the path, of the velocity for the acceleration. The bounds are held
// against the largest found on 100 samples, and against themselves for being of use.
TEST(Motion, velocity_and_the_bounds_of_acceleration_and_turn) {
  double tightest_turn = 1e300, tightest_acceleration = 1e300;
  for_motions(7, 50,
              [&](const char* name, const Body& body, const Chart&, const Vec6&, const Vec6&,
                  const Motion& motion, std::mt19937_64& random) {
                const double r = body.mass.radius;
                const Vec3 x = body.mass.com + r * test::random_in_ball(random, 1).normalized();
                const auto place = [&](double s) { return Vec3(motion.at(s) * x); };
                const auto velocity = [&](double s) {
                  const auto v = motion.velocity(s);
                  return Vec3(v.linear + v.angular.cross(place(s) - motion.at(s) * body.mass.com));
                };
                double turned = 0, way = 0, fastest = 0;
                constexpr int n = 100;
                for (int i = 0; i < n; ++i) {
                  const double s = (i + 0.5) / n, h = 1e-5;
                  const Vec3 measured = (place(s + h) - place(s - h)) / (2 * h);
                  const double speed = motion.linear_distance() + r * motion.turn_bound();
                  EXPECT_LT((velocity(s) - measured).norm(), 1e-6 * speed) << name;
                  const double acceleration = (velocity(s + h) - velocity(s - h)).norm() / (2 * h);
                  EXPECT_LE(acceleration, r * motion.acceleration_per_radius() * (1 + 1e-4))
                      << name;
                  fastest = std::max(fastest, acceleration);
                  turned += motion.velocity(s).angular.norm() / n;
                  way += (place(s + 0.5 / n) - place(s - 0.5 / n)).norm();
                }
                EXPECT_LE(turned, motion.turn_bound() * (1 + 1e-3)) << name;
                EXPECT_LE(way, motion.linear_distance() + r * motion.turn_bound()) << name;
                if (turned > 0.1) {
                  tightest_turn = std::min(tightest_turn, motion.turn_bound() / turned);
                  tightest_acceleration = std::min(tightest_acceleration,
                                                   r * motion.acceleration_per_radius() / fastest);
                }
              });
  EXPECT_LT(tightest_turn, 1.05);
  EXPECT_LT(tightest_acceleration, 3);
}

// Reference: the second derivative of the path by central differences of at(), which knows nothing
// of how the bend was derived; trusted to 1e-6 of the largest acceleration there may be. The error
// is of the third order: it is held against that as well, for being of use.
TEST(Motion, bend_is_the_acceleration_to_within_its_error) {
  std::mt19937_64 random(9);
  int of_use = 0, wide = 0;
  for (const auto& [name, body] : bodies())
    for (int i = 0; i < 400; ++i) {
      const double r = body->mass.radius;
      const Chart chart(body->mass, any_pose(random, r));
      const double turn = i % 4 ? 0.94 : 0.999;
      const Vec6 from = random_y(random, *body, turn, r);
      const double length = std::pow(10, test::uniform(random, -3, 0));
      const Vec6 to = from + length * (random_y(random, *body, turn, r) - from);
      const Motion motion(chart, from, to);
      const Vec3 arm = test::random_in_ball(random, r);
      const Vec3 expected = motion.bend() * arm;
      const double most = motion.acceleration_per_radius() * arm.norm();
      const double error = motion.bend_error() * arm.norm();
      EXPECT_LE(expected.norm(), most * (1 + 1e-9)) << name;
      of_use += error < most;
      wide += chart.v(from).norm() > 0.9 || chart.v(to).norm() > 0.9;
      for (const double s : {0.0, 0.1, 0.37, 0.5, 0.83, 1.0}) {
        const auto turned = [&](double at) { return Vec3(motion.at(at).R * arm); };
        // Where |v| is nearly 1 the path bends sharply: the step is small beside what is left.
        const Vec3 v = chart.v(from + s * (to - from));
        const double room = 1 - v.squaredNorm();
        const double h = 1e-3 * std::min(1.0, room / (chart.v(to - from).norm() + 1e-300));
        const Vec3 measured = (turned(s + h) - 2 * turned(s) + turned(s - h)) / (h * h);
        const double trust = 1e-5 * most + 1e-14 * arm.norm() / (h * h);
        EXPECT_LE((measured - expected).norm(), error + trust) << name << " " << s;
      }
    }
  EXPECT_GT(of_use, 1000);
  EXPECT_GT(wide, 300);
}

// Closed form: half-way along a turn about one axis, and where nothing turns.
TEST(Motion, bend_of_a_turn_about_one_axis) {
  const auto box = test::body(test::box({0.05, 0.1, 0.15}));
  const Chart chart(box->mass, {});
  Vec6 way = Vec6::Zero();
  way[4] = 0.3;
  EXPECT_EQ(Motion(chart, Vec6::Zero(), way).bend(), Mat3::Zero());
  EXPECT_EQ(Motion(chart, Vec6::Zero(), way).bend_error(), 0);
  // v from −u to u: half-way v = 0, the angle is 2 asin v, and its rate 2 u per half of the path.
  for (const double u : {0.01, 0.1, 0.6}) {
    way = Vec6::Zero();
    way[1] = u * 2 * std::sqrt(box->mass.inertia[1]);
    const Motion motion(chart, -way, way);
    const Vec3 axis = box->mass.R_MP.col(1), arm(0.02, -0.03, 0.04);
    const double rate = 4 * u;
    const Vec3 inwards = rate * rate * axis.cross(axis.cross(arm));
    EXPECT_LT((motion.bend() * arm - inwards).norm(), 1e-14);
  }
}

// Reference: Eigen's slerp for the turn, a straight line for the centre of mass, and differences
// along the path for velocity, acceleration and bend.
TEST(SteadyMotion, is_a_slerp_with_bounds_that_hold) {
  std::mt19937_64 random(17);
  double tightest = 1e300;
  for (const auto& [name, body] : bodies())
    for (int i = 0; i < 60; ++i) {
      const MassProperties& mass = body->mass;
      const double r = mass.radius, size = size_of(*body);
      const Pose from = any_pose(random, r), to = any_pose(random, r);
      const Motion motion(mass, from, to);
      const Vec3 x = mass.com + r * test::random_in_ball(random, 1).normalized();
      const auto place = [&](double s) { return Vec3(motion.at(s) * x); };
      double turned = 0, fastest = 0;
      constexpr int n = 50;
      for (int k = 0; k < n; ++k) {
        const double s = (k + 0.5) / n, h = 1e-4;
        const Quat q = from.q.slerp(s, to.q);
        const Vec3 com = (1 - s) * (from * mass.com) + s * (to * mass.com);
        EXPECT_LT((place(s) - (com + q * Vec3(x - mass.com))).norm(), 1e-11 * size) << name;
        EXPECT_LT((motion.pose_at(s) * x - place(s)).norm(), 1e-13 * size);
        const auto v = motion.velocity(s);
        const Vec3 velocity = v.linear + v.angular.cross(place(s) - com);
        const double speed = motion.farthest(r);
        EXPECT_LT((velocity - (place(s + h) - place(s - h)) / (2 * h)).norm(), 1e-5 * speed);
        const Vec3 acceleration = (place(s + h) - 2 * place(s) + place(s - h)) / (h * h);
        const double noise = 1e-5 * motion.acceleration_per_radius() * r + 1e-6 * size;
        EXPECT_LE(acceleration.norm(), motion.acceleration_per_radius() * r + noise) << name;
        EXPECT_LE((acceleration - motion.bend() * (x - mass.com)).norm(),
                  motion.bend_error() * r + noise)
            << name;
        fastest = std::max(fastest, acceleration.norm() / (motion.acceleration_per_radius() * r));
        turned += v.angular.norm() / n;
      }
      EXPECT_NEAR(turned, motion.turn_bound(), 1e-9) << "all of it, and no more";
      tightest = std::min(tightest, 1 / fastest);
    }
  EXPECT_LT(tightest, 1.05) << "or the bound is of no use";
}

}  // namespace
}  // namespace sonde
