// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/defect_edges.hpp"

#include <gtest/gtest.h>

#include <random>

#include "engine/geometry/topology.hpp"

namespace sonde {
namespace {

Soup tetrahedron() {
  return {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)},
          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

TEST(DefectEdges, a_closed_mesh_has_none) {
  const DefectEdges found = defect_edges(tetrahedron());
  EXPECT_TRUE(found.open.empty());
  EXPECT_TRUE(found.flipped.empty());
}

TEST(DefectEdges, a_missing_triangle_leaves_its_three_edges_open) {
  Soup soup = tetrahedron();
  soup.triangles.pop_back();
  const DefectEdges found = defect_edges(soup);
  EXPECT_EQ(found.open, (std::vector<DefectEdges::Edge>{{1, 2}, {1, 3}, {2, 3}}));
  EXPECT_TRUE(found.flipped.empty());
}

TEST(DefectEdges, a_turned_triangle_disagrees_at_its_three_edges) {
  Soup soup = tetrahedron();
  std::swap(soup.triangles[3][0], soup.triangles[3][1]);
  const DefectEdges found = defect_edges(soup);
  EXPECT_TRUE(found.open.empty());
  EXPECT_EQ(found.flipped, (std::vector<DefectEdges::Edge>{{1, 2}, {1, 3}, {2, 3}}));
}

/// The reference is the count that decides what is solid, which is made in another way.
TEST(DefectEdges, are_as_many_as_the_topology_counts) {
  std::mt19937 random(5);
  for (int round = 0; round < 50; ++round) {
    Soup soup;
    for (int i = 0; i < 12; ++i) soup.vertices.push_back(Vec3::Random());
    std::uniform_int_distribution<std::uint32_t> vertex(0, 11);
    while (soup.triangles.size() < 30) {
      const Triangle t{vertex(random), vertex(random), vertex(random)};
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) soup.triangles.push_back(t);
    }
    const Topology counted = analyse_topology(soup);
    const DefectEdges found = defect_edges(soup);
    EXPECT_EQ(found.open.size(), counted.open_edges);
    EXPECT_EQ(found.flipped.size(), counted.misoriented_edges);
  }
}

}  // namespace
}  // namespace sonde
