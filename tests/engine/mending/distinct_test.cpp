// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/distinct.hpp"

#include <gtest/gtest.h>

#include <algorithm>

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

// By accident, one triangle or a patch of some: what closes the mesh is one of each.
TEST(Distinct, what_is_repeated_by_accident_stays_once) {
  for (const PolygonSoup& mesh :
       {test::icosphere(1, 0), test::icosphere(1, 2), test::torus(1, 0.3, 7, 6)})
    for (const bool turned : {false, true})
      for (const std::vector<std::size_t>& which :
           {std::vector<std::size_t>{3}, {0, 1, 2, 3, 4, 5}, {2, 9}}) {
        const Soup once = test::welded(mesh),
                   soup = test::welded(test::repeated(mesh, which, turned));
        const std::size_t more = soup.triangles.size() - once.triangles.size();
        const Distinct distinct = find_distinct(soup);
        EXPECT_EQ(distinct.repeated, more);
        for (std::uint32_t i = 0; i < soup.triangles.size(); ++i) {
          EXPECT_EQ(distinct.by[i] == i, i < once.triangles.size());
          EXPECT_EQ(distinct.backs[i], i >= once.triangles.size());
        }
      }
}

// A lid with two sides closes an open box; a fin with two sides stays none of it.
TEST(Distinct, a_lid_of_two_sides_closes_and_a_fin_does_not) {
  const PolygonSoup box = test::box({1, 1, 1});
  const std::size_t lid = box.polygons.size() - 1;
  const Distinct closed = find_distinct(test::welded(test::repeated(box, {lid}, true)));
  EXPECT_EQ(std::count(closed.by.begin(), closed.by.end(), Distinct::none), 0);
  PolygonSoup finned = box;
  const std::size_t tip = finned.points.size();
  finned.points.push_back({3, 0, 0});
  finned.polygons.push_back({box.polygons[0][0], box.polygons[0][1], tip});
  finned.polygons.push_back({box.polygons[0][1], box.polygons[0][0], tip});
  const Distinct with_fin = find_distinct(test::welded(finned));
  EXPECT_EQ(std::count(with_fin.by.begin(), with_fin.by.end(), Distinct::none), 2);
}

}  // namespace
}  // namespace sonde
