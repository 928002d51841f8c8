// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/contact/separating_directions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "engine/penetration/contact/contact_tuning.hpp"
#include "tests/support/exact_reference.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

constexpr double any_overlap = -std::numeric_limits<double>::infinity();

Corners shifted_corners(Corners t, const Vec3& by) {
  for (Vec3& x : t) x += by;
  return t;
}
Corners random_corners(std::mt19937_64& random, double size) {
  return {test::random_in_ball(random, size), test::random_in_ball(random, size),
          test::random_in_ball(random, size)};
}
std::optional<std::vector<Vec3>> directions_of(const std::vector<TouchingPair>& pairs, bool solid,
                                               double slack) {
  return separating_directions(pairs, solid, solid, slack);
}

/// In the plane z = 0, counter-clockwise seen from above.
const Corners flat_triangle{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
Corners seen_from_below(const Corners& t) { return {t[0], t[2], t[1]}; }

TEST(SeparatingDirections, a_pair_has_the_unit_normals_of_its_corners) {
  const TouchingPair pair =
      touching_pair(flat_triangle, {Vec3(0, 0, 0), Vec3(0, 0, 1e-200), Vec3(0, 1e-200, 0)});
  EXPECT_EQ(pair.face_a, Vec3(Vec3::UnitZ()));
  EXPECT_EQ(pair.a, flat_triangle);
  EXPECT_EQ(touching_pair(seen_from_below(flat_triangle), flat_triangle).face_a,
            Vec3(-Vec3::UnitZ()));
}

// Reference: exact predicates (CGAL). Two triangles meet after any displacement shorter than their
// overlap, and are apart after one that is a little longer, along the direction that is found.
TEST(SeparatingDirections, the_overlap_is_the_shortest_displacement_that_separates) {
  std::mt19937_64 random(1);
  int meeting = 0;
  for (int i = 0; i < 600; ++i) {
    const Corners a = random_corners(random, 1), b = random_corners(random, 1);
    const TouchingPair pair = touching_pair(a, b);
    const double overlap = overlap_of(pair, any_overlap);
    ASSERT_EQ(overlap >= 0, test::meet_by_edges(a, b)) << i;
    const auto found = directions_of({pair}, false, overlap + 1e-12);
    ASSERT_TRUE(found) << i;
    const Vec3 n = found->front();
    EXPECT_NEAR(n.norm(), 1, 1e-15);
    EXPECT_NEAR(-test::exact_gap_along(n, a, b), overlap, 2e-12) << i;
    if (overlap < 0) continue;
    ++meeting;
    EXPECT_FALSE(directions_of({pair}, false, overlap - 1e-12)) << i;
    EXPECT_FALSE(test::meet_by_edges(shifted_corners(a, (overlap + 1e-9) * n), b)) << i;
    for (int k = 0; k < 8; ++k) {
      const Vec3 by = test::random_in_ball(random, 0.999 * overlap);
      EXPECT_TRUE(test::meet_by_edges(shifted_corners(a, by), b)) << i;
    }
  }
  EXPECT_GT(meeting, 100);
}

// Reference: by hand. A corner 0.25 deep in a face, half-way along: any other way out is longer.
TEST(SeparatingDirections, an_overlap_that_is_enough_may_be_any_that_is_no_more) {
  const Corners tip{Vec3(0, 0, -0.25), Vec3(2, 0.5, 7), Vec3(-2, 0.5, 7)};
  const Corners floor{Vec3(-9, -9, 0), Vec3(9, -9, 0), Vec3(0, 9, 0)};
  const TouchingPair pair = touching_pair(tip, floor);
  EXPECT_NEAR(overlap_of(pair, any_overlap), 0.25, 1e-15);
  EXPECT_NEAR(overlap_of(pair, 0.1), 0.25, 1e-15);
  const double early = overlap_of(pair, 5);
  EXPECT_GE(early, 0.25);
  EXPECT_LE(early, 5);
  // Of faces that may both serve, the one that takes less.
  EXPECT_EQ(directions_of({pair}, false, 50)->front(), Vec3(Vec3::UnitZ()));
}

TEST(SeparatingDirections, coplanar_triangles_part_towards_the_outside_of_solids) {
  const Corners under = shifted_corners(flat_triangle, {0.125, 0.125, 0});
  const auto pair = [&](bool a_up, bool b_up) {
    return touching_pair(a_up ? flat_triangle : seen_from_below(flat_triangle),
                         b_up ? under : seen_from_below(under));
  };
  const auto down_on_up = directions_of({pair(false, true)}, true, 1e-9);
  ASSERT_TRUE(down_on_up);
  EXPECT_EQ(down_on_up->front(), Vec3(Vec3::UnitZ()));
  const auto up_on_down = directions_of({pair(true, false)}, true, 1e-9);
  ASSERT_TRUE(up_on_down);
  EXPECT_EQ(up_on_down->front(), Vec3(-Vec3::UnitZ()));
  // Of two that look the same way, one is in the material of the other.
  EXPECT_FALSE(directions_of({pair(true, true)}, true, 1e-9));
  EXPECT_FALSE(directions_of({pair(false, false)}, true, 1e-9));
  EXPECT_TRUE(directions_of({pair(true, true)}, false, 1e-9));
  // One solid alone decides: A must not go along its own normal, nor B be left against its own.
  const std::vector<TouchingPair> up{pair(true, true)};
  EXPECT_EQ(separating_directions(up, true, false, 1e-9)->front(), Vec3(-Vec3::UnitZ()));
  EXPECT_EQ(separating_directions(up, false, true, 1e-9)->front(), Vec3(Vec3::UnitZ()));
}

// Reference: by hand. Beside each other in one plane, with no room above or below (both look up),
// they part across the edge that they share.
TEST(SeparatingDirections, coplanar_triangles_side_by_side_part_across_their_edge) {
  const Corners left{Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(-1, 0, 0)};
  const Corners corner_at_it{Vec3(0, 0.5, 0), Vec3(1, 0, 0), Vec3(1.5, 1.5, 0)};
  for (const Corners& a : {flat_triangle, corner_at_it}) {
    const auto found = directions_of({touching_pair(a, left)}, true, 1e-9);
    ASSERT_TRUE(found);
    EXPECT_LT((found->front() - Vec3::UnitX()).norm(), 1e-12);
    const auto other = directions_of({touching_pair(left, a)}, true, 1e-9);
    ASSERT_TRUE(other);
    EXPECT_LT((other->front() + Vec3::UnitX()).norm(), 1e-12);
    const Corners away = shifted_corners(a, {0.5, 0, 0});
    EXPECT_NEAR(overlap_of(touching_pair(away, left), any_overlap), -0.5, 1e-15);
    EXPECT_NEAR(overlap_of(touching_pair(left, away), any_overlap), -0.5, 1e-15);
  }
}

/// The pairs of triangles of two boxes, the one above the other by `up`, that meet.
std::vector<TouchingPair> stacked_pairs(const Vec3& upper, const Vec3& lower, const Vec3& by) {
  const auto a = test::body(test::box(upper)), b = test::body(test::box(lower));
  const Transform X(Mat3::Identity(), by);
  std::vector<TouchingPair> out;
  for (const Corners& s : test::placed_triangles(*a, X))
    for (const Corners& t : test::placed_triangles(*b, Transform()))
      if (test::meet_by_edges(s, t)) out.push_back(touching_pair(s, t));
  return out;
}

// Reference: by hand; coordinates are multiples of 1/16, so that contacts are exact. Boxes that
// stand on each other, flat, over an edge, flush with a side, or with their edges on each other.
TEST(SeparatingDirections, all_pairs_of_a_box_that_stands_on_another_go_up) {
  for (const Vec3& by : {Vec3(0.25, 0.125, 1), Vec3(0.75, 0.125, 1), Vec3(0.5, 0.25, 1),
                         Vec3(0, 0, 1), Vec3(0.75, 0.75, 1)}) {
    const std::vector<TouchingPair> pairs = stacked_pairs({0.5, 0.5, 1}, {1, 1, 1}, by);
    ASSERT_GT(pairs.size(), 5u) << by.transpose();
    const auto found = directions_of(pairs, true, 1e-12);
    ASSERT_TRUE(found) << by.transpose();
    ASSERT_EQ(found->size(), pairs.size());
    for (const Vec3& n : *found) EXPECT_EQ(n, Vec3(Vec3::UnitZ())) << by.transpose();
  }
}

// Reference: by hand. A box in a corner of floor and wall touches both: two directions.
TEST(SeparatingDirections, a_box_in_a_corner_has_a_direction_for_each_wall) {
  std::vector<TouchingPair> pairs = stacked_pairs({1, 1, 1}, {4, 4, 1}, {0, 0, 1});
  const std::size_t on_floor = pairs.size();
  for (const TouchingPair& p : stacked_pairs({1, 1, 1}, {1, 4, 4}, {1, 0, 1})) pairs.push_back(p);
  ASSERT_GT(pairs.size(), on_floor);
  const auto found = directions_of(pairs, true, 1e-12);
  ASSERT_TRUE(found);
  std::set<std::vector<double>> different;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Vec3& n = (*found)[i];
    EXPECT_GE(test::exact_gap_along(n, pairs[i].a, pairs[i].b), -1e-12);
    different.insert({n.x(), n.y(), n.z()});
  }
  EXPECT_EQ(different, (std::set<std::vector<double>>{{0, 0, 1}, {1, 0, 0}}));
}

TEST(SeparatingDirections, without_pairs_there_is_nothing_to_find) {
  const auto found = directions_of({}, true, 0);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->empty());
}

}  // namespace
}  // namespace sonde
