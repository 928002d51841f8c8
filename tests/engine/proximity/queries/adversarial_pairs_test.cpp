// SPDX-License-Identifier: GPL-3.0-or-later
// Near pairs on soups and poses that are hard on floating point.
#include <gtest/gtest.h>

#include <iostream>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "engine/proximity/queries/distance.hpp"
#include "engine/proximity/queries/near_pairs.hpp"
#include "tests/engine/proximity/pair_gaps.hpp"
#include "tests/support/adversarial.hpp"
#include "tests/support/exact_reference.hpp"

namespace sonde {
namespace {

using test::BodyPair;
using test::PairKey;
using test::Placed;

struct RowCounts {
  std::size_t poses = 0, rows = 0, at_the_edge = 0, overflowed = 0;
};

// Reference: exact distances, and the gap along the normal in exact arithmetic.
void check_row(const NearPair& row, const Placed& a, const Placed& b, double distance,
               double rounding, const std::string& what) {
  const Corners& ta = a.triangles[row.triangle_a];
  const Corners& tb = b.triangles[row.triangle_b];
  const double gap = test::exact_gap_along(row.normal, ta, tb);
  EXPECT_NEAR(row.normal.norm(), 1, 1e-14) << what;
  EXPECT_NEAR(row.gap, gap, rounding) << what << ": the gap is one along the normal";
  EXPECT_LE(row.gap, distance + rounding) << what << ": a lower bound of the distance";
  EXPECT_GE(row.gap, 0.99 * distance - rounding) << what << ": and nearly all of it";
  EXPECT_NEAR((row.on_a - row.on_b).norm(), distance, rounding) << what;
}

struct HardQuery {
  const BodyPair& pair;
  const Transform& X;
  double reach, rounding;
  const std::string& what;
};

void check_near(const HardQuery& q, const Placed& a, const Placed& b, std::vector<NearPair>& out,
                RowCounts& counts) {
  const NearPairs near = near_pairs(*q.pair.a, *q.pair.b, q.X, q.reach, out);
  ASSERT_LE(near.count, out.size()) << q.what;
  ASSERT_LE(near.reach, q.reach) << q.what;
  std::set<PairKey> found;
  for (std::size_t k = 0; k < near.count; ++k) {
    const PairKey key(out[k].triangle_a, out[k].triangle_b);
    ASSERT_LT(key.first, a.triangles.size()) << q.what;
    ASSERT_LT(key.second, b.triangles.size()) << q.what;
    EXPECT_TRUE(found.insert(key).second) << q.what << ": twice the same";
    const double distance = test::exact_distance(a.triangles[key.first], b.triangles[key.second]);
    EXPECT_LE(distance, q.reach + q.rounding) << q.what << ": out of reach";
    check_row(out[k], a, b, distance, q.rounding, q.what);
    counts.at_the_edge += std::abs(distance - q.reach) <= q.rounding;
  }
  for (std::uint32_t i = 0; i < a.triangles.size(); ++i)
    for (std::uint32_t j = 0; j < b.triangles.size(); ++j) {
      if (test::below_distance_of_boxes(a, i, b, j) >= q.reach || found.count({i, j})) continue;
      const double distance = test::exact_distance(a.triangles[i], b.triangles[j]);
      if (distance > q.rounding) {
        EXPECT_GE(distance, near.reach - q.rounding) << q.what << ": left out";
      }
    }
  if (near.reach < q.reach) {
    EXPECT_GE(near.count, out.size() / 2) << q.what << ": for want of room alone";
  }
  counts.rows += near.count, counts.overflowed += near.reach < q.reach;
}

/// Just a distance that there is, a little more, or any.
double some_reach(const BodyPair& pair, const Transform& X, std::mt19937_64& random) {
  const double any = test::uniform(random, 0, 0.3) * pair.b->mass.radius;
  const double least = triangle_distance(*pair.a, *pair.b, X).distance;
  switch (random() % 4) {
    case 0:
      return least;
    case 1:
      return least * (1 + 0x1p-52 * static_cast<double>(random() % 4));
    case 2:
      return least + 1e-3 * any;
    default:
      return any;
  }
}

void check_pairs(std::uint64_t seed, int pairs, int triangles, int poses) {
  RowCounts counts;
  std::mt19937_64 random(seed);
  std::vector<NearPair> plenty(4u * static_cast<std::size_t>(triangles * triangles) + 2);
  std::vector<NearPair> few(6);
  test::for_adversarial_poses(
      seed, pairs, triangles, poses,
      [&](const BodyPair& pair, const test::HardPose& pose, const std::string& what) {
        const Placed a(*pair.a, pose.X), b(*pair.b, {});
        const HardQuery q{pair, pose.X, some_reach(pair, pose.X, random),
                          1e-14 * test::size_at(pair, pose.X), what};
        check_near(q, a, b, random() % 4 ? plenty : few, counts);
        ++counts.poses;
      });
  EXPECT_GT(counts.rows, counts.poses);
  EXPECT_GT(counts.at_the_edge, counts.poses / 100);
  EXPECT_GT(counts.overflowed, counts.poses / 100);
  std::cout << counts.poses << " poses of 2 x " << triangles << " triangles: " << counts.rows
            << " rows, " << counts.at_the_edge << " at the very edge of the reach, "
            << counts.overflowed << " buffers too small\n";
}

TEST(AdversarialPairs, of_few_triangles) { check_pairs(21, 4, 5, 4); }
TEST(AdversarialPairs, of_dozens) { check_pairs(22, 1, 24, 2); }
TEST(AdversarialPairs, Full_pairs) {
  check_pairs(23, 40, 6, 10);
  check_pairs(24, 4, 40, 5);
}

}  // namespace
}  // namespace sonde
