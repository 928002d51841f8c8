// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/descent/sketch_descent.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/brute_force.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

struct Spheres {
  std::shared_ptr<const Body> a = test::body(test::sphere(0.1, 24, 36)),
                              b = test::body(test::sphere(0.15, 24, 36));
  Sketches sketches = make_sketches(*a, *b);
  Chart chart{a->mass, {Quat::Identity(), Vec3(0.03, -0.05, 0.02)}};
  SketchDescent descent{*sketches.probe, *sketches.fixed, b->mass};
  double depth = 0.25 - Vec3(0.03, -0.05, 0.02).norm();
};

// Reference: of two spheres, the sum of the radii less the distance of the centres. There is no
// other end, but what is made of points has edges: a descent may stop at one of them.
TEST(SketchDescent, spheres_come_apart_by_the_shortest_way) {
  Spheres s;
  std::mt19937_64 random(1);
  int arrived = 0, there = 0;
  for (int i = 0; i < 40; ++i) {
    Vec6 y = Vec6::Zero();
    y.tail<3>() = 0.4 * (test::random_rotation(random) * Vec3::UnitX());
    ASSERT_TRUE(s.descent.is_free(s.chart, y));
    const auto end = s.descent.run(s.chart, y, {.steps = 40});
    if (!end.arrived) continue;
    ++arrived;
    there += std::abs(end.y.norm() - s.depth) < 0.03 * s.depth;
    EXPECT_GT(end.y.norm(), 0.97 * s.depth);
    EXPECT_GT(end.gap, -0.25 * s.descent.spacing());
  }
  EXPECT_GE(arrived, 30);
  EXPECT_GE(4 * there, 3 * arrived);
}

TEST(SketchDescent, a_margin_keeps_them_further_apart) {
  Spheres s;
  Vec6 y = Vec6::Zero();
  y.tail<3>() = 0.4 * Vec3(0.03, -0.05, 0.02).normalized();
  const double margin = s.descent.spacing();
  const auto near = s.descent.run(s.chart, y, {.steps = 40});
  const auto apart = s.descent.run(s.chart, near.y, {.margin = margin, .steps = 40});
  EXPECT_NEAR(apart.y.norm() - near.y.norm(), margin, 0.3 * margin);
}

TEST(SketchDescent, translations_do_not_turn_and_a_deep_pose_is_not_free) {
  Spheres s;
  EXPECT_FALSE(s.descent.is_free(s.chart, Vec6::Zero()));
  Vec6 y = Vec6::Zero();
  y.tail<3>() = Vec3(0.3, 0.1, 0);
  const auto end = s.descent.run(s.chart, y, {.method = Method::pdt, .steps = 40});
  EXPECT_EQ(end.y.head<3>().norm(), 0);
  EXPECT_LT(end.y.norm(), y.norm());
}

// Reference: how far the spheres lie in each other. A field is off by a quarter of a cell, and
// points need not be where they are deepest.
TEST(SketchDescent, how_deep_free_poses_may_lie_is_the_depth_of_points) {
  Spheres s;
  const Vec3 along = Vec3(0.03, -0.05, 0.02).normalized();
  const double cell = s.descent.spacing();
  int refused = 0;
  for (double overlap = 0.01 * s.depth; overlap < s.depth; overlap += 0.05 * s.depth) {
    Vec6 y = Vec6::Zero();
    y.tail<3>() = (s.depth - overlap) * along;
    EXPECT_TRUE(s.descent.is_free(s.chart, y, overlap + 0.25 * cell)) << overlap;
    refused += !s.descent.is_free(s.chart, y, 0.3 * cell);
    if (overlap > 4 * cell) {
      EXPECT_FALSE(s.descent.is_free(s.chart, y, 0.3 * cell)) << overlap;
    }
  }
  EXPECT_GT(refused, 10);
}

// Reference: the field at every point, one by one.
TEST(SketchDescent, the_depth_of_points_is_that_of_the_deepest) {
  const auto ring = test::body(test::torus(0.08, 0.03, 20, 10)),
             box = test::body(test::box({0.1, 0.16, 0.06}));
  const Sketches sketches = make_sketches(*ring, *box);
  SketchDescent descent(*sketches.probe, *sketches.fixed, box->mass);
  const auto deepest = [](const Sketch& points, const DistanceField& field, const Pose& X) {
    double depth = 0;
    for (const PointGroup& group : points.more)
      for (const Quad& x : group.points)
        depth = std::max(depth, -static_cast<double>(field.at(quad(X * vec3(x)))[3]));
    return depth;
  };
  const auto axes_of = [](const Body& body) { return Pose{Quat(body.mass.R_MP), body.mass.com}; };
  std::mt19937_64 random(2);
  int deep = 0;
  for (int i = 0; i < 300; ++i) {
    const Pose X = test::random_pose(random, *ring, *box, 0.6);
    const Pose X_BA = inverse(axes_of(*box)) * X * axes_of(*ring);
    const double depth = std::max(deepest(*sketches.probe, sketches.fixed->field, X_BA),
                                  deepest(*sketches.fixed, sketches.probe->field, inverse(X_BA)));
    const double found = descent.depth_of_points(Chart(ring->mass, X), Vec6::Zero());
    EXPECT_LE(found, depth + 1e-4 * descent.spacing()) << i;
    EXPECT_GE(found, depth - 0.3 * descent.spacing()) << i;
    deep += depth > descent.spacing();
  }
  EXPECT_GT(deep, 100);
}

}  // namespace
}  // namespace sonde
