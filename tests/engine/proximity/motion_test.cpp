// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/brute_force.hpp"
#include "tests/support/pairs.hpp"

namespace sonde {
namespace {

/// Solids and surfaces, with the centre of mass off the origin and axes askew.
std::vector<std::pair<const char*, std::shared_ptr<const Body>>> bodies() {
  std::mt19937_64 random(1);
  PolygonSoup wedge = test::tetrahedron(0.1);
  wedge.points[0] += Vec3(0.1, 0.03, -0.02);
  const auto soup = [&] { return test::random_soup(random, 12, 0.2); };
  return {{"wedge", test::body(test::scaled_and_moved(wedge, 1, {0.3, -0.2, 0.1}))},
          {"box", test::body(test::box({0.05, 0.1, 0.15}))},
          {"ball", test::body(test::sphere(0.1, 6, 9))},
          {"soup", test::body(soup())},
          {"tiny", test::body(test::scaled_and_moved(wedge, 1e-6, Vec3::Zero()))},
          {"huge", test::body(test::scaled_and_moved(wedge, 1e6, Vec3::Zero()))},
          {"sheet", test::body({{{0, 0, 0}, {0.3, 0, 0}, {0, 0.1, 0}}, {{0, 1, 2}}})}};
}

Pose any_pose(std::mt19937_64& random, double size) {
  return {test::random_rotation(random), test::random_in_ball(random, 3 * size)};
}

/// y with |v| of at most `turn`.
Vec6 random_y(std::mt19937_64& random, const Body& body, double turn, double shift) {
  Vec6 y;
  y.head<3>() = 2 * body.mass.inertia.cwiseSqrt().cwiseProduct(test::random_in_ball(random, turn));
  y.tail<3>() = test::random_in_ball(random, shift);
  return y;
}

double pose_difference(const Body& body, const Pose& X, const Pose& Y) {
  double worst = 0;
  for (const Vec3& x : body.soup.vertices) worst = std::max(worst, (X * x - Y * x).norm());
  return worst;
}

double size_of(const Body& body) { return body.mass.radius + body.mass.com.norm(); }

TEST(Motion, chart_and_coordinates_are_inverse) {
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
TEST(Motion, sigma_is_the_mean_squared_displacement) {
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
TEST(Motion, sigma_of_strewn_points) {
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
TEST(Motion, a_row_is_the_derivative_of_the_contact_along_its_normal) {
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
TEST(Motion, BendIsTheAccelerationToWithinItsError) {
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
TEST(Motion, BendOfATurnAboutOneAxis) {
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

// A probe on a line: turning about it moves nothing, and is left out.
TEST(Motion, an_axis_without_inertia) {
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
