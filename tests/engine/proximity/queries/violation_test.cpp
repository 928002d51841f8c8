// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/queries/violation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/sweep/neighbour_list.hpp"
#include "tests/engine/proximity/pair_gaps.hpp"
#include "tests/engine/proximity/small_motions.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/pairs.hpp"

namespace sonde {
namespace {

using test::nudged;
using test::PairKey;
using test::rounding_at;

/// Distances of all pairs, by closest_points.
std::map<PairKey, double> distances(const Body& a, const Body& b, const Transform& X) {
  std::map<PairKey, double> out;
  const auto ta = test::placed_triangles(a, X), tb = test::placed_triangles(b, {});
  for (std::uint32_t i = 0; i < ta.size(); ++i)
    for (std::uint32_t j = 0; j < tb.size(); ++j)
      out[{i, j}] = closest_points(ta[i], tb[j]).distance;
  return out;
}

/// What was found against all pairs: nothing twice, nothing that is not there, and with room left
/// (`all`) everything.
void check_found(std::span<const Violation> found, const std::map<PairKey, double>& distances,
                 double least, double rounding, bool all, const std::string& what) {
  std::set<PairKey> keys;
  for (const Violation& t : found) {
    const PairKey key{t.triangle_a, t.triangle_b};
    EXPECT_TRUE(keys.insert(key).second) << what;
    const double distance = distances.at(key);
    EXPECT_LE(distance, least + rounding) << what;
    if (distance > rounding) {
      // The direction between near points is turned by rounding, and leaves a little less.
      EXPECT_LE(t.gap, distance + rounding) << what;
      EXPECT_GE(t.gap, distance * (1 - 1e-6) - rounding) << what;
    } else {
      EXPECT_LE(t.gap, rounding) << what;
    }
  }
  if (!all) return;
  for (const auto& [key, distance] : distances)
    if (distance < least - rounding || distance == 0) {
      EXPECT_TRUE(keys.contains(key)) << what << distance;
    }
}

// Reference: closest_points of all pairs.
TEST(Violation, every_pair_too_near_is_found_while_there_is_room) {
  std::mt19937_64 random(1);
  std::vector<Violation> out(1 << 15);
  Effort unlimited;
  for (const auto& pair : test::body_pairs(91)) {
    std::size_t found_in_all = 0;
    for (int i = 0; i < 40; ++i) {
      const Pose X = test::random_pose(random, *pair.a, *pair.b, 1.2);
      const double least =
          i % 4 ? pair.a->mass.radius * std::pow(10, test::uniform(random, -6, 0)) : 0;
      const auto all = distances(*pair.a, *pair.b, Transform(X));
      const std::size_t found =
          find_violations(*pair.a, *pair.b, Transform(X), least, out, unlimited);
      check_found({out.data(), found}, all, least, rounding_at(pair, X), true, pair.name);
      found_in_all += found;
      // Less room: as many as fit, of the same.
      for (const std::size_t room : {std::size_t{1}, std::size_t{7}, found / 2}) {
        if (room == 0 || room > found) continue;
        const std::size_t few =
            find_violations(*pair.a, *pair.b, Transform(X), least, {out.data(), room}, unlimited);
        EXPECT_EQ(few, room);
        check_found({out.data(), few}, all, least, rounding_at(pair, X), false, pair.name);
      }
    }
    EXPECT_GT(found_in_all, 100u) << pair.name;
  }
}

// Reference: closest_points of all pairs. The list was made elsewhere, and stands where it stood.
TEST(Violation, a_list_finds_the_same) {
  std::mt19937_64 random(2);
  std::vector<Violation> out(1 << 15), few(1 << 15);
  std::vector<NearPair> near(1 << 15);
  Effort unlimited;
  for (const auto& pair : test::body_pairs(92)) {
    NeighbourList list(*pair.a, *pair.b);
    std::size_t looks = 0, found_in_all = 0, cut_short = 0;
    for (int i = 0; i < 12; ++i) {
      const Pose start = test::random_pose(random, *pair.a, *pair.b, 1);
      const double reach = test::uniform(random, 0.05, 0.3) * pair.a->mass.radius;
      ASSERT_TRUE(list.build(Transform(start), reach, unlimited));
      Pose X = start;
      for (int step = 0; step < 8; ++step) {
        X = nudged(random, *pair.a, X, 0.08 * reach);
        const double left = list.reach_at(Transform(X));
        if (left <= 0) break;
        // Now and then the list goes along, and has directions of another place.
        if (step % 3 == 2) list.near(Transform(X), 0.5 * left, near, unlimited);
        const double least = step % 4 ? left * test::uniform(random, 0, 1) : 0;
        const auto all = distances(*pair.a, *pair.b, Transform(X));
        const std::size_t found = list.violations(Transform(X), least, out, unlimited);
        check_found({out.data(), found}, all, least, rounding_at(pair, X), true, pair.name);
        ++looks, found_in_all += found;
        for (const std::size_t room : {std::size_t{1}, std::size_t{5}, found / 2}) {
          if (room == 0 || room >= found) continue;
          const std::size_t kept =
              list.violations(Transform(X), least, {few.data(), room}, unlimited);
          ASSERT_EQ(kept, room);
          check_found({few.data(), kept}, all, least, rounding_at(pair, X), false, pair.name);
          // The deepest of all: none left out is deeper than one kept.
          std::set<PairKey> keys;
          double shallowest = -1e300;
          for (std::size_t k = 0; k < kept; ++k)
            keys.insert({few[k].triangle_a, few[k].triangle_b}),
                shallowest = std::max(shallowest, few[k].gap);
          for (std::size_t k = 0; k < found; ++k)
            if (!keys.contains({out[k].triangle_a, out[k].triangle_b})) {
              EXPECT_GE(out[k].gap, shallowest) << pair.name;
            }
          ++cut_short;
        }
      }
    }
    EXPECT_GT(looks, 40u) << pair.name;
    EXPECT_GT(found_in_all, 50u) << pair.name;
    EXPECT_GT(cut_short, 20u) << pair.name;
  }
}

// By hand: a cube that has sunk into a plate. The direction that separated the faces tells how
// deep.
TEST(Violation, a_list_knows_how_deep_what_was_apart_has_come) {
  const auto cube = test::body(test::box({0.1, 0.1, 0.1})),
             plate = test::body(test::box({1, 1, 1}));
  NeighbourList list(*cube, *plate);
  Effort unlimited;
  const Pose above{Quat::Identity(), Vec3(0.02, 0.03, 0.551)};
  ASSERT_TRUE(list.build(Transform(above), 0.05, unlimited));
  std::vector<Violation> out(64);
  for (const double depth : {-0.0005, 1e-6, 1e-3, 0.01}) {
    const Pose sunk{Quat::Identity(), above.p - Vec3(0, 0, 0.001 + depth)};
    const std::size_t found = list.violations(Transform(sunk), 1e-3, out, unlimited);
    ASSERT_GT(found, 0u);
    double deepest = 1;
    for (std::size_t i = 0; i < found; ++i) deepest = std::min(deepest, out[i].gap);
    EXPECT_NEAR(deepest, -depth, 1e-12);
  }
}

TEST(Violation, without_effort_it_ends_early_and_invents_nothing) {
  std::mt19937_64 random(3);
  std::vector<Violation> out(1 << 12);
  for (const auto& pair : test::body_pairs(93)) {
    const Pose X = test::random_pose(random, *pair.a, *pair.b, 0.6);
    const double least = 0.05 * pair.a->mass.radius;
    const auto all = distances(*pair.a, *pair.b, Transform(X));
    for (const std::int64_t work : {1, 100, 1000}) {
      Effort effort(work, 0);
      const std::size_t found = find_violations(*pair.a, *pair.b, Transform(X), least, out, effort);
      check_found({out.data(), found}, all, least, rounding_at(pair, X), !effort.is_spent(),
                  pair.name);
    }
  }
}

TEST(Violation, does_not_allocate) {
  std::mt19937_64 random(4);
  std::vector<Violation> out(16);
  Effort unlimited;
  for (const auto& pair : test::body_pairs(94)) {
    const Pose X = test::random_pose(random, *pair.a, *pair.b, 0.6);
    NeighbourList list(*pair.a, *pair.b);
    const double reach = 0.2 * pair.a->mass.radius;
    test::AllocationCounter counter;
    find_violations(*pair.a, *pair.b, Transform(X), reach, out, unlimited);
    if (list.build(Transform(X), reach, unlimited))
      list.violations(Transform(X), 0.5 * reach, out, unlimited);
    counter.stop();
    EXPECT_EQ(counter.allocations(), 0u) << pair.name;
  }
}

}  // namespace
}  // namespace sonde
