// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/bound/rotation_cell.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

const Vec3 inertia(0.002, 0.01, 0.011);

/// A cell as many halvings leave it.
RotationCell random_cell(std::mt19937_64& random, int halvings) {
  RotationCell cell;
  cell.face = static_cast<int>(random() % 4);
  for (int i = 0; i < halvings; ++i)
    cell = cell.halves(static_cast<int>(random() % 3))[random() % 2];
  return cell;
}

/// The unit quaternion at a place of a cell, each component of `where` within ±1.
Quat quaternion(const RotationCell& cell, const Vec3& where) {
  RotationCell there = cell;
  for (std::size_t k = 0; k < 3; ++k)
    there.at[k] += cell.half[k] * where[static_cast<Eigen::Index>(k)];
  const Eigen::Vector4d q = there.middle();
  return Quat(q[0], q[1], q[2], q[3]).normalized();
}

Vec3 in_cube(std::mt19937_64& random) {
  return {test::uniform(random, -1, 1), test::uniform(random, -1, 1), test::uniform(random, -1, 1)};
}

double cost(const Quat& q) { return 4 * q.vec().dot(inertia.cwiseProduct(q.vec())); }

bool holds(const RotationCell& cell, const Quat& q) {
  const double of[4] = {q.w(), q.x(), q.y(), q.z()};
  std::size_t k = 0;
  for (int i = 0; i < 4; ++i) {
    if (i == cell.face) continue;
    if (std::abs(of[i] / of[cell.face] - cell.at[k]) > cell.half[k] * (1 + 1e-12)) return false;
    ++k;
  }
  return true;
}

TEST(RotationCell, four_cells_hold_every_rotation_and_halves_what_their_cell_holds) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 2000; ++i) {
    const Quat q = test::random_rotation(random);
    std::vector<RotationCell> in;
    for (int face = 0; face < 4; ++face) {
      RotationCell cell;
      cell.face = face;
      if (holds(cell, q)) in.push_back(cell);
    }
    ASSERT_EQ(in.size(), 1U);
    for (int deep = 0; deep < 30; ++deep) {
      const auto halves = in[0].halves(deep % 3);
      ASSERT_TRUE(holds(halves[0], q) || holds(halves[1], q));
      in[0] = halves[holds(halves[0], q) ? 0 : 1];
    }
    EXPECT_LT(quaternion(in[0], Vec3::Zero()).angularDistance(q), 0.01);
  }
}

// Reference: rotations of the cell, at random, and where each component is as near to zero or as
// far from it as it can be: that one of these is the least, no random one contradicts.
TEST(RotationCell, no_turn_costs_less_than_said_and_one_costs_that) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 500; ++i) {
    const RotationCell cell = random_cell(random, static_cast<int>(random() % 20));
    const double least = cell.least_cost(inertia);
    double found = std::numeric_limits<double>::infinity();
    for (unsigned choice = 0; choice < 8; ++choice) {
      Vec3 where;
      for (std::size_t k = 0; k < 3; ++k)
        where[static_cast<Eigen::Index>(k)] =
            (choice >> k) & 1 ? (cell.at[k] > 0 ? 1 : -1)
                              : std::clamp(-cell.at[k] / cell.half[k], -1.0, 1.0);
      found = std::min(found, cost(quaternion(cell, where)));
    }
    EXPECT_NEAR(found, least, 1e-12 * least + 1e-15 * inertia[2]);
    for (int k = 0; k < 400; ++k)
      EXPECT_GE(cost(quaternion(cell, in_cube(random))), least * (1 - 1e-12));
  }
}

// Reference: the definition, by rotating a point.
TEST(RotationCell, no_turn_takes_a_point_further_than_said) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 500; ++i) {
    const int halvings = static_cast<int>(random() % 20);
    const RotationCell cell = random_cell(random, halvings);
    const CellSpread spread(cell);
    const Quat middle = quaternion(cell, Vec3::Zero());
    EXPECT_LT((spread.middle() - middle.toRotationMatrix()).norm(), 1e-14);
    const Vec3 r = test::random_in_ball(random, 2);
    const double reach = spread.reach(r);
    double furthest = 0;
    for (int k = 0; k < 200; ++k) {
      Vec3 where = in_cube(random);
      if (random() % 2) where = where.cwiseSign();
      furthest = std::max(furthest, (quaternion(cell, where) * r - middle * r).norm());
    }
    EXPECT_LE(furthest, reach * (1 + 1e-12));
    if (halvings >= 12) {
      EXPECT_GE(furthest, 0.4 * reach);
    }
  }
}

// Reference: the definition, by rotating a point.
TEST(RotationCell, the_form_of_the_distance_between_two_points) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 500; ++i) {
    const Vec3 r = test::random_in_ball(random, 2), p = test::random_in_ball(random, 2);
    const Quat q = test::random_rotation(random);
    const Eigen::Vector4d c =
        test::uniform(random, 0.5, 2) * Eigen::Vector4d(q.w(), q.x(), q.y(), q.z());
    EXPECT_NEAR(c.dot(distance_form(r, p) * c) / c.squaredNorm(), (q * r - p).squaredNorm(), 1e-13);
  }
}

// Reference: quaternions of the cell, at random and at its corners. What small cells give away is
// of second order in their size.
TEST(RotationCell, no_quotient_of_a_cell_is_less_than_said) {
  std::mt19937_64 random(6);
  int small = 0, tight = 0;
  for (int i = 0; i < 1000; ++i) {
    const int halvings = static_cast<int>(random() % 20);
    const RotationCell cell = random_cell(random, halvings);
    Eigen::Matrix4d S =
        -test::uniform(random, 0, 3) *
        distance_form(test::random_in_ball(random, 1), test::random_in_ball(random, 1));
    S.diagonal().tail<3>() += 4 * inertia;
    const auto guessed = cell.least_quotient(S, cell.middle());
    const auto least = cell.least_quotient(S, guessed.at);
    double found = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 300; ++k) {
      Vec3 where = in_cube(random);
      if (random() % 2) where = where.cwiseSign();
      const Quat q = quaternion(cell, where);
      const Eigen::Vector4d c(q.w(), q.x(), q.y(), q.z());
      found = std::min(found, c.dot(S * c));
    }
    EXPECT_LE(guessed.bound, found);
    EXPECT_LE(least.bound, found);
    const double size = *std::max_element(cell.half.begin(), cell.half.end());
    if (halvings < 9) continue;
    ++small;
    tight += found - least.bound < 5 * S.norm() * size * size;
  }
  EXPECT_GT(small, 400);
  EXPECT_EQ(tight, small);
}

// A component's share in the cost is the difference to the side, to first order.
TEST(RotationCell, the_change_of_the_cost_across_a_small_cell) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 100; ++i) {
    const RotationCell cell = random_cell(random, 36);
    const double here = cost(quaternion(cell, Vec3::Zero()));
    for (int k = 0; k < 3; ++k) {
      const double there = cost(quaternion(cell, Vec3::Unit(k)));
      const double size = cell.half[static_cast<std::size_t>(k)];
      EXPECT_NEAR(cell.cost_along(k, inertia), std::abs(there - here), size * size);
    }
  }
}

}  // namespace
}  // namespace sonde
