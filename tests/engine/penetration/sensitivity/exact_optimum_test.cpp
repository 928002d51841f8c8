// SPDX-License-Identifier: GPL-3.0-or-later
// half_sigma is tested beside the rows of features (feature_row_test.cpp).
#include "engine/penetration/sensitivity/exact_optimum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/allocation_counter.hpp"
#include "tests/support/differenced_wrench.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

const Vec3 flat_brick(0.06, 0.04, 0.02);  // m
/// The lower corners of a brick over the plane z = 0.
std::vector<FeatureRow> lower_corners() {
  std::vector<FeatureRow> out;
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5})
      out.push_back({FeatureRow::Kind::vertex_on_face, flat_brick.cwiseProduct(Vec3(x, y, -0.5)),
                     Vec3::Zero(), Vec3::Zero(), Vec3::UnitZ(), 1});
  return out;
}
const MassProperties& brick_mass() {
  static const std::shared_ptr<const Body> brick = test::body(test::box(flat_brick));
  return brick->mass;
}
Pose tilted_at(const Vec3& p, double tilt) {
  return {Quat(Eigen::AngleAxisd(tilt, Vec3(1, 2, 0.5).normalized())), p};
}

double least_gap(std::span<const FeatureRow> rows, const MassProperties& mass, const Pose& X) {
  double least = 1e300;
  for (const FeatureRow& row : rows)
    least = std::min(least, row_at(row, Transform(X), mass.com).gap);
  return least;
}

// Reference: by hand. A brick pressed flat into a plane comes up by its depth.
TEST(ExactOptimum, of_a_brick_pressed_flat_is_straight_up) {
  const std::vector<FeatureRow> rows = lower_corners();
  const double depth = 1e-3;
  const Pose O{Quat::Identity(), {0.013, 0.021, 0.01 - depth}};
  ExactOptimum optimum(brick_mass(), O);
  optimum.begin(tilted_at({0.013, 0.021, 0.01 + 1e-6}, 1e-5), rows);
  ASSERT_TRUE(optimum.move_to_optimum(1e-3));
  EXPECT_NEAR(optimum.depth(), depth, 1e-12);
  EXPECT_LT((optimum.pose().p - Vec3(0.013, 0.021, 0.01)).norm(), 1e-12);
  EXPECT_LT(optimum.pose().q.vec().norm(), 1e-11);
  EXPECT_LT((optimum.wrench().head<3>() - depth * Vec3::UnitZ()).norm(), 1e-12);
  EXPECT_LT(optimum.wrench().tail<3>().norm(), 1e-13);
  double pushed = 0;
  for (const Contact& c : optimum.contacts()) {
    EXPECT_EQ(c.gap, 0);
    EXPECT_EQ(c.on_probe, c.on_fixed);
    EXPECT_NEAR(c.on_probe.z(), 0, 1e-12);
    pushed += c.multiplier;
  }
  EXPECT_NEAR(pushed, depth, 1e-12);
}

/// A corner of a body of any mass in a room of three walls, one of them a face of the body.
struct HeldBody {
  MassProperties mass;
  Pose O;
  std::vector<FeatureRow> rows;
};
HeldBody held_body(std::mt19937_64& random, std::size_t count) {
  HeldBody out;
  out.mass.com = test::random_in_ball(random, 0.3);
  out.mass.inertia = Vec3(0.1, 0.3, 0.35);
  out.mass.R_MP = test::random_rotation(random).toRotationMatrix();
  out.mass.radius = 1;
  out.O = {test::random_rotation(random), test::random_in_ball(random, 1)};
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 x = test::random_in_ball(random, 1),
               n = test::random_rotation(random) * Vec3::UnitZ();
    const Vec3 u = test::random_rotation(random) * Vec3::UnitZ();
    FeatureRow row{static_cast<FeatureRow::Kind>(i % 3), x, u, out.O * x, n, 1};
    if (row.kind == FeatureRow::Kind::edge_on_edge) row.along_b = (out.O.q * u).unitOrthogonal();
    row.b -= row_at(row, Transform(out.O), out.mass.com).gap * Vec3::UnitX();
    out.rows.push_back(row);
  }
  // Each 1e-3 m in the other body.
  for (FeatureRow& row : out.rows) {
    const FeatureRowAt at = row_at(row, Transform(out.O), out.mass.com);
    row.b += (at.gap + 1e-3) * at.normal;
  }
  return out;
}

// Reference: what an optimum is. The rows have no gap or are clear, contacts add up to the wrench,
// and no pose near by that satisfies the rows has a smaller σ (by half_sigma).
TEST(ExactOptimum, holds_the_wrench_by_its_rows_and_nothing_near_is_nearer) {
  std::mt19937_64 random(1);
  int found = 0, compared = 0;
  for (int i = 0; i < 60; ++i) {
    const HeldBody held = held_body(random, 1 + static_cast<std::size_t>(i) % 4);
    ExactOptimum optimum(held.mass, held.O);
    optimum.begin(held.O, held.rows);
    if (!optimum.move_to_optimum(0.05)) continue;
    ++found;
    const Pose Q = optimum.pose();
    const double depth = optimum.depth();
    EXPECT_GT(least_gap(held.rows, held.mass, Q), -1e-6 * depth) << i;
    const HalfSigma at = half_sigma(held.mass, held.O, Q);
    EXPECT_NEAR(at.sigma, depth * depth, 1e-15);
    EXPECT_LT((at.wrench - optimum.wrench()).norm(), 1e-12);
    Vec6 sum = Vec6::Zero();
    for (const Contact& c : optimum.contacts()) {
      EXPECT_GT(c.multiplier, -1e-6 * depth);
      sum.head<3>() += c.multiplier * c.normal;
      sum.tail<3>() += c.multiplier * (c.on_probe - Q * held.mass.com).cross(c.normal);
    }
    // A Newton step of less than 1e-3 of the depth is the last: its error is of second order.
    EXPECT_LT((sum - at.wrench).norm(), 1e-5 * depth) << i;
    for (int k = 0; k < 200; ++k) {
      Vec6 motion;
      motion << test::random_in_ball(random, 1), test::random_in_ball(random, 1);
      const Pose near = test::moved_by(held.mass, Q, 0.3 * depth * motion);
      if (least_gap(held.rows, held.mass, near) < 0) continue;
      ++compared;
      EXPECT_GE(half_sigma(held.mass, held.O, near).sigma, at.sigma * (1 - 1e-6)) << i;
    }
  }
  EXPECT_GT(found, 40);
  EXPECT_GT(compared, 1000);
}

TEST(ExactOptimum, further_than_it_may_be_is_not_found) {
  const std::vector<FeatureRow> rows = lower_corners();
  const Pose O{Quat::Identity(), {0, 0, 0.01 - 1e-3}};
  for (const double off : {1e-5, 1e-4}) {
    ExactOptimum optimum(brick_mass(), O);
    optimum.begin({Quat::Identity(), {0, 0, 0.01 + off}}, rows);
    EXPECT_EQ(optimum.move_to_optimum(5e-5), off < 5e-5) << off;
  }
}

/// The motion (ξ, ψ) from one pose to a near one.
Vec6 motion_between(const MassProperties& mass, const Pose& from, const Pose& to) {
  Vec6 out;
  Quat turn = to.q * from.q.conjugate();
  if (turn.w() < 0) turn.coeffs() = -turn.coeffs();
  out << to * mass.com - from * mass.com, 2 * turn.vec();
  return out;
}

// Reference: central differences of optima. Their error is h² times third derivatives of size
// 1 / (1e-3 m), that is 1e-4, and 1e-10 / h of the tolerance of an optimum.
TEST(ExactOptimum, derivatives_are_those_of_the_optimum) {
  std::mt19937_64 random(2);
  const double h = 1e-6;
  int compared = 0;
  for (int i = 0; i < 30; ++i) {
    const HeldBody held = held_body(random, 1 + static_cast<std::size_t>(i) % 3);
    ExactOptimum optimum(held.mass, held.O);
    optimum.begin(held.O, held.rows);
    if (!optimum.move_to_optimum(0.05)) continue;
    // Rows that are just about to open have two derivatives.
    if (optimum.find_weak(1e-2 * optimum.depth(), 1e-2 * optimum.depth()) > 0) continue;
    ExactOptimum::Change change;
    if (!optimum.derivative(false, change)) continue;
    EXPECT_GT(change.held, 0);
    EXPECT_LE(change.held, static_cast<int>(held.rows.size()));
    const Pose Q = optimum.pose();
    for (Eigen::Index k = 0; k < 6; ++k) {
      Vec6 wrench = Vec6::Zero(), separated = Vec6::Zero();
      bool both = true;
      for (const double sign : {1.0, -1.0}) {
        ExactOptimum beside(held.mass, test::moved_by(held.mass, held.O, sign * h * Vec6::Unit(k)));
        beside.begin(Q, held.rows);
        both = both && beside.move_to_optimum(0.05);
        wrench += sign / (2 * h) * beside.wrench();
        separated += sign / (2 * h) * motion_between(held.mass, Q, beside.pose());
      }
      if (!both) continue;
      ++compared;
      EXPECT_LT((change.wrench.col(k) - wrench).norm(), 1e-3) << i << " " << k;
      EXPECT_LT((change.separated.col(k) - separated).norm(), 1e-3) << i << " " << k;
    }
  }
  EXPECT_GT(compared, 60);
}

// Reference: by hand. A brick tilted so that its centre of pressure is at one of its lower edges
// rolls over that edge if it is tilted more: the corners of the other edge are weak. Flat, two
// opposite corners may bear it all, and the others cannot open.
TEST(ExactOptimum, corners_are_weak_where_a_brick_is_about_to_roll) {
  const std::vector<FeatureRow> rows = lower_corners();
  const double inertia = (0.06 * 0.06 + 0.02 * 0.02) / 12, tilt = 0.05;
  const double depth = inertia * std::sin(tilt) / 0.03;
  for (const bool rolls : {true, false}) {
    const Pose O{Quat(Eigen::AngleAxisd(rolls ? tilt : 0, Vec3::UnitY())), {0, 0, 0.01 - depth}};
    ExactOptimum optimum(brick_mass(), O);
    optimum.begin({Quat::Identity(), {0, 0, 0.01}}, rows);
    ASSERT_TRUE(optimum.move_to_optimum(0.01));
    EXPECT_LT(optimum.pose().q.vec().norm(), 1e-9);
    const int weak = optimum.find_weak(1e-4 * depth, 1e-6 * depth);
    EXPECT_EQ(weak > 0, rolls);
    ExactOptimum::Change hold, open;
    ASSERT_TRUE(optimum.derivative(true, hold));
    ASSERT_TRUE(optimum.derivative(false, open));
    EXPECT_EQ(hold.held, 3);
    EXPECT_EQ(open.held, rolls ? 2 : 3);
    const Vec6 rate = optimum.weak_gap_rate(open);
    if (!rolls) {
      EXPECT_EQ(rate.norm(), 0);
      EXPECT_EQ((hold.wrench - open.wrench).norm(), 0);
      continue;
    }
    // Held flat, it resists turns about y by its inertia; tilted further, it opens.
    EXPECT_NEAR(hold.wrench(4, 4), -inertia * std::cos(tilt), 1e-5 * inertia);
    EXPECT_GT(rate[4], 0);
    const double h = 1e-7;
    Vec6 further = Vec6::Zero();
    further[4] = h;
    ExactOptimum rolled(brick_mass(), test::moved_by(brick_mass(), O, further));
    rolled.begin({Quat::Identity(), {0, 0, 0.01}}, rows);
    ASSERT_TRUE(rolled.move_to_optimum(0.01));
    double most = 0;
    for (const FeatureRow& row : rows)
      most = std::max(most, row_at(row, Transform(rolled.pose()), Vec3::Zero()).gap);
    EXPECT_NEAR(most / h, rate[4], 1e-4 * rate[4]);
  }
}

TEST(ExactOptimum, does_not_allocate) {
  const std::vector<FeatureRow> rows = lower_corners();
  const Pose O{Quat::Identity(), {0, 0, 0.01 - 1e-3}};
  const MassProperties& mass = brick_mass();
  test::AllocationCounter counter;
  ExactOptimum optimum(mass, O);
  optimum.begin({Quat::Identity(), {0, 0, 0.01}}, rows);
  const bool found = optimum.move_to_optimum(1e-3);
  const int weak = optimum.find_weak(1e-7, 1e-9);
  ExactOptimum::Change change;
  const bool smooth = optimum.derivative(false, change);
  counter.stop();
  EXPECT_EQ(counter.allocations(), 0u) << found << weak << smooth;
}

}  // namespace
}  // namespace sonde
