// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/descent/refinement.hpp"

#include <gtest/gtest.h>

#include "engine/proximity/queries/distance.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

/// A sphere in a plate, which rests on it wherever it ends, and a free pose on the way there.
class RefinementTest : public testing::Test {
 protected:
  static constexpr double depth = 0.02, radius = 0.05;
  static constexpr int ample = 1000;
  RefinementTest() { start.tail<3>() = Vec3(0.002, -0.003, 0.022); }

  double clearance(const Vec6& y) const {
    return distance(*ball, *plate, Transform(chart.pose(y))).distance;
  }

  const std::shared_ptr<const Body> ball = test::body(test::sphere(radius, 40, 80)),
                                    plate = test::body(test::box({1, 1, 0.2}));
  const Chart chart{ball->mass, Pose{Quat::Identity(), {0.01, 0.02, 0.1 + radius - depth}}};
  LeapDescent leaps{*ball, *plate, Method::pdg};
  Refinement refinement{*ball, *plate, Method::pdg};
  Vec6 start = Vec6::Zero();
};

// Reference: a sphere is as deep in a plate as its lowest point; a mesh of it is up to 0.2 % of the
// radius thinner.
TEST_F(RefinementTest, ends_in_contact_at_the_depth) {
  const Descent::Outcome out = refinement.run(chart, start, leaps, ample, {});
  EXPECT_TRUE(out.converged);
  EXPECT_LE(out.residual, 1e-3);
  EXPECT_GT(out.contacts.size, 0);
  EXPECT_LE(out.y.norm(), depth * (1 + 1e-3));
  EXPECT_GE(out.y.norm(), depth - 0.002 * radius);
  EXPECT_LE(clearance(out.y), allowed_clearance(ball->mass.radius, out.y.norm()));
}

TEST_F(RefinementTest, without_steps_it_only_comes_into_contact) {
  const Descent::Outcome out = refinement.run(chart, start, leaps, 0, {});
  EXPECT_FALSE(out.converged);
  EXPECT_LE(out.y.norm(), start.norm());
  EXPECT_FALSE(overlap(*ball, *plate, Transform(chart.pose(out.y)), Doubt::exact));
  EXPECT_LE(clearance(out.y), allowed_clearance(ball->mass.radius, out.y.norm()));
}

TEST_F(RefinementTest, out_of_time_it_leaves_the_pose_free_and_names_a_contact) {
  const Deadline over{.microseconds = 1e-3, .started = now_us() - 1};
  const Descent::Outcome out = refinement.run(chart, start, leaps, ample, over);
  EXPECT_FALSE(out.converged);
  EXPECT_LE(out.y.norm(), start.norm());
  EXPECT_FALSE(overlap(*ball, *plate, Transform(chart.pose(out.y)), Doubt::exact));
  EXPECT_GT(out.contacts.size, 0);
  EXPECT_LE(clearance(out.y), allowed_clearance(ball->mass.radius, out.y.norm()));
}

// Reference: the definition, |y − Jᵀλ| / |y| with the contacts that come with it. Wherever the time
// ends, what is said of the pose is true of it.
TEST_F(RefinementTest, the_residual_is_that_of_its_contacts_whenever_the_time_is_over) {
  for (double time = 1; time < 1e5; time *= 1.1) {
    const Descent::Outcome out =
        refinement.run(chart, start, leaps, ample, {.microseconds = time, .started = now_us()});
    Vec6 held = Vec6::Zero();
    for (const Contact& c : out.contacts)
      held += c.multiplier * chart.row(out.y, c.on_probe, c.normal);
    EXPECT_NEAR(out.residual, (out.y - held).norm() / out.y.norm(), 0.02) << time;
    EXPECT_FALSE(overlap(*ball, *plate, Transform(chart.pose(out.y)), Doubt::exact)) << time;
    EXPECT_GT(out.contacts.size, 0) << time;
  }
}

}  // namespace
}  // namespace sonde
