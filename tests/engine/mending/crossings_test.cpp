// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/crossings.hpp"

#include <gtest/gtest.h>

#include "tests/engine/geometry/soup_of.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using Box = Eigen::AlignedBox3d;

/// One empty box where looking takes too long.
std::vector<Box> crossings(const std::vector<PolygonSoup>& parts, std::size_t most = 1'000'000) {
  PolygonSoup all;
  std::vector<std::uint32_t> part;
  for (std::uint32_t p = 0; p < parts.size(); ++p) {
    all = p == 0 ? parts[p] : test::joined(all, parts[p]);
    part.resize(test::soup_of(all).triangles.size(), p);
  }
  const Crossings found = find_crossings(test::soup_of(all), part, {}, most);
  return found.complete ? found.boxes : std::vector<Box>{Box{}};
}

void expect_box(const Box& box, const Vec3& low, const Vec3& high) {
  EXPECT_LT((box.min() - low).norm(), 1e-12);
  EXPECT_LT((box.max() - high).norm(), 1e-12);
}

// Reference: by hand, what two boxes have in common.
TEST(Crossings, are_what_parts_have_in_common) {
  const PolygonSoup rod = test::box({1, 0.02, 0.01}), post = test::box({0.01, 0.02, 1});
  const auto of_rods = crossings({rod, test::placed(post, {0.1, 0.01, 0})});
  ASSERT_EQ(of_rods.size(), 1u);
  expect_box(of_rods[0], {0.095, 0, -0.005}, {0.105, 0.01, 0.005});
  // An end inside: its corners are in the box.
  const auto of_end = crossings({test::box({1, 1, 1}), test::placed(rod, {0.9, 0, 0})});
  ASSERT_EQ(of_end.size(), 1u);
  expect_box(of_end[0], {0.4, -0.01, -0.005}, {0.5, 0.01, 0.005});
  // Two places apart, and two that are one.
  EXPECT_EQ(
      crossings({rod, test::placed(post, {0.3, 0, 0}), test::placed(post, {-0.3, 0, 0})}).size(),
      2u);
  EXPECT_EQ(crossings({rod, post, test::placed(post, {0.005, 0, 0})}).size(), 3u);
}

TEST(Crossings, are_none_of_parts_that_are_apart_or_inside_and_none_beyond_the_limit) {
  const PolygonSoup cube = test::box({1, 1, 1}), small = test::box({0.1, 0.1, 0.1});
  EXPECT_TRUE(crossings({cube}).empty());
  EXPECT_TRUE(crossings({cube, small}).empty());
  EXPECT_TRUE(crossings({cube, test::turned_over(small)}).empty());
  EXPECT_TRUE(crossings({cube, test::placed(cube, {1, 0, 0})}).empty()) << "they touch";
  EXPECT_TRUE(crossings({cube, test::placed(cube, {3, 0, 0})}).empty());
  EXPECT_EQ(crossings({cube, test::placed(small, {0.5, 0, 0})}).size(), 1u);
  const auto stopped = crossings({cube, test::placed(small, {0.5, 0, 0})}, 20);
  ASSERT_EQ(stopped.size(), 1u);
  EXPECT_TRUE(stopped[0].isEmpty());
}

}  // namespace
}  // namespace sonde
