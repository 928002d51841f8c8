// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/descent/sketch_descent.hpp"

#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace
}  // namespace sonde
