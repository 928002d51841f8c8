// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <utility>

#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/sweep/neighbour_list.hpp"
#include "tests/engine/proximity/pair_gaps.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/conforming.hpp"
#include "tests/support/pairs.hpp"

namespace sonde {
namespace {

using test::gaps;
using test::PairKey;

using Keys = std::set<PairKey>;

Keys keys(std::span<const NearPair> pairs, double nearer) {
  Keys out;
  for (const NearPair& p : pairs)
    if (p.gap < nearer) out.insert({p.triangle_a, p.triangle_b});
  return out;
}

// Reference: near_pairs, itself tested against all pairs. Whether it is the work or the room for
// pairs that ends the plan for more, and wherever on the way: what is stated of the list is the
// least room, and all that lies within it was found.
TEST(NeighbourList, one_that_shrinks_on_the_way_misses_nothing_within_the_least) {
  Effort unlimited;
  std::mt19937_64 random(12);
  std::vector<NearPair> from_list(1 << 15), from_trees(1 << 15);
  int by_work = 0, by_count = 0, whole = 0;
  std::size_t pairs_seen = 0;
  for (const auto& pair : test::body_pairs(51)) {
    const double radius = pair.a->mass.radius;
    for (int i = 0; i < 40; ++i) {
      const Pose pose = test::random_pose(random, *pair.a, *pair.b, 0.7);
      const Transform X(pose);
      const Vec3 centre = pair.a->mass.com + test::random_in_ball(random, radius);
      const DisplacementBound ample{test::uniform(random, 0.05, 0.2) * radius,
                                    test::uniform(random, 0, 0.1)};
      const double part = test::uniform(random, 0.1, 0.9);
      const DisplacementBound least{part * ample.linear, part * ample.turn};
      NeighbourList large(*pair.a, *pair.b), small(*pair.a, *pair.b);
      ASSERT_TRUE(large.build(X, centre, ample, unlimited)) << pair.name;
      ASSERT_TRUE(small.build(X, centre, least, unlimited)) << pair.name;
      const std::int64_t work = large.work_of_build();
      const bool few = i % 2 == 0 && large.size() > small.size();
      const std::size_t capacity = few ? (small.size() + large.size()) / 2 : large.size() + 1;
      NeighbourList list(*pair.a, *pair.b, capacity);
      NeighbourList::BuildPlan plan{{ample}, {least}};
      if (!few)
        plan.most_work =
            static_cast<std::int64_t>(test::uniform(random, 0, 1.2) * static_cast<double>(work));
      ASSERT_TRUE(list.build_by(plan, X, centre, unlimited)) << pair.name;
      if (few) {
        EXPECT_TRUE(list.used_fallback());
      } else {
        EXPECT_EQ(list.used_fallback(), plan.most_work < work) << pair.name;
      }
      EXPECT_EQ(list.reach_at(X), (list.used_fallback() ? small : large).reach_at(X));
      EXPECT_LE(list.size(), large.size());
      EXPECT_GE(list.size(), list.used_fallback() ? small.size() : large.size());
      (!list.used_fallback() ? whole : few ? by_count : by_work) += 1;
      const Pose moved{pose.q, pose.p + test::random_in_ball(random, 0.5 * least.linear)};
      for (const Transform& at : {X, Transform(moved)}) {
        const double reach = list.reach_at(at);
        const double sure =
            reach - 1e-14 * (extent(*pair.a) + extent(*pair.b) + at.p.cwiseAbs().maxCoeff());
        const auto got = list.near(at, reach, from_list, unlimited);
        const auto want = near_pairs(*pair.a, *pair.b, at, reach, from_trees);
        EXPECT_EQ(keys({from_list.data(), got.count}, sure),
                  keys({from_trees.data(), want.count}, sure))
            << pair.name;
        pairs_seen += got.count;
      }
    }
  }
  EXPECT_GT(by_work, 30);
  EXPECT_GT(by_count, 30);
  EXPECT_GT(whole, 5);
  EXPECT_GT(pairs_seen, 1000u);
}

// Reference: near_pairs, itself tested against all pairs, wherever the probe comes on its course or
// beside it; a list for all ways that are as long for how many pairs are spared.
TEST(NeighbourList, for_a_course_it_misses_nothing_on_it_or_beside_it) {
  Effort unlimited;
  std::mt19937_64 random(13);
  std::vector<NearPair> from_list(1 << 15), from_trees(1 << 15);
  int looks = 0, shrunk = 0;
  std::size_t pairs_seen = 0, held = 0, held_of_all_ways = 0;
  for (const auto& pair : test::body_pairs(51)) {
    const double radius = pair.a->mass.radius;
    for (int i = 0; i < 40; ++i) {
      const Pose pose = test::random_pose(random, *pair.a, *pair.b, 0.8);
      const Transform X(pose);
      const Vec3 centre = pair.a->mass.com + test::random_in_ball(random, radius);
      const double size = test::uniform(random, 0.02, 0.2);
      const Course course{test::random_in_ball(random, size * radius),
                          test::random_in_ball(random, size)};
      const DisplacementBound around{0.2 * size * radius, 0.2 * size};
      const double part = test::uniform(random, 0.3, 1);
      const NeighbourList::Coverage ample{around, course};
      const NeighbourList::Coverage least{{part * around.linear, part * around.turn},
                                          part * course};
      NeighbourList list(*pair.a, *pair.b, 1 << 15), all_ways(*pair.a, *pair.b, 1 << 15);
      NeighbourList::BuildPlan plan{ample, least};
      if (i % 2 == 0) plan.most_work = 300;
      ASSERT_TRUE(list.build_by(plan, X, centre, unlimited)) << pair.name;
      if (!list.used_fallback()) {
        const DisplacementBound length{course.size().linear + around.linear,
                                       course.size().turn + around.turn};
        ASSERT_TRUE(all_ways.build(X, centre, length, unlimited)) << pair.name;
        EXPECT_LE(list.size(), all_ways.size());
        held += list.size(), held_of_all_ways += all_ways.size();
      }
      shrunk += list.used_fallback();
      for (int k = 0; k < 6; ++k) {
        const double u = test::uniform(random, 0, 1.1);
        const Vec3 turn = u * course.turn + test::random_in_ball(random, 0.1 * size);
        const Quat q =
            (Quat(Eigen::AngleAxisd(turn.norm(), turn.normalized())) * pose.q).normalized();
        const Transform at(Pose{q, X * centre + u * course.linear - q * centre +
                                       test::random_in_ball(random, 0.1 * size * radius)});
        const double reach = list.reach_at(at);
        if (reach <= 0) continue;
        const double sure =
            reach - 1e-14 * (extent(*pair.a) + extent(*pair.b) + at.p.cwiseAbs().maxCoeff());
        const auto got = list.near(at, reach, from_list, unlimited);
        const auto want = near_pairs(*pair.a, *pair.b, at, reach, from_trees);
        EXPECT_EQ(keys({from_list.data(), got.count}, sure),
                  keys({from_trees.data(), want.count}, sure))
            << pair.name << " at " << u;
        pairs_seen += got.count;
        ++looks;
      }
    }
  }
  EXPECT_GT(looks, 500);
  EXPECT_GT(shrunk, 50);
  EXPECT_GT(pairs_seen, 1000u);
  EXPECT_LT(3 * held, 2 * held_of_all_ways);
}

// Reference: the number of pairs that touch, by the trees.
TEST(NeighbourList, holds_all_pairs_of_two_faces_that_fit_into_each_other) {
  const auto a = test::body(test::wavy_block(test::WavyBlock::above, 40));
  const auto b = test::body(test::wavy_block(test::WavyBlock::below, 40));
  const Transform X(Pose{Quat::Identity(), {0, 0, 1e-6}});
  Effort unlimited;
  NeighbourList list(*a, *b);
  ASSERT_TRUE(list.build(X, 1e-5, unlimited));
  std::vector<NearPair> from_trees(1 << 17);
  const NearPairs touching = near_pairs(*a, *b, X, 5e-6, from_trees, unlimited);
  ASSERT_EQ(touching.reach, 5e-6);
  EXPECT_GT(touching.count, 32'768u);
  EXPECT_GE(list.size(), touching.count);
}

// Reference: the list made in one go.
TEST(NeighbourList, made_bit_by_bit_it_is_the_same_list) {
  Effort unlimited;
  std::mt19937_64 random(7);
  std::vector<NearPair> at_once(1 << 15), in_bits(1 << 15);
  for (const auto& pair : test::body_pairs(51)) {
    const Transform X(test::random_pose(random, *pair.a, *pair.b, 0.7));
    const double reach = 0.2 * pair.a->mass.radius;
    NeighbourList whole(*pair.a, *pair.b), bits(*pair.a, *pair.b);
    ASSERT_TRUE(whole.build(X, reach, unlimited)) << pair.name;
    Effort little(30, 0);
    bool done = bits.build(X, reach, little);
    int times = 1;
    for (; !done && times < 100000; ++times) {
      ASSERT_TRUE(bits.is_unfinished()) << pair.name;
      EXPECT_LT(bits.reach_at(X), 0) << "covers nothing yet";
      EXPECT_NEAR(bits.reach_when_finished(X, {}), whole.reach_at(X), 0) << pair.name;
      Effort more(30, 0);
      done = bits.go_on(more);
    }
    EXPECT_GT(times, 1) << pair.name;
    EXPECT_FALSE(bits.is_unfinished());
    EXPECT_EQ(bits.size(), whole.size()) << pair.name;
    const double asked = 0.99 * whole.reach_at(X);
    const auto want = whole.near(X, asked, at_once, unlimited);
    const auto got = bits.near(X, asked, in_bits, unlimited);
    EXPECT_EQ(gaps({in_bits.data(), got.count}), gaps({at_once.data(), want.count})) << pair.name;
  }
}

}  // namespace
}  // namespace sonde
