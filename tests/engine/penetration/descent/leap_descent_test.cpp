// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/descent/leap_descent.hpp"

#include <gtest/gtest.h>

#include "engine/geometry/random.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "tests/engine/penetration/overlapping_pose.hpp"
#include "tests/engine/penetration/separation_checks.hpp"
#include "tests/support/pairs.hpp"

namespace sonde {
namespace {

std::vector<test::BodyPair> leap_pairs() {
  std::mt19937_64 random(1);
  const auto soup = test::body(test::random_soup(random, 200, 0.1));
  const auto ring = test::body(test::torus(0.08, 0.03, 20, 10));
  const auto knot = test::body(test::torus_knot(2, 3, 0.06, 0.025, 0.015, 40, 8));
  const auto fine = test::body(test::torus_knot(2, 3, 0.06, 0.025, 0.015, 200, 16));
  return {{"ring, knot", ring, knot},
          {"knot, knot", knot, knot},
          {"soup, ring", soup, ring},
          {"fine, fine", fine, fine}};
}

std::optional<Vec6> free_pose(const LeapDescent& leaps, const Chart& chart, Random& random) {
  for (int i = 0; i < 200; ++i) {
    const Vec6 y = random.in_ball(1.5 * chart.mass().radius);
    if (chart.v(y).norm() < 0.9 && leaps.is_free(chart, y)) return y;
  }
  return std::nullopt;
}

bool is_exactly_free(const test::BodyPair& pair, const Pose& X) {
  return !overlap(*pair.a, *pair.b, Transform(X), Doubt::exact);
}

// References: exact predicates, and distances of all pairs of triangles.
TEST(LeapDescent, ends_free_and_nearer_whoever_guides_it) {
  std::mt19937_64 random(2);
  Random samples(3);
  int converged = 0, all = 0;
  for (const auto& pair : leap_pairs())
    for (int i = 0; i < 6; ++i) {
      const Chart chart(pair.a->mass, test::overlapping_pose(random, pair, 0.6));
      LeapDescent leaps(*pair.a, *pair.b, Method::pdg);
      const auto start = free_pose(leaps, chart, samples);
      if (!start) continue;
      Vec6 y = *start;
      for (const auto& [guide, tolerance] :
           {std::pair(Guide::outlines, 0.02), {Guide::few, 1e-3}, {Guide::many, 1e-4}}) {
        const auto o =
            leaps.run(chart, y, {.guide = guide, .tolerance = tolerance, .steps = 40}, {});
        EXPECT_LE(o.y.norm(), y.norm()) << pair.name;
        EXPECT_TRUE(is_exactly_free(pair, chart.pose(o.y))) << pair.name;
        y = o.y;
        if (guide != Guide::many) continue;
        ++all, converged += o.converged;
        if (!o.converged || pair.name == "fine, fine") continue;  // too many pairs to go through
        EXPECT_LE(o.residual, 1e-4);
        EXPECT_GT(o.contacts.size, 0);
        const double radius = pair.a->mass.radius;
        EXPECT_LE(test::least_distance_of_pairs(*pair.a, *pair.b, Transform(chart.pose(y))),
                  test::promised_clearance(radius, y.norm()))
            << pair.name;
      }
    }
  EXPECT_GE(all, 12);
  EXPECT_GE(converged, all * 2 / 3);
}

// Reference: a sphere is as deep in a plate as its lowest point, whichever way it is turned.
TEST(LeapDescent, ends_at_the_depth_of_a_sphere_in_a_plate) {
  const auto ball = test::body(test::sphere(0.05, 40, 80));
  const auto plate = test::body(test::box({1, 1, 0.2}));
  const double depth = 0.02;
  const Chart chart(ball->mass, Pose{Quat::Identity(), {0.01, 0.02, 0.1 + 0.05 - depth}});
  LeapDescent leaps(*ball, *plate, Method::pdg);
  Vec6 y = Vec6::Zero();
  y.tail<3>() = Vec3(0.03, -0.02, 0.06);
  ASSERT_TRUE(leaps.is_free(chart, y));
  y = leaps.run(chart, y, {.guide = Guide::few, .tolerance = 1e-3, .steps = 60}, {}).y;
  const auto o = leaps.run(chart, y, {.guide = Guide::many, .tolerance = 1e-4, .steps = 60}, {});
  // A mesh of the sphere is up to 0.2 % of its radius thinner, and can be turned to be so.
  EXPECT_LE(o.y.norm(), depth * (1 + 1e-3));
  EXPECT_GE(o.y.norm(), depth - 0.002 * 0.05);
}

TEST(LeapDescent, a_wrong_outline_misleads_but_never_errs) {
  const auto ring = test::body(test::torus(0.08, 0.03, 60, 30));
  auto liar = std::make_shared<Body>(*ring);
  auto outline = std::make_shared<Body>(*test::body(test::box({0.01, 0.3, 0.02})));
  outline->mass = ring->mass;
  liar->outline = outline;
  const test::BodyPair pair{"liar, ring", liar, ring};
  std::mt19937_64 random(4);
  Random samples(5);
  int checked = 0;
  for (int i = 0; i < 6; ++i) {
    const Chart chart(liar->mass, test::overlapping_pose(random, pair, 0.6));
    LeapDescent leaps(*liar, *ring, Method::pdg);
    const auto start = free_pose(leaps, chart, samples);
    if (!start) continue;
    const auto o = leaps.run(chart, *start, {.steps = 40}, {});
    EXPECT_TRUE(is_exactly_free(pair, chart.pose(o.y)));
    EXPECT_LE(o.y.norm(), start->norm());
    ++checked;
  }
  EXPECT_GE(checked, 3);
}

TEST(LeapDescent, gives_the_same_bits_whatever_was_run_before) {
  const auto pair = leap_pairs()[1];
  std::mt19937_64 random(6);
  Random samples(7);
  const Chart chart(pair.a->mass, test::overlapping_pose(random, pair, 0.6));
  LeapDescent fresh(*pair.a, *pair.b, Method::pdg), used(*pair.a, *pair.b, Method::pdg);
  const auto start = free_pose(fresh, chart, samples), other = free_pose(fresh, chart, samples);
  ASSERT_TRUE(start && other);
  for (const Guide guide : {Guide::outlines, Guide::few, Guide::many}) {
    used.run(chart, *other, {.guide = guide}, {});
    EXPECT_EQ(fresh.run(chart, *start, {.guide = guide}, {}).y,
              used.run(chart, *start, {.guide = guide}, {}).y);
  }
}

}  // namespace
}  // namespace sonde
