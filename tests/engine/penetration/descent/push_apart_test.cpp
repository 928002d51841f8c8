// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/descent/push_apart.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "engine/proximity/queries/intersect.hpp"
#include "tests/support/conforming_scene.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

constexpr double anywhere = std::numeric_limits<double>::infinity();

bool is_free(const Body& a, const Body& b, const Pose& X) {
  return !overlap(a, b, Transform(X), Doubt::exact);
}

// Reference: a ball is as deep in a plate as its lowest point.
TEST(PushApart, a_ball_comes_out_of_a_plate_by_the_side_it_is_near) {
  const auto ball = test::body(test::sphere(0.05, 20, 40));
  const auto plate = test::body(test::box({1, 1, 0.2}));
  for (const double depth : {1e-4, 0.01, 0.04}) {
    const Chart chart(ball->mass, Pose{Quat::Identity(), {0.01, 0.02, 0.15 - depth}});
    for (const Method method : {Method::pdg, Method::pdt}) {
      const auto y = PushApart(*ball, *plate, method).from(chart, Vec6::Zero(), anywhere);
      ASSERT_TRUE(y) << depth;
      EXPECT_TRUE(is_free(*ball, *plate, chart.pose(*y))) << depth;
      EXPECT_LE(y->norm(), 1.5 * depth + 1e-3 * 0.05) << depth;
      EXPECT_TRUE(method == Method::pdg || y->head<3>().isZero(0)) << depth;
    }
  }
}

// Reference: the hole is wider than the rod by 1 % of its radius; a random pose would hardly be in.
TEST(PushApart, a_rod_goes_back_into_the_middle_of_its_hole) {
  const test::ConformingScene scene = test::cylinder_in_hole();
  for (const int n : {1, 5}) {
    const auto bodies = test::cut_bodies(scene, {n, test::Cutting::Kind::random}, test::askew());
    const Pose X = Pose{test::askew().world, Vec3::Zero()} * scene.path[60] *
                   Pose{test::askew().probe.conjugate(), Vec3::Zero()};
    const Chart chart(bodies.probe->mass, X);
    ASSERT_FALSE(is_free(*bodies.probe, *bodies.fixed, X));
    const auto y =
        PushApart(*bodies.probe, *bodies.fixed, Method::pdg).from(chart, Vec6::Zero(), anywhere);
    ASSERT_TRUE(y) << n;
    EXPECT_TRUE(is_free(*bodies.probe, *bodies.fixed, chart.pose(*y))) << n;
    EXPECT_LE(y->norm(), 2e-3) << n << ": it is pressed 0.5 mm, the way out along it is 25 mm";
  }
}

TEST(PushApart, it_is_given_up_too_far_out_or_where_no_triangles_meet) {
  const auto small = test::body(test::box({0.1, 0.1, 0.1})), big = test::body(test::box({1, 1, 1}));
  PushApart push(*small, *big, Method::pdg);
  const Chart inside(small->mass, Pose{Quat::Identity(), Vec3::Zero()});
  EXPECT_FALSE(push.from(inside, Vec6::Zero(), anywhere));
  const Chart half_out(small->mass, Pose{Quat::Identity(), {0.01, 0.02, 0.5}});
  EXPECT_TRUE(push.from(half_out, Vec6::Zero(), anywhere));
  EXPECT_FALSE(push.from(half_out, Vec6::Zero(), 0.04)) << "it is 0.05 deep";
  const Deadline over{.microseconds = 1e-3, .started = now_us() - 1};
  EXPECT_FALSE(push.from(half_out, Vec6::Zero(), anywhere, over));
}

}  // namespace
}  // namespace sonde
