// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/queries/near_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>

#include "engine/proximity/queries/placement.hpp"
#include "tests/engine/proximity/pair_gaps.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/pairs.hpp"

namespace sonde {
namespace {

using test::PairKey;

/// Distances of all pairs of triangles. Reference for every set below.
std::map<PairKey, double> all_distances(const test::BodyPair& pair, const Transform& X) {
  const auto ta = test::placed_triangles(*pair.a, X), tb = test::placed_triangles(*pair.b, {});
  std::map<PairKey, double> out;
  for (std::uint32_t i = 0; i < ta.size(); ++i)
    for (std::uint32_t j = 0; j < tb.size(); ++j)
      out[{i, j}] = closest_points(ta[i], tb[j]).distance;
  return out;
}

struct RandomQuery {
  Transform X;
  double reach, rounding;
};
RandomQuery random_query(std::mt19937_64& random, const test::BodyPair& pair) {
  const Transform X(test::random_pose(random, *pair.a, *pair.b, 0.9));
  const double size = extent(*pair.a) + extent(*pair.b) + X.p.cwiseAbs().maxCoeff();
  return {X, test::uniform(random, 0.05, 0.4) * pair.b->mass.radius, 1e-14 * size};
}

void check_fields(const NearPair& p, const test::BodyPair& pair, const RandomQuery& q) {
  const Corners ta = place(q.X, corners(surface(*pair.a), p.triangle_a));
  const Corners tb = corners(surface(*pair.b), p.triangle_b);
  const double distance = closest_points(ta, tb).distance;
  EXPECT_NEAR(p.normal.norm(), 1, 1e-14) << pair.name;
  EXPECT_NEAR(p.gap, gap_along(p.normal, ta, tb), q.rounding) << pair.name;
  EXPECT_LE(p.gap, distance + q.rounding) << pair.name;
  EXPECT_GE(p.gap, 0.99 * distance - q.rounding) << pair.name;
  EXPECT_NEAR((p.on_a - p.on_b).norm(), distance, q.rounding) << pair.name;
}

TEST(NearPairs, are_those_of_all_pairs_that_are_within_reach) {
  std::mt19937_64 random(1);
  std::vector<NearPair> out(1 << 16);
  for (const auto& pair : test::body_pairs(31)) {
    std::size_t total = 0;
    for (int i = 0; i < 40; ++i) {
      const RandomQuery q = random_query(random, pair);
      const NearPairs near = near_pairs(*pair.a, *pair.b, q.X, q.reach, out);
      EXPECT_EQ(near.reach, q.reach);
      std::map<PairKey, int> found;
      for (std::size_t k = 0; k < near.count; ++k) {
        ++found[{out[k].triangle_a, out[k].triangle_b}];
        check_fields(out[k], pair, q);
      }
      EXPECT_EQ(found.size(), near.count) << pair.name << ": no pair twice";
      for (const auto& [key, distance] : all_distances(pair, q.X)) {
        if (distance > q.rounding && distance < q.reach - q.rounding) {
          EXPECT_EQ(found.count(key), 1u) << pair.name << " " << distance << " " << q.reach;
        }
        if (distance <= 0 || distance > q.reach + q.rounding) {
          EXPECT_EQ(found.count(key), 0u) << pair.name << " " << distance << " " << q.reach;
        }
      }
      total += near.count;
    }
    EXPECT_GT(total, 100u) << pair.name;
  }
}

// A buffer too small: what is nearer than the reach returned is all there.
TEST(NearPairs, too_many_keep_the_nearest_and_say_how_far_that_goes) {
  std::mt19937_64 random(2);
  for (const auto& pair : test::body_pairs(32)) {
    int overflowed = 0;
    for (int i = 0; i < 40; ++i) {
      const RandomQuery q = random_query(random, pair);
      std::vector<NearPair> out(2 + random() % 8);
      const NearPairs near = near_pairs(*pair.a, *pair.b, q.X, q.reach, out);
      ASSERT_LE(near.count, out.size());
      EXPECT_LE(near.reach, q.reach);
      std::map<PairKey, int> found;
      for (std::size_t k = 0; k < near.count; ++k) {
        ++found[{out[k].triangle_a, out[k].triangle_b}];
        check_fields(out[k], pair, q);
      }
      std::size_t within = 0;
      for (const auto& [key, distance] : all_distances(pair, q.X)) {
        if (distance > q.rounding && distance < near.reach - q.rounding) {
          EXPECT_EQ(found.count(key), 1u) << pair.name << " " << distance << " " << near.reach;
        }
        within += distance > q.rounding && distance < q.reach - q.rounding;
      }
      if (within > out.size()) {
        ++overflowed;
        EXPECT_LT(near.reach, q.reach);
        EXPECT_GE(near.count, out.size() / 2) << "at least half of the buffer is of use";
      }
    }
    EXPECT_GT(overflowed, 10) << pair.name;
  }
}

TEST(NearPairs, halving_keeps_the_nearer_half) {
  std::mt19937_64 random(3);
  std::vector<NearPair> pairs(100);
  for (std::uint32_t i = 0; i < 100; ++i)
    pairs[i].gap = test::uniform(random, 0, 1), pairs[i].triangle_a = i;
  std::vector<double> gaps;
  for (const NearPair& p : pairs) gaps.push_back(p.gap);
  std::sort(gaps.begin(), gaps.end());
  double reach = 2;
  ASSERT_EQ(keep_nearer_half(pairs, reach), 50u);
  EXPECT_EQ(reach, gaps[50]);
  for (std::size_t i = 0; i < 50; ++i) EXPECT_LT(pairs[i].gap, reach);
}

TEST(NearPairs, do_not_allocate) {
  std::mt19937_64 random(4);
  const auto pairs = test::body_pairs(33);
  std::vector<NearPair> out(30);
  std::size_t found = 0;
  test::AllocationCounter counter;
  for (const auto& pair : pairs)
    for (int i = 0; i < 20; ++i) {
      const RandomQuery q = random_query(random, pair);
      found += near_pairs(*pair.a, *pair.b, q.X, q.reach, out).count;
    }
  counter.stop();
  EXPECT_EQ(counter.allocations(), 0u);
  EXPECT_GT(found, 100u);
}

}  // namespace
}  // namespace sonde
