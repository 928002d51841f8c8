// SPDX-License-Identifier: GPL-3.0-or-later
// References: derivatives by hand, of boxes on boxes; differences of a solver far finer than a
// search (tests/reference has those on the poses of the reference depths).
#include "engine/penetration/sensitivity/wrench_derivative.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "engine/penetration/descent/result.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/differenced_wrench.hpp"
#include "tests/support/pairs.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using Sides = WrenchDerivative::Sides;
using test::Mat6;

/// What a descent from a free pose ends with.
Separation separation(const Pair& pair, const Pose& O, const Pose& from) {
  const Chart chart(pair.probe().mass, O);
  Descent descent(pair.probe(), pair.fixed(), Method::pdg);
  return make_separation(chart, descent.run(chart, chart.coordinates(from), {}, 0, Deadline{}));
}

PolygonSoup turned(PolygonSoup soup, const Quat& q) {
  for (Vec3& x : soup.points) x = q * x;
  return soup;
}

double difference(const Pair& pair, const WrenchDerivative::Matrix& got, const Mat6& wanted) {
  return test::relative_difference(pair.probe().mass, got, wanted);
}

const Vec3 brick(0.06, 0.04, 0.02);  // m
/// Its Î, about its axes.
const Vec3 brick_inertia = Vec3(brick.y() * brick.y() + brick.z() * brick.z(),
                                brick.x() * brick.x() + brick.z() * brick.z(),
                                brick.x() * brick.x() + brick.y() * brick.y()) /
                           12;

TEST(WrenchDerivative, of_a_box_pressed_flat_is_that_of_its_three_degrees) {
  const Pair pair(test::body(test::box(brick)), test::body(test::box({1, 1, 0.2})));
  const double depth = 1e-3;
  const Pose O{Quat::Identity(), {0.013, 0.021, 0.11 - depth}};
  const Separation s = separation(pair, O, {Quat::Identity(), {0.013, 0.021, 0.11 + 1e-6}});
  for (const Neighbours neighbours : {Neighbours::of_contacts, Neighbours::all}) {
    const WrenchDerivative got = wrench_derivative(pair, s, neighbours);
    ASSERT_EQ(got.sides, Sides::all) << got.reason;
    EXPECT_STREQ(got.reason, "");
    EXPECT_EQ(got.rows, 3);
    // It resists pressing with 1 and turns out of the plane with Î; nothing else.
    Mat6 wanted = Mat6::Zero();
    wanted.diagonal() << 0, 0, -1, -brick_inertia.x(), -brick_inertia.y(), 0;
    EXPECT_LT(difference(pair, got.d_wrench, wanted), 1e-9);
    EXPECT_EQ(got.d_wrench_held, got.d_wrench);
    Vec6 down = Vec6::Zero();
    down[2] = -1;
    EXPECT_LT((Vec6(got.d_depth) - down).norm(), 1e-9);
  }
}

TEST(WrenchDerivative, of_one_corner_barely_in_a_wall_is_that_of_one_row) {
  std::mt19937_64 random(3);
  const Pair pair(test::body(test::box(brick)), test::body(test::box({1, 1, 0.2})));
  for (int i = 0; i < 10; ++i) {
    const Quat q = test::random_rotation(random);
    double lowest = 0;
    Vec3 corner = Vec3::Zero();
    for (const Vec3& x : pair.probe().soup.vertices)
      if ((q * x).z() < lowest) lowest = (q * x).z(), corner = q * x;
    const double depth = 1e-7;
    const Pose O{q, {0.013, 0.021, 0.1 - lowest - depth}};
    const Separation s = separation(pair, O, {q, {0.013, 0.021, 0.1 - lowest + 1e-9}});
    const WrenchDerivative got = wrench_derivative(pair, s);
    ASSERT_EQ(got.sides, Sides::all) << got.reason;
    // One contact in the linear regime: −J Jᵀ / (1 + (r × n)ᵀ Î⁻¹ (r × n)).
    Vec6 J;
    J << Vec3::UnitZ(), corner.cross(Vec3::UnitZ());
    const Vec3 turns = q.conjugate() * Vec3(J.tail<3>());
    const double given = 1 + turns.dot(turns.cwiseQuotient(brick_inertia));
    EXPECT_LT(difference(pair, got.d_wrench, -J * J.transpose() / given), 1e-4);
    EXPECT_LT((Vec6(got.d_depth) + J / std::sqrt(given)).norm(), 1e-4);
  }
}

TEST(WrenchDerivative, of_two_crossed_edges_is_that_by_hand) {
  const double side = 0.03, down = side / std::sqrt(2.0), depth = 4e-4;
  const auto about = [](const Vec3& axis) { return Quat(Eigen::AngleAxisd(M_PI / 4, axis)); };
  const Pair pair(test::body(turned(test::box({0.1, side, side}), about(Vec3::UnitX()))),
                  test::body(turned(test::box({side, 0.2, side}), about(Vec3::UnitY()))));
  const Pose O{Quat::Identity(), {0, 0, 2 * down - depth}};
  const Separation s = separation(pair, O, {Quat::Identity(), {0, 0, 2 * down + 1e-6}});
  const WrenchDerivative got = wrench_derivative(pair, s);
  ASSERT_EQ(got.sides, Sides::all) << got.reason;
  EXPECT_EQ(got.rows, 1);
  // The normal is along x × (edge of the probe) and stays on the fixed edge: the probe rolls. With
  // λ = d and r = −ρ z, what is free is ruled by ½|q|² − d G, G = ∂(n, r × n)/∂(ξ, ψ).
  const double I1 = side * side / 6, I2 = (0.01 + side * side) / 12, d = depth, rho = down;
  const double det = I2 + d * rho - d * d;
  Mat6 wanted = Mat6::Zero();
  wanted(2, 2) = -1;
  wanted(0, 0) = (I2 + d * rho) / det - 1;
  wanted(0, 4) = wanted(4, 0) = d * I2 / det;
  wanted(4, 4) = I2 * I2 / det - I2;
  wanted(3, 3) = I1 * I1 / (I1 - d * rho) - I1;
  EXPECT_LT(difference(pair, got.d_wrench, wanted), 1e-9);
}

/// A box on a wide one, tilted so that its centre of pressure is at one of its lower edges: it is
/// about to roll over that edge, or to lie flat.
TEST(WrenchDerivative, has_two_sides_where_a_box_is_about_to_roll) {
  const Pair pair(test::body(test::box(brick)), test::body(test::box({1, 1, 0.2})));
  const double tilt = 0.05, depth = brick_inertia.y() * std::sin(tilt) / (brick.x() / 2);
  const Pose O{Quat(Eigen::AngleAxisd(tilt, Vec3::UnitY())), {0, 0, 0.11 - depth}};
  const Separation s = separation(pair, O, {Quat::Identity(), {0, 0, 0.11 + 1e-6}});
  const WrenchDerivative got = wrench_derivative(pair, s);
  ASSERT_EQ(got.sides, Sides::two) << got.reason;
  EXPECT_GT(std::strlen(got.reason), 0U);
  EXPECT_EQ(got.rows, 2);
  EXPECT_GT(difference(pair, got.d_wrench_held, got.d_wrench), 0.05);
  test::FineSolver solver(pair.probe(), pair.fixed());
  const auto here = solver.solve(O, s.separated);
  ASSERT_TRUE(here);
  const Vec6 leaves = got.leaves;
  const double size = 1e-3 * depth;
  for (const double sign : {1.0, -1.0}) {
    // A tilt, and pressing it further in or less.
    for (const Eigen::Index i : {2, 4}) {
      const Vec6 motion = sign * size / (i < 3 ? 1 : 0.02) * Vec6::Unit(i);
      ASSERT_NE(leaves.dot(motion), 0);
      const auto beside =
          solver.solve(test::moved_by(pair.probe().mass, O, motion), here->separated);
      ASSERT_TRUE(beside);
      const Mat6 side = leaves.dot(motion) > 0 ? got.d_wrench : got.d_wrench_held;
      const Vec6 change = beside->wrench - here->wrench;
      EXPECT_LT((side * motion - change).norm(), 5e-3 * change.norm()) << sign << ' ' << i;
    }
  }
}

TEST(WrenchDerivative, agrees_with_differences_at_large_turns) {
  // Knots, found by the search, with turns up to where the chart bends.
  const auto knot = test::body(test::torus_knot(2, 3, 0.1, 0.04, 0.02, 60, 8));
  const Pair pair(knot, test::body(test::torus(0.1, 0.035, 24, 12)));
  std::mt19937_64 random(11);
  int compared = 0, within = 0;
  for (int i = 0; i < 12; ++i) {
    const Pose O{test::random_rotation(random), test::random_in_ball(random, 0.08)};
    StaticOptions options;
    options.budget.steps = 4000;
    options.want_lower_bound = false;
    const Separation s = separate_static(pair, O, options);
    if (s.status != Status::penetrating || !s.converged) continue;
    const WrenchDerivative got = wrench_derivative(pair, s, Neighbours::all);
    const auto wanted =
        test::differenced_wrench(pair.probe(), pair.fixed(), s.device, s.separated, 1e-3);
    if (!wanted || got.sides == Sides::none) continue;
    ++compared;
    const double off = difference(pair, got.d_wrench, wanted->central);
    within += off < 1e-3;
    EXPECT_TRUE(off < 1e-2 || got.sides == Sides::two) << i << ' ' << off;
    EXPECT_LT((Vec6(got.d_depth) - wanted->depth).norm(), 1e-3) << i;
  }
  EXPECT_GE(compared, 8);
  EXPECT_GE(within, compared - 1);
}

TEST(WrenchDerivative, is_zero_where_the_probe_is_free_and_says_why_there_is_none) {
  const Pair pair(test::body(test::box(brick)), test::body(test::box({1, 1, 0.2})));
  const Pose O{Quat::Identity(), {0, 0, 0.2}};
  const WrenchDerivative free = wrench_derivative(pair, separated_at(O));
  EXPECT_EQ(free.sides, Sides::all);
  EXPECT_EQ(Mat6(free.d_wrench), Mat6::Zero());
  EXPECT_EQ(Vec6(free.d_depth), Vec6::Zero());
  const WrenchDerivative none = wrench_derivative(pair, failed(O, "not started"));
  EXPECT_EQ(none.sides, Sides::none);
  EXPECT_STREQ(none.reason, "there is no separation");
  const Pose deep{Quat::Identity(), {0, 0, 0.109}};
  Separation s = separation(pair, deep, {Quat::Identity(), {0, 0, 0.11 + 1e-6}});
  s.converged = false;
  EXPECT_STREQ(wrench_derivative(pair, s).reason, "the search has not converged");
  s.converged = true;
  Separation touching = s;
  touching.depth = 1e-12;
  EXPECT_STREQ(wrench_derivative(pair, touching).reason, "the probe only touches");
  s.contacts.size = 0;
  EXPECT_STREQ(wrench_derivative(pair, s).reason, "the contacts found do not hold the probe");
}

TEST(WrenchDerivative, allocates_nothing) {
  const Pair pair(test::body(test::box(brick)), test::body(test::box({1, 1, 0.2})));
  const Pose O{Quat::Identity(), {0.013, 0.021, 0.109}};
  const Separation s = separation(pair, O, {Quat::Identity(), {0.013, 0.021, 0.11 + 1e-6}});
  test::AllocationCounter counter;
  const WrenchDerivative few = wrench_derivative(pair, s, Neighbours::of_contacts);
  const WrenchDerivative all = wrench_derivative(pair, s, Neighbours::all);
  counter.stop();
  EXPECT_EQ(counter.allocations(), 0U);
  EXPECT_EQ(few.sides, Sides::all);
  EXPECT_EQ(all.sides, Sides::all);
}

}  // namespace
}  // namespace sonde
