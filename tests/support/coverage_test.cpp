// SPDX-License-Identifier: GPL-3.0-or-later
// The checker of rows that stand for pairs (tests/support/coverage.hpp) is itself checked: by hand,
// and by rows that were tampered with.
#include "tests/support/coverage.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/support/brute_force.hpp"
#include "tests/support/pairs.hpp"

namespace sonde {
namespace {

using test::Density;
using test::ReachedPair;

/// Two faces, parallel, 0.25 apart: the overlap of the two, seen from above, is the corner triangle
/// (0, 0), (1, 0), (0, 1).
ReachedPair parallel_faces() {
  ReachedPair p;
  p.a = {Vec3(0, 0, 0.25), Vec3(4, 0, 0.25), Vec3(0, 4, 0.25)};
  p.b = {Vec3(-3, 0, 0), Vec3(1, 0, 0), Vec3(-3, 4, 0)};
  p.row = {{0, 0, 0.25}, {0, 0, 0}, {0, 0, 1}, 0.25, 0, 0};
  return p;
}

NearPair row_at(double x, double y, double gap = 0.25) {
  return {{x, y, 0.25}, {x, y, 0}, {0, 0, 1}, gap, 0, 0};
}

TEST(Coverage, any_of_the_closest_points_will_do) {
  const ReachedPair p = parallel_faces();
  const Density density{0.1, 0.9, 1e-14};
  for (const auto& [x, y] : {std::pair(0.0, 0.0),
                             {0.9, 0.05},
                             {1.09, 0.0},
                             {0.5, 0.49},
                             {0.0, 1.09},
                             {-0.09, 0.5},
                             {0.56, 0.56}})
    EXPECT_TRUE(test::stands_for(row_at(x, y), p, density)) << x << " " << y;
  for (const auto& [x, y] :
       {std::pair(1.11, 0.0), {0.58, 0.58}, {0.0, 1.11}, {-0.11, 0.5}, {2.0, 1.0}, {-1.0, 0.0}})
    EXPECT_FALSE(test::stands_for(row_at(x, y), p, density)) << x << " " << y;
}

TEST(Coverage, gap_and_normal_count) {
  const ReachedPair p = parallel_faces();
  const Density density{0.1, 0.9, 1e-14};
  EXPECT_TRUE(test::stands_for(row_at(0.5, 0.2, 0.2), p, density));
  EXPECT_FALSE(test::stands_for(row_at(0.5, 0.2, 0.26), p, density));
  NearPair tilted = row_at(0.5, 0.2);
  tilted.normal = Vec3(0.3, 0, 1).normalized();
  EXPECT_TRUE(test::stands_for(tilted, p, density));
  tilted.normal = Vec3(0.6, 0, 1).normalized();
  EXPECT_FALSE(test::stands_for(tilted, p, density));
}

// All pairs stand for themselves; without one of them that is alone, they do not.
TEST(Coverage, a_missing_row_is_noticed) {
  std::mt19937_64 random(1);
  int noticed = 0;
  for (const auto& pair : test::body_pairs(81))
    for (int i = 0; i < 10; ++i) {
      const Transform X(test::random_pose(random, *pair.a, *pair.b, 0.9));
      const double reach = 0.3 * pair.b->mass.radius;
      const auto pairs = test::pairs_in_reach(*pair.a, *pair.b, X, reach);
      std::vector<NearPair> rows;
      rows.reserve(pairs.size());
      for (const ReachedPair& p : pairs) rows.push_back(p.row);
      const Density density{1e-3 * pair.a->mass.radius, 0.98, 0};
      ASSERT_TRUE(test::covers(rows, pairs, 2 * reach, density));
      if (rows.empty()) continue;
      rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(random() % rows.size()));
      noticed += !test::covers(rows, pairs, 2 * reach, density);
    }
  EXPECT_GT(noticed, 20);
}

}  // namespace
}  // namespace sonde
