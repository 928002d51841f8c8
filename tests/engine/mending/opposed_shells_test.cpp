// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/opposed_shells.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/geometry/topology.hpp"
#include "engine/mending/distinct.hpp"
#include "tests/engine/geometry/soup_of.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

/// Triangles that stay, of those from `first` on.
std::size_t staying(const PolygonSoup& mesh, std::size_t first = 0) {
  const Distinct distinct = find_distinct(test::welded(mesh));
  std::size_t count = 0;
  for (std::size_t i = first; i < distinct.by.size(); ++i) count += distinct.by[i] == i;
  return count;
}

TEST(OpposedShells, within_another_body_none_of_it_stays) {
  for (const PolygonSoup& inner : {test::icosphere(0.4, 1), test::torus(0.3, 0.1, 6, 5)}) {
    const PolygonSoup outer = test::triangulated(test::box({1, 1, 1}));
    const PolygonSoup both = test::joined(inner, test::turned_over(inner));
    EXPECT_EQ(staying(test::joined(outer, both), 12), 0u);
    EXPECT_EQ(staying(test::joined(test::turned_over(outer), both), 12), 0u);
    // It crosses the wall: it is a body there, on one side at least.
    EXPECT_EQ(staying(test::joined(outer, both, {0.5, 0, 0}), 12), inner.polygons.size());
    // What surrounds it is open.
    PolygonSoup open = outer;
    open.polygons.resize(6);
    EXPECT_EQ(staying(test::joined(open, both), 6), inner.polygons.size());
    // All is there both ways round: so the file was written.
    EXPECT_EQ(staying(test::joined(test::joined(outer, test::turned_over(outer)), both)),
              outer.polygons.size() + inner.polygons.size());
  }
}

// The face that they share becomes a wall between the two.
TEST(OpposedShells, a_neighbour_stays_once_but_for_the_shared_face) {
  const PolygonSoup box = test::triangulated(test::box({1, 1, 1})),
                    next = test::placed(box, {1, 0, 0});
  const PolygonSoup all = test::joined(test::joined(box, next), test::turned_over(next));
  EXPECT_EQ(staying(all), 20u);
  // Written three times each.
  EXPECT_EQ(staying(test::joined(test::joined(all, all), all)), 20u);
}

}  // namespace
}  // namespace sonde
