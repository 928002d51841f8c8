// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/edge_uses.hpp"

#include <gtest/gtest.h>

#include "tests/engine/geometry/soup_of.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

// Reference: Euler's formula; a closed mesh of F triangles has 3F/2 edges.
TEST(EdgeUses, of_a_closed_mesh_come_in_pairs_that_go_both_ways) {
  const Soup soup = test::soup_of(test::torus(1, 0.3, 12, 9));
  const auto uses = edge_uses(soup);
  std::size_t edges = 0;
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    ++edges;
    ASSERT_EQ(edge.size(), 2u);
    EXPECT_NE(edge[0].down, edge[1].down);
    EXPECT_LT(edge[0].side, edge[1].side);
    for (const EdgeUse& use : edge) {
      const Triangle& t = soup.triangles[use.triangle()];
      const std::uint32_t from = t[use.side % 3], to = t[(use.side + 1) % 3];
      EXPECT_EQ(use.down ? use.high : use.low, from);
      EXPECT_EQ(use.down ? use.low : use.high, to);
    }
  });
  EXPECT_EQ(edges, soup.triangles.size() * 3 / 2);
}

TEST(EdgeUses, triangles_that_collapse_have_none) {
  const Soup soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 1}, {0, 1, 2}}};
  EXPECT_EQ(edge_uses(soup).size(), 3u);
}

}  // namespace
}  // namespace sonde
