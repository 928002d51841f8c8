// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/chart.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/geometry/chart_cases.hpp"
#include "tests/support/brute_force.hpp"

namespace sonde {
namespace {

using test::chart_cases::any_pose;
using test::chart_cases::bodies;
using test::chart_cases::pose_difference;
using test::chart_cases::random_y;
using test::chart_cases::size_of;

TEST(Chart, pose_and_coordinates_are_inverse) {
  std::mt19937_64 random(2);
  for (const auto& [name, body] : bodies())
    for (int i = 0; i < 200; ++i) {
      const double r = body->mass.radius;
      const Chart chart(body->mass, any_pose(random, r));
      const Vec6 y = random_y(random, *body, 0.99, 2 * r);
      // Half an angle near its end is known to √ε at worst: |v| stays below 0.99.
      EXPECT_LT((chart.coordinates(chart.pose(y)) - y).norm(), 1e-13 * size_of(*body)) << name;
      const Pose X = any_pose(random, r);
      const Vec6 of_X = chart.coordinates(X);
      ASSERT_LE(chart.v(of_X).norm(), 1 + 1e-14);
      if (chart.v(of_X).norm() > 0.999) continue;
      EXPECT_LT(pose_difference(*body, chart.pose(of_X), X), 1e-11 * size_of(*body)) << name;
      EXPECT_LT(chart.coordinates(chart.device()).norm(), 1e-15 * size_of(*body) * 10) << name;
    }
}

// Reference: the integral of the squared displacement over the triangles or the tetrahedra under
// them, which knows of no principal axes, quaternions or inertia.
TEST(Chart, sigma_is_the_mean_squared_displacement) {
  std::mt19937_64 random(3);
  for (const auto& [name, body] : bodies()) {
    const test::Moments m = test::moments(*body);
    for (int i = 0; i < 200; ++i) {
      const Pose O = any_pose(random, body->mass.radius), Q = any_pose(random, body->mass.radius);
      const double sigma = Chart(body->mass, O).coordinates(Q).squaredNorm();
      const double expected = test::mean_squared_displacement(m, O, Q);
      EXPECT_NEAR(sigma, expected, 1e-12 * expected) << name;
      // A metric on poses: symmetric, and the triangle inequality holds.
      const Pose P = any_pose(random, body->mass.radius);
      const auto distance = [&](const Pose& x, const Pose& z) {
        return Chart(body->mass, x).coordinates(z).norm();
      };
      EXPECT_NEAR(distance(Q, O), std::sqrt(sigma), 1e-12 * std::sqrt(sigma)) << name;
      EXPECT_LE(distance(O, Q), (distance(O, P) + distance(P, Q)) * (1 + 1e-12)) << name;
    }
  }
}

// Reference: the mean over points strewn evenly over the triangles, for a surface; good to 1/√n.
TEST(Chart, sigma_of_strewn_points) {
  std::mt19937_64 random(4);
  const auto sheet = test::body({{{0, 0, 0.1}, {0.3, 0, 0}, {0, 0.1, 0}}, {{0, 1, 2}}});
  const Pose O = any_pose(random, 0.2), Q = any_pose(random, 0.2);
  double sum = 0;
  constexpr int n = 200000;
  const auto& v = sheet->soup.vertices;
  for (int i = 0; i < n; ++i) {
    double a = test::uniform(random, 0, 1), b = test::uniform(random, 0, 1);
    if (a + b > 1) a = 1 - a, b = 1 - b;
    const Vec3 x = v[0] + a * (v[1] - v[0]) + b * (v[2] - v[0]);
    sum += (Q * x - O * x).squaredNorm();
  }
  const double sigma = Chart(sheet->mass, O).coordinates(Q).squaredNorm();
  EXPECT_NEAR(sigma, sum / n, 0.01 * sigma);
}

// Reference: central differences of n·a along each coordinate; a is fixed to the body. Trusted to
// 1e-6 of the row, at a step of 1e-5 of the size.
TEST(Chart, a_row_is_the_derivative_of_the_contact_along_its_normal) {
  std::mt19937_64 random(5);
  for (const auto& [name, body] : bodies())
    for (int i = 0; i < 100; ++i) {
      const double r = body->mass.radius;
      const Chart chart(body->mass, any_pose(random, r));
      const Vec6 y = random_y(random, *body, 0.9, r);
      const Vec3 n = test::random_in_ball(random, 1).normalized();
      const Pose X = chart.pose(y);
      const Vec3 a = X * (body->mass.com + test::random_in_ball(random, r));
      const Vec3 in_body = inverse(X) * a;
      const Vec6 row = chart.row(y, a, n);
      for (int k = 0; k < 6; ++k) {
        if (k < 3 && !(body->mass.inertia[k] > 0)) {
          EXPECT_EQ(row[k], 0) << name;
          continue;
        }
        const double h = 1e-5 * r;
        Vec6 more = y, less = y;
        more[k] += h, less[k] -= h;
        const double difference =
            n.dot(chart.pose(more) * in_body - chart.pose(less) * in_body) / (2 * h);
        EXPECT_NEAR(row[k], difference, 1e-6 * (1 + row.norm())) << name << k;
      }
    }
}

// Reference: the points of a needle's axis, which are all of its mass: they are where they were,
// however it is turned about that axis, up to turns of nearly half a turn.
TEST(Chart, a_needle_s_axis_is_where_its_coordinates_say) {
  std::mt19937_64 random(9);
  MassProperties needle;
  needle.inertia = {1, 1, 0};
  needle.radius = 2;
  needle.com = {0.1, -0.2, 0.3};
  const Vec3 axis = needle.R_MP.col(2);
  for (int i = 0; i < 200; ++i) {
    const Chart chart(needle, any_pose(random, 2));
    const Pose X = any_pose(random, 2);
    const Vec6 y = chart.coordinates(X);
    EXPECT_EQ(y[2], 0);
    if (chart.v(y).norm() > 0.999) continue;
    const Pose back = chart.pose(y);
    for (const double along : {-1.0, 2.0}) {
      const Vec3 point = needle.com + along * axis;
      EXPECT_LT((back * point - X * point).norm(), 1e-12);
    }
  }
}

// A probe on a line: turning about it moves nothing, and is left out.
TEST(Chart, an_axis_without_inertia) {
  MassProperties mass;
  mass.measure = 1;
  mass.com = Vec3(0.1, 0, 0);
  mass.inertia = Vec3(0, 0.01, 0.01);
  mass.radius = 0.2;
  std::mt19937_64 random(8);
  for (int i = 0; i < 100; ++i) {
    const Chart chart(mass, any_pose(random, 0.2));
    Vec6 y;
    y << 0.2 * test::random_in_ball(random, 0.8), test::random_in_ball(random, 0.1);
    y[0] = 0.7;
    const Vec6 back = chart.coordinates(chart.pose(y));
    EXPECT_EQ(back[0], 0);
    EXPECT_LT((back.tail<5>() - y.tail<5>()).norm(), 1e-14);
    EXPECT_EQ(chart.v(y)[0], 0);
    const Vec3 n = test::random_in_ball(random, 1).normalized();
    const Vec6 row = chart.row(y, test::random_in_ball(random, 0.3), n);
    EXPECT_TRUE(row.allFinite());
    EXPECT_EQ(row[0], 0);
    // A turn about the line alone costs nothing.
    const Pose O = chart.device();
    const Quat spin(Eigen::AngleAxisd(1.0, mass.R_MP.col(0)));
    const Pose spun{O.q * spin, O * mass.com - (O.q * spin) * mass.com};
    EXPECT_LT(chart.coordinates(spun).norm(), 1e-15);
  }
}

}  // namespace
}  // namespace sonde
