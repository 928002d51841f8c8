// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/distinct.hpp"

#include <gtest/gtest.h>

#include "engine/geometry/topology.hpp"
#include "tests/engine/geometry/soup_of.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

TEST(Distinct, what_is_written_twice_stays_once) {
  const PolygonSoup one = test::icosphere(1, 1);
  const Soup soup = test::welded(test::joined(one, one));
  const Distinct distinct = find_distinct(soup);
  EXPECT_EQ(distinct.repeated, 80u);
  for (std::uint32_t i = 0; i < 80; ++i) {
    EXPECT_EQ(distinct.by[i], i);
    EXPECT_EQ(distinct.by[80 + i], i);
    EXPECT_FALSE(distinct.backs[80 + i]);
  }
}

TEST(Distinct, of_both_sides_one_stays_and_the_other_is_its_back) {
  const PolygonSoup one = test::torus(1, 0.3, 6, 5);
  const Soup soup = test::welded(test::joined(one, test::turned_over(one)));
  const Distinct distinct = find_distinct(soup);
  EXPECT_EQ(distinct.repeated, 60u);
  for (std::uint32_t i = 0; i < 120; ++i) EXPECT_EQ(distinct.backs[i], i >= 60);
}

TEST(Distinct, a_wall_between_two_boxes_cancels_out) {
  const Soup soup =
      test::welded(test::joined(test::box({1, 1, 1}), test::box({1, 1, 1}), {1, 0, 0}));
  ASSERT_EQ(analyse_topology(soup).duplicate_triangles, 2u);
  const Distinct distinct = find_distinct(soup);
  EXPECT_EQ(std::count(distinct.by.begin(), distinct.by.end(), Distinct::none), 4);
  EXPECT_EQ(distinct.repeated, 4u);
}

TEST(Distinct, each_component_is_counted_by_itself) {
  const PolygonSoup once = test::box({1, 1, 1}), twice = test::tetrahedron(1);
  const Soup soup = test::welded(test::joined(once, test::joined(twice, twice), {5, 0, 0}));
  const Distinct distinct = find_distinct(soup);
  EXPECT_EQ(distinct.repeated, 4u);
  for (std::uint32_t i = 0; i < 12; ++i) EXPECT_EQ(distinct.by[i], i);
}

}  // namespace
}  // namespace sonde
