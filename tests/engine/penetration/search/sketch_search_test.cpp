// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/sketch_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

std::vector<SketchEnd> search(const Body& a, const Body& b, const Pose& X, bool two_threads,
                              Method method = Method::pdg) {
  const Sketches sketches = make_sketches(a, b);
  std::vector<SketchDescent> lanes;
  for (int lane = 0; lane < 2; ++lane) lanes.emplace_back(*sketches.probe, *sketches.fixed, b.mass);
  ThreadPair threads(two_threads);
  const Chart chart(a.mass, X);
  SketchSearch search(chart, {.method = method}, lanes, threads);
  search.make_starts(96, 8);
  return search.ends();
}

// Reference: by translation alone a box leaves a larger one by the nearest face.
TEST(SketchSearch, a_box_leaves_a_box_by_the_nearest_face) {
  const auto small = test::body(test::box({0.1, 0.1, 0.1}));
  const auto large = test::body(test::box({0.4, 0.4, 0.3}));
  const auto ends =
      search(*small, *large, {Quat::Identity(), Vec3(0.02, 0.01, 0.03)}, false, Method::pdt);
  ASSERT_FALSE(ends.empty());
  EXPECT_NEAR(ends.front().depth, 0.15 + 0.05 - 0.03, 0.004);
  EXPECT_LT((ends.front().y.tail<3>() - Vec3(0, 0, 0.17)).norm(), 0.02);
  EXPECT_GE(ends.front().starts, 2);
  EXPECT_TRUE(std::ranges::is_sorted(ends, {}, &SketchEnd::depth));
}

// What it comes to does not depend on whether it is made at once, and more starts never lose an
// end.
TEST(SketchSearch, goes_on_where_it_stopped) {
  const auto ring = test::body(test::torus(0.08, 0.03, 24, 16));
  const auto knot = test::body(test::torus_knot(2, 3, 0.06, 0.025, 0.015, 30, 8));
  const Chart chart(ring->mass, Pose{Quat(0.8, 0.2, -0.5, 0.1).normalized(), {0.01, 0.02, -0.01}});
  const Sketches sketches = make_sketches(*ring, *knot);
  std::vector<SketchDescent> lanes;
  for (int lane = 0; lane < 2; ++lane)
    lanes.emplace_back(*sketches.probe, *sketches.fixed, knot->mass);
  ThreadPair threads(false);
  SketchSearch at_once(chart, {}, lanes, threads), in_parts(chart, {}, lanes, threads);
  at_once.make_starts(64);
  double before = std::numeric_limits<double>::infinity();
  for (int made = 8; made <= 64; made += 8) {
    in_parts.make_starts(made);
    EXPECT_EQ(in_parts.made(), made);
    ASSERT_FALSE(in_parts.ends().empty());
    EXPECT_LE(in_parts.ends().front().depth, before);
    before = in_parts.ends().front().depth;
  }
  ASSERT_EQ(at_once.ends().size(), in_parts.ends().size());
  for (std::size_t i = 0; i < at_once.ends().size(); ++i)
    EXPECT_EQ(at_once.ends()[i].y, in_parts.ends()[i].y);
}

TEST(SketchSearch, two_threads_give_the_same_bits) {
  const auto ring = test::body(test::torus(0.08, 0.03, 24, 16));
  const auto knot = test::body(test::torus_knot(2, 3, 0.06, 0.025, 0.015, 30, 8));
  const Pose X{Quat(0.8, 0.2, -0.5, 0.1).normalized(), Vec3(0.01, 0.02, -0.01)};
  const auto one = search(*ring, *knot, X, false), two = search(*ring, *knot, X, true);
  ASSERT_FALSE(one.empty());
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].y, two[i].y);
    EXPECT_EQ(one[i].starts, two[i].starts);
  }
}

}  // namespace
}  // namespace sonde
