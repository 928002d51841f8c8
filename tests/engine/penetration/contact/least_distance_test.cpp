// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/contact/least_distance.hpp"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include "tests/support/allocation_counter.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using Rows = std::vector<HalfSpace>;

Vec6 random_direction(std::mt19937_64& random, int dimensions) {
  Vec6 n = Vec6::Zero();
  do
    for (int i = 0; i < dimensions; ++i) n[i] = test::uniform(random, -1, 1);
  while (n.squaredNorm() > 1 || n.squaredNorm() < 1e-2);
  return n;
}

double worst_violation(const Rows& rows, const Vec6& y) {
  double worst = 0;
  for (const HalfSpace& r : rows) worst = std::max(worst, r.bound - r.normal.dot(y));
  return worst;
}

/// Reference: the least point is the least one on the flat of some subset of at most six rows, so
/// every subset is tried; of those that satisfy all rows the nearest is the answer. Trusted to
/// 1e-9 where a subset's matrix is well conditioned, which random rows are. None: no subset's point
/// satisfies all rows, so the set is empty.
std::optional<double> least_by_enumeration(const Rows& rows) {
  std::optional<double> best;
  if (worst_violation(rows, Vec6::Zero()) <= 0) return 0.0;
  const auto n = rows.size();
  for (std::uint32_t subset = 1; subset < 1u << n; ++subset) {
    const int size = __builtin_popcount(subset);
    if (size > 6) continue;
    Eigen::MatrixXd N(size, 6);
    Eigen::VectorXd b(size);
    int at = 0;
    for (std::size_t i = 0; i < n; ++i)
      if (subset >> i & 1u) N.row(at) = rows[i].normal.transpose(), b[at++] = rows[i].bound;
    const Vec6 y = N.completeOrthogonalDecomposition().solve(b);
    if ((N * y - b).norm() > 1e-10 * (1 + b.norm())) continue;
    if (worst_violation(rows, y) > 1e-10 * (1 + y.norm())) continue;
    if (!best || y.norm() < *best) best = y.norm();
  }
  return best;
}

/// What is promised of any feasible answer: the conditions of optimality, which for this convex
/// problem prove it.
void check_optimal(const Rows& rows, const LeastDistance& got, double tolerance) {
  ASSERT_TRUE(got.feasible);
  ASSERT_LE(got.active_count, 6);
  double scale = 1e-300, allowed = tolerance;
  for (const HalfSpace& r : rows) scale = std::max(scale, std::abs(r.bound));
  Vec6 sum = Vec6::Zero();
  double terms = scale;
  for (int i = 0; i < got.active_count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const HalfSpace& row = rows[static_cast<std::size_t>(got.active[k])];
    EXPECT_GT(got.multiplier[k], 0);
    sum += got.multiplier[k] * row.normal;
    terms += got.multiplier[k];
  }
  allowed += 1e-10 * terms;
  EXPECT_LE(worst_violation(rows, got.y), allowed);
  EXPECT_LE((got.y - sum).norm(), 1e-10 * terms);
  for (int i = 0; i < got.active_count; ++i) {
    const HalfSpace& row = rows[static_cast<std::size_t>(got.active[static_cast<std::size_t>(i)])];
    EXPECT_NEAR(row.normal.dot(got.y), row.bound, allowed);
  }
}

/// Random rows; some of them twice, scaled, or nearly the same.
Rows random_rows(std::mt19937_64& random, int count, int dimensions, bool degenerate) {
  Rows rows;
  for (int i = 0; i < count; ++i) {
    HalfSpace row{random_direction(random, dimensions), test::uniform(random, -0.5, 1)};
    if (degenerate && !rows.empty() && random() % 2) {
      row = rows[random() % rows.size()];
      switch (random() % 4) {
        case 0:
          row.bound += test::uniform(random, -0.2, 0.2);
          break;
        case 1:
          row.normal *= 3, row.bound *= 3;
          break;
        case 2:
          row.normal += 1e-9 * random_direction(random, dimensions);
          break;
        default:
          break;
      }
    }
    rows.push_back(row);
  }
  return rows;
}

TEST(LeastDistance, is_the_least_over_all_active_subsets) {
  std::mt19937_64 random(1);
  int feasible = 0, infeasible = 0, zero = 0;
  for (int i = 0; i < 3000; ++i) {
    const int dimensions = i % 3 ? 6 : 2 + static_cast<int>(random() % 4);
    const Rows rows = random_rows(random, 1 + static_cast<int>(random() % 9), dimensions, false);
    const auto reference = least_by_enumeration(rows);
    const LeastDistance got = least_distance(rows, 1e-14);
    ASSERT_EQ(got.feasible, reference.has_value()) << i;
    if (!reference) {
      ++infeasible;
      continue;
    }
    check_optimal(rows, got, 1e-14);
    EXPECT_NEAR(got.y.norm(), *reference, 1e-9 * (1 + *reference)) << i;
    zero += *reference <= 0;
    ++feasible;
  }
  EXPECT_GT(feasible, 1000);
  EXPECT_GT(infeasible, 20);
  EXPECT_GT(zero, 10);
}

TEST(LeastDistance, rows_twice_scaled_and_nearly_the_same) {
  std::mt19937_64 random(2);
  int feasible = 0;
  for (int i = 0; i < 5000; ++i) {
    const Rows rows = random_rows(random, 3 + static_cast<int>(random() % 20), 6, true);
    // A tolerance such as the descent has; rows that differ by 1e-9 may be let stand.
    const LeastDistance got = least_distance(rows, 1e-7);
    ASSERT_TRUE(got.y.allFinite());
    if (!got.feasible) continue;
    ++feasible;
    check_optimal(rows, got, 1e-7);
  }
  EXPECT_GT(feasible, 2000);
}

TEST(LeastDistance, many_rows) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 300; ++i) {
    // All rows leave a far point free, so the set is not empty.
    const Vec6 far = 5 * random_direction(random, 6).normalized();
    Rows rows;
    while (rows.size() < 128) {
      HalfSpace row{random_direction(random, 6).normalized(), 0};
      row.bound = row.normal.dot(far) - test::uniform(random, 0, 3);
      rows.push_back(row);
    }
    const LeastDistance got = least_distance(rows, 1e-12);
    check_optimal(rows, got, 1e-12);
    EXPECT_LE(got.y.norm(), far.norm());
  }
}

TEST(LeastDistance, by_hand) {
  const auto row = [](int i, double sign, double bound) {
    HalfSpace r{Vec6::Zero(), bound};
    r.normal[i] = sign;
    return r;
  };
  EXPECT_EQ(least_distance({}, 0).y.norm(), 0);
  EXPECT_EQ(least_distance(Rows{row(0, 1, -1)}, 0).active_count, 0);
  const LeastDistance corner = least_distance(Rows{row(0, 1, 3), row(4, 1, 4)}, 0);
  EXPECT_EQ(corner.y.norm(), 5);
  EXPECT_EQ(corner.active_count, 2);
  EXPECT_FALSE(least_distance(Rows{row(0, 1, 1), row(0, -1, -0.5)}, 1e-12).feasible);
  EXPECT_TRUE(least_distance(Rows{row(0, 1, 1), row(0, -1, -1)}, 1e-12).feasible);
  EXPECT_FALSE(least_distance(Rows{HalfSpace{Vec6::Zero(), 1}}, 1e-12).feasible);
}

TEST(LeastDistance, tiny_and_huge_numbers) {
  std::mt19937_64 random(4);
  for (const double scale : {1e-9, 1e-3, 1e6})
    for (int i = 0; i < 300; ++i) {
      Rows rows = random_rows(random, 6, 6, false);
      const LeastDistance plain = least_distance(rows, 1e-13);
      for (HalfSpace& r : rows) r.bound *= scale;
      const LeastDistance scaled = least_distance(rows, 1e-13 * scale);
      ASSERT_EQ(plain.feasible, scaled.feasible);
      if (plain.feasible) {
        EXPECT_LE((scaled.y - scale * plain.y).norm(), 1e-9 * scale * (1 + plain.y.norm()));
      }
    }
}

// The reference is the search from the origin; the optimum is one, so where it began must not show.
TEST(LeastDistance, any_start_leads_to_the_same_answer) {
  std::mt19937_64 random(11);
  int feasible = 0, from_the_answer = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    Rows rows;
    const int count = 1 + trial % 60;
    for (int i = 0; i < count; ++i)
      rows.push_back({random_direction(random, 6), test::uniform(random, -0.5, 1)});
    if (trial % 3 == 0) rows.push_back(rows[0]);  // twice
    const LeastDistance cold = least_distance(rows, 1e-12);
    std::vector<int> start(static_cast<std::size_t>(random() % 7));
    for (int& row : start) row = static_cast<int>(random() % rows.size());
    const std::span known(cold.active.data(), static_cast<std::size_t>(cold.active_count));
    for (const std::span<const int> begin : {std::span<const int>(start), known}) {
      const LeastDistance warm = least_distance(rows, 1e-12, begin);
      ASSERT_EQ(warm.feasible, cold.feasible) << trial;
      if (!cold.feasible) continue;
      ++feasible;
      EXPECT_LT((warm.y - cold.y).norm(), 1e-9 * (1 + cold.y.norm())) << trial;
      Vec6 y = Vec6::Zero();
      for (int i = 0; i < warm.active_count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        EXPECT_GT(warm.multiplier[at], 0);
        y += warm.multiplier[at] * rows[static_cast<std::size_t>(warm.active[at])].normal;
      }
      EXPECT_LT((warm.y - y).norm(), 1e-9 * (1 + y.norm())) << trial;
    }
    from_the_answer += cold.feasible && cold.active_count > 0;
  }
  EXPECT_GT(feasible, 1000);
  EXPECT_GT(from_the_answer, 300);
}

TEST(LeastDistance, does_not_allocate) {
  std::mt19937_64 random(5);
  const Rows rows = random_rows(random, 40, 6, true);
  test::AllocationCounter counter;
  const LeastDistance got = least_distance(rows, 1e-9);
  counter.stop();
  EXPECT_EQ(counter.allocations(), 0u) << got.active_count;
}

}  // namespace
}  // namespace sonde
