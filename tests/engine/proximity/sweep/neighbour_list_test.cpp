// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/sweep/neighbour_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "engine/penetration/search/coherent.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "tests/engine/proximity/pair_gaps.hpp"
#include "tests/engine/proximity/small_motions.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/joints.hpp"
#include "tests/support/pairs.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using test::gaps;
using test::nudged;
using test::rolled;
using test::rounding_at;

// Reference: near_pairs, itself tested against all pairs. The list is asked again and again while
// the probe walks off, so that its memory of bounds and normals is used.
TEST(NeighbourList, near_agrees_with_near_pairs_while_within_reach) {
  Effort unlimited;
  std::mt19937_64 random(1);
  std::vector<NearPair> from_list(1 << 15), from_trees(1 << 15);
  for (const auto& pair : test::body_pairs(51)) {
    NeighbourList list(*pair.a, *pair.b);
    int compared = 0;
    std::size_t pairs_seen = 0;
    for (int i = 0; i < 12; ++i) {
      Pose X = test::random_pose(random, *pair.a, *pair.b, 0.7);
      const double reach = test::uniform(random, 0.05, 0.3) * pair.a->mass.radius;
      ASSERT_TRUE(list.build(Transform(X), reach, unlimited)) << pair.name;
      EXPECT_LE(list.reach_at(Transform(X)), reach);
      EXPECT_NEAR(list.reach_at(Transform(X)), reach, 10 * rounding_at(pair, X));
      for (int step = 0; step < 20; ++step) {
        X = nudged(random, *pair.a, X, 0.03 * reach);
        const double left = list.reach_at(Transform(X));
        if (left <= 0) break;
        const double asked = test::uniform(random, 0, 1) * left;
        const auto near = list.near(Transform(X), asked, from_list, unlimited);
        const auto expected = near_pairs(*pair.a, *pair.b, Transform(X), asked, from_trees);
        EXPECT_EQ(near.reach, asked);
        const auto got = gaps({from_list.data(), near.count}),
                   want = gaps({from_trees.data(), expected.count});
        EXPECT_EQ(got.size(), near.count);
        const double rounding = rounding_at(pair, X);
        for (const auto& [key, gap] : want)
          if (gap < asked - rounding) {
            ASSERT_EQ(got.count(key), 1u) << pair.name << gap << " of " << asked;
            EXPECT_NEAR(got.at(key), gap, rounding);
          }
        for (const auto& [key, gap] : got)
          if (gap < asked - rounding) {
            EXPECT_EQ(want.count(key), 1u) << pair.name;
          }
        ++compared;
        pairs_seen += near.count;
      }
    }
    EXPECT_GT(compared, 100) << pair.name;
    EXPECT_GT(pairs_seen, 100u) << pair.name;
  }
}

// Reference: distances of all pairs. Whatever is nearer than reach_at is in the list, which `near`
// with that reach shows.
TEST(NeighbourList, its_reach_after_a_move_is_a_true_bound) {
  Effort unlimited;
  std::mt19937_64 random(2);
  std::vector<NearPair> out(1 << 15);
  for (const auto& pair : test::body_pairs(52)) {
    NeighbourList list(*pair.a, *pair.b);
    int used = 0;
    for (int i = 0; i < 40; ++i) {
      const Pose start = test::random_pose(random, *pair.a, *pair.b, 1.2);
      const double reach = 0.3 * pair.a->mass.radius;
      ASSERT_TRUE(list.build(Transform(start), reach, unlimited));
      const Transform X(nudged(random, *pair.a, start, test::uniform(random, 0, 0.7) * reach));
      const double left = list.reach_at(X);
      EXPECT_LE(left, reach);
      if (left <= 0) continue;
      ++used;
      const auto got = gaps({out.data(), list.near(X, left, out, unlimited).count});
      const auto ta = test::placed_triangles(*pair.a, X), tb = test::placed_triangles(*pair.b, {});
      for (std::uint32_t a = 0; a < ta.size(); ++a)
        for (std::uint32_t b = 0; b < tb.size(); ++b) {
          const double distance = closest_points(ta[a], tb[b]).distance;
          const double rounding = rounding_at(pair, start);
          if (distance > rounding && distance < left - rounding) {
            EXPECT_EQ(got.count({a, b}), 1u) << pair.name << distance << " " << left;
          }
        }
    }
    EXPECT_GT(used, 15) << pair.name;
  }
}

// Both sweeps are conservative, and they advance the same pairs by the same rule: they end at the
// same place but for what boxes leave over, which is less than the clearance. Freedom itself is
// tested with exact predicates on all pairs.
TEST(NeighbourList, sweep_along_agrees_with_sweep) {
  Effort unlimited;
  std::mt19937_64 random(3);
  for (const auto& pair : test::body_pairs(53)) {
    NeighbourList list(*pair.a, *pair.b);
    int hits = 0, compared = 0;
    for (int i = 0; i < 120; ++i) {
      const Pose start = test::random_pose(random, *pair.a, *pair.b, 0.9);
      const double reach = 0.4 * pair.a->mass.radius;
      if (test::any_pair_meets(*pair.a, *pair.b, Transform(start))) continue;
      ASSERT_TRUE(list.build(Transform(start), reach, unlimited));
      const Chart chart(pair.a->mass, start);
      for (int again = 0; again < 6; ++again) {
        const Vec6 to = chart.coordinates(nudged(random, *pair.a, start, 0.4 * reach));
        const Motion motion(chart, Vec6::Zero(), to);
        const double clearance = 1e-4 * reach;
        const double path = motion.linear_distance() + motion.turn_bound() * pair.a->mass.radius;
        if (path + clearance > list.reach_at(Transform(start))) continue;
        const Sweep expected = sweep(*pair.a, *pair.b, motion, clearance);
        const Sweep got = list.sweep_along(motion, clearance, unlimited);
        const double allowed = (2 * clearance + 100 * rounding_at(pair, start)) / path;
        EXPECT_EQ(got.hit, expected.hit) << pair.name;
        // Where the probe slides along, a little more room is a longer way.
        EXPECT_NEAR(got.free_until, expected.free_until, 30 * allowed) << pair.name;
        for (const double s : {got.free_until, 0.99 * got.free_until, 0.5 * got.free_until})
          EXPECT_FALSE(test::any_pair_meets(*pair.a, *pair.b, motion.at(s))) << pair.name;
        hits += got.hit;
        ++compared;
      }
    }
    EXPECT_GT(compared, 50) << pair.name;
    EXPECT_GT(hits, 5) << pair.name;
  }
}

// Reference: distances of all pairs, and exact predicates on all pairs for what a sweep calls free.
// The list is laid out for a probe that turns about one of its corners, which is asked and swept on
// and on until it has used up its room.
TEST(NeighbourList, laid_out_for_turns_about_a_corner_it_misses_nothing) {
  Effort unlimited;
  std::mt19937_64 random(6);
  std::vector<NearPair> out(1 << 15);
  int looks = 0, found = 0, sweeps = 0, far_turns = 0;
  for (int round = 0; round < 6; ++round)
    for (const auto& pair : test::body_pairs(56)) {
      const Body &a = *pair.a, &b = *pair.b;
      const double radius = a.mass.radius;
      const Pose start = test::random_pose(random, a, b, 1);
      if (test::any_pair_meets(a, b, Transform(start))) continue;
      const auto corner = static_cast<std::size_t>(test::uniform(random, 0, 0.999) *
                                                   static_cast<double>(a.soup.vertices.size()));
      const Vec3 centre = a.soup.vertices[corner];
      const double size = std::pow(10, test::uniform(random, -3, -0.3));
      const DisplacementBound room{size * radius * test::uniform(random, 0.01, 1),
                                   size * test::uniform(random, 0.3, 1)};
      NeighbourList list(a, b);
      if (!list.build(Transform(start), centre, room, unlimited)) continue;
      Pose at = start;
      for (int step = 0; step < 15; ++step) {
        const Pose to = rolled(random, at, centre, 0.15 * room.linear, 0.15 * room.turn);
        Chart chart(a.mass, start);
        chart.absorb_free_spin(at);
        const Motion motion(chart, chart.coordinates(at), chart.coordinates(to));
        if (!list.covers(motion, 1e-6 * radius)) break;
        const double free_until = list.sweep_along(motion, 1e-6 * radius, unlimited).free_until;
        for (const double part : {0.3, 0.7, 1.0})
          ASSERT_FALSE(test::any_pair_meets(a, b, motion.at(part * free_until))) << pair.name;
        ++sweeps;
        const Vec6 from = chart.coordinates(at);
        at = chart.pose(from + 0.999 * free_until * (chart.coordinates(to) - from));
        const double reach = test::uniform(random, 0.2, 1) * list.reach_at(Transform(at));
        if (reach <= 0) break;
        // A turn about the centre of mass alone would have used up more than the room by now.
        far_turns += room.linear < room.turn * (centre - a.mass.com).norm();
        const auto got = gaps({out.data(), list.near(Transform(at), reach, out, unlimited).count});
        const auto ta = test::placed_triangles(a, Transform(at)),
                   tb = test::placed_triangles(b, {});
        const double rounding = rounding_at(pair, at);
        for (std::uint32_t i = 0; i < ta.size(); ++i)
          for (std::uint32_t k = 0; k < tb.size(); ++k) {
            const double distance = closest_points(ta[i], tb[k]).distance;
            if (distance <= rounding || distance >= reach - rounding) continue;
            EXPECT_EQ(got.count({i, k}), 1u) << pair.name << " " << distance << " of " << reach;
            ++found;
          }
        ++looks;
      }
    }
  EXPECT_GT(looks, 100);
  EXPECT_GT(sweeps, 100);
  EXPECT_GT(found, 100);
  EXPECT_GT(far_turns, 20);
}

TEST(NeighbourList, says_so_when_there_are_too_many_and_before_it_is_built) {
  Effort unlimited;
  const auto knot = test::body(test::torus_knot(2, 3, 0.06, 0.025, 0.012, 100, 8));
  NeighbourList list(*knot, *knot);
  EXPECT_LT(list.reach_at(Transform()), 0);
  EXPECT_FALSE(list.build(Transform(), 1, unlimited));
  EXPECT_LT(list.reach_at(Transform()), 0);
  Transform away;
  away.p = Vec3(1, 0, 0);
  EXPECT_TRUE(list.build(away, 0.1, unlimited));
  EXPECT_NEAR(list.reach_at(away), 0.1, 1e-11);
}

TEST(NeighbourList, does_not_allocate) {
  Effort unlimited;
  std::mt19937_64 random(4);
  const auto pairs = test::body_pairs(54);
  std::vector<NearPair> out(50);
  for (const auto& pair : pairs) {
    NeighbourList list(*pair.a, *pair.b);
    const Pose X = test::random_pose(random, *pair.a, *pair.b, 1.2);
    const Chart chart(pair.a->mass, X);
    Vec6 to = Vec6::Zero();
    to[4] = 0.1 * pair.a->mass.radius;
    test::AllocationCounter counter;
    list.build(Transform(X), 0.3 * pair.a->mass.radius, unlimited);
    list.near(Transform(X), 0.2 * pair.a->mass.radius, out, unlimited);
    list.sweep_along(Motion(chart, Vec6::Zero(), to), 1e-4 * pair.a->mass.radius, unlimited);
    counter.stop();
    EXPECT_EQ(counter.allocations(), 0u) << pair.name;
  }
}

// A list of pairs that face each other in many directions, as a ball and its socket do. The
// direction that separated a pair when it was listed may say little once the probe has moved; the
// first look that compares the pair finds a better one.
TEST(NeighbourList, looks_only_once_at_a_pair_whose_direction_says_too_little) {
  std::vector<NearPair> out(48);
  int cheaper = 0;
  for (const test::FittedScene& joint : test::joint_scenes()) {
    const auto probe = test::body(joint.probe), fixed = test::body(joint.fixed);
    const std::vector<Pose> path = test::fitted_path(joint.path, 3000);
    CoherentSolver solver({probe, fixed});
    Separation in_contact = solver.reset(path.front());
    for (std::size_t i = 0; i < path.size() && in_contact.depth == 0; ++i)
      in_contact = solver.tick(path[i]);
    const Transform X(in_contact.separated);
    const double reach = 0.02 * probe->mass.radius;
    Effort unlimited;
    NeighbourList list(*probe, *fixed);
    if (!list.build(X, reach, unlimited)) continue;
    const auto work_of = [&](const Pose& pose) {
      Effort effort(1'000'000'000, 0);
      const std::int64_t before = effort.left();
      list.near(Transform(pose), 1e-4 * reach, out, effort);
      return before - effort.left();
    };
    Pose moved = in_contact.separated;
    moved.p += Vec3::Constant(0.1 * reach);
    const std::int64_t first = work_of(moved), again = work_of(moved);
    EXPECT_LE(again, first) << joint.name;
    cheaper += 3 * again < 2 * first;
  }
  EXPECT_GT(cheaper, 8);
}

// Reference: the same calls with all the effort they want, themselves tested above, and exact
// predicates for what a sweep calls free. The way that is known to be free grows with the effort,
// and is never longer than the whole answer.
TEST(NeighbourList, gives_up_with_what_is_known_when_the_effort_runs_out) {
  std::mt19937_64 random(9);
  std::vector<NearPair> out(1 << 15);
  int part_ways = 0, given_up = 0;
  for (const auto& pair : test::body_pairs(54))
    for (int i = 0; i < 20; ++i) {
      const Pose start = test::random_pose(random, *pair.a, *pair.b, 0.9);
      const double reach = 0.4 * pair.a->mass.radius, clearance = 1e-4 * reach;
      if (test::any_pair_meets(*pair.a, *pair.b, Transform(start))) continue;
      const Chart chart(pair.a->mass, start);
      const Vec6 to = chart.coordinates(nudged(random, *pair.a, start, 0.3 * reach));
      const Motion motion(chart, Vec6::Zero(), to);
      Effort unlimited;
      NeighbourList whole(*pair.a, *pair.b);
      ASSERT_TRUE(whole.build(Transform(start), reach, unlimited));
      const std::size_t all = whole.near(Transform(start), 0.5 * reach, out, unlimited).count;
      const Sweep swept = whole.sweep_along(motion, clearance, unlimited);
      for (const std::int64_t work : {1, 30, 100, 300, 1000, 3000, 100000}) {
        Effort to_build(work, 0), to_look(work, 0), to_sweep(work, 0);
        NeighbourList list(*pair.a, *pair.b);
        if (!list.build(Transform(start), reach, to_build)) {
          EXPECT_TRUE(to_build.is_spent());
          EXPECT_LT(list.reach_at(Transform(start)), 0);
          ASSERT_TRUE(list.build(Transform(start), reach, unlimited));
        }
        const NearPairs near = list.near(Transform(start), 0.5 * reach, out, to_look);
        EXPECT_EQ(near.reach < 0, to_look.is_spent());
        EXPECT_EQ(near.count, near.reach < 0 ? 0 : all) << pair.name;
        const Sweep part = list.sweep_along(motion, clearance, to_sweep);
        EXPECT_LE(part.free_until, swept.free_until + 0.01) << pair.name;
        EXPECT_TRUE(to_sweep.is_spent() || !part.given_up);
        EXPECT_TRUE(part.hit || !part.given_up);
        EXPECT_FALSE(test::any_pair_meets(*pair.a, *pair.b, motion.at(part.free_until)));
        given_up += part.given_up;
        part_ways += part.given_up && part.free_until > 0;
      }
    }
  EXPECT_GT(given_up, 50);
  EXPECT_GT(part_ways, 10);
}

}  // namespace
}  // namespace sonde
