// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/topology.hpp"

#include <gtest/gtest.h>

#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

Soup soup_of(const PolygonSoup& polygons) { return triangulate(polygons).soup; }

Soup joined(Soup a, const Soup& b, const Vec3& by = Vec3::Zero()) {
  const auto at = static_cast<std::uint32_t>(a.vertices.size());
  for (const Vec3& x : b.vertices) a.vertices.push_back(x + by);
  for (const Triangle& t : b.triangles) a.triangles.push_back({t[0] + at, t[1] + at, t[2] + at});
  return a;
}

/// Each triangle with corners of its own, as STL has them.
Soup corner_by_corner(const Soup& soup) {
  Soup out;
  for (const Triangle& t : soup.triangles) {
    const auto at = static_cast<std::uint32_t>(out.vertices.size());
    for (const std::uint32_t v : t) out.vertices.push_back(soup.vertices[v]);
    out.triangles.push_back({at, at + 1, at + 2});
  }
  return out;
}

TEST(Topology, ClosedShapes) {
  for (const PolygonSoup& shape : {test::box({1, 2, 3}), test::torus(1, 0.3, 8, 6),
                                   test::sphere(1, 5, 7), test::tetrahedron(1)}) {
    const Topology t = analyse_topology(soup_of(shape));
    EXPECT_TRUE(t.closed);
    EXPECT_EQ(t.components, 1u);
    EXPECT_EQ(t.open_edges + t.nonmanifold_edges + t.misoriented_edges + t.duplicate_triangles, 0u);
  }
}

TEST(Topology, ClosedCornerByCorner) {
  Soup soup = corner_by_corner(soup_of(test::box({1, 2, 3})));
  EXPECT_TRUE(analyse_topology(soup).closed);
  EXPECT_EQ(analyse_topology(soup).components, 1u);
}

TEST(Topology, TheTwoZerosAreOne) {
  Soup soup = corner_by_corner(soup_of(test::box({2, 2, 2})));
  int k = 0;
  for (Vec3& x : soup.vertices) {
    x += Vec3::Ones();
    for (double& c : x)
      if (c == 0 && ++k % 2) c = -0.0;
  }
  EXPECT_TRUE(analyse_topology(soup).closed);
}

TEST(Topology, AMissingFaceOpensItsEdges) {
  PolygonSoup box = test::box({1, 1, 1});
  box.polygons.pop_back();
  const Topology t = analyse_topology(soup_of(box));
  EXPECT_FALSE(t.closed);
  EXPECT_EQ(t.open_edges, 4u);
  EXPECT_EQ(t.misoriented_edges, 0u);
}

TEST(Topology, ATurnedFaceIsMisoriented) {
  PolygonSoup box = test::box({1, 1, 1});
  std::reverse(box.polygons[2].begin(), box.polygons[2].end());
  const Topology t = analyse_topology(soup_of(box));
  EXPECT_FALSE(t.closed);
  EXPECT_EQ(t.open_edges, 0u);
  EXPECT_EQ(t.misoriented_edges, 4u);
}

TEST(Topology, AMoebiusBandIsOpen) {
  Soup soup;
  const int n = 10;
  for (int i = 0; i < n; ++i)
    for (const double side : {-0.3, 0.3}) {
      const double a = 2 * M_PI * i / n;
      const double r = 1 + side * std::cos(a / 2);
      soup.vertices.push_back({r * std::cos(a), r * std::sin(a), side * std::sin(a / 2)});
    }
  for (std::uint32_t i = 0; i < n; ++i) {
    const bool last = i + 1 == n;  // joined with a half turn
    const std::uint32_t a = 2 * i, b = a + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    soup.triangles.push_back({a, c, b});
    soup.triangles.push_back({b, c, d});
  }
  const Topology t = analyse_topology(soup);
  EXPECT_EQ(t.open_edges, 2u * n);
  EXPECT_EQ(t.misoriented_edges, 1u);
}

TEST(Topology, DuplicatesOfAClosedMeshStayClosed) {
  const Soup box = soup_of(test::box({1, 1, 1}));
  const Topology t = analyse_topology(joined(box, box));
  EXPECT_TRUE(t.closed);
  EXPECT_EQ(t.duplicate_triangles, 12u);
  EXPECT_EQ(t.nonmanifold_edges, 18u);
  EXPECT_EQ(t.components, 1u);
}

TEST(Topology, ThreeTrianglesAtAnEdge) {
  Soup soup;
  soup.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  soup.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  const Topology t = analyse_topology(soup);
  EXPECT_EQ(t.nonmanifold_edges, 1u);
  EXPECT_EQ(t.misoriented_edges, 1u);
  EXPECT_EQ(t.open_edges, 6u);
  EXPECT_FALSE(t.closed);
}

TEST(Topology, Components) {
  const Soup box = soup_of(test::box({1, 1, 1}));
  const Topology apart = analyse_topology(joined(box, box, {3, 0, 0}));
  EXPECT_TRUE(apart.closed);
  EXPECT_EQ(apart.components, 2u);
  ASSERT_EQ(apart.component_of.size(), 24u);
  for (std::size_t i = 0; i < 24; ++i) EXPECT_EQ(apart.component_of[i], i / 12);
  EXPECT_EQ(analyse_topology(joined(box, box, {1, 1, 1})).components, 1u);  // share one vertex
}

TEST(Topology, CollapsedTrianglesDoNotOpenAMesh) {
  Soup soup = soup_of(test::box({1, 1, 1}));
  soup.triangles.push_back({0, 0, 1});
  soup.triangles.push_back({3, 3, 3});
  EXPECT_TRUE(analyse_topology(soup).closed);
  EXPECT_EQ(analyse_topology(soup).component_of.size(), 14u);
}

TEST(Topology, NothingIsNotClosed) {
  EXPECT_FALSE(analyse_topology(Soup()).closed);
  EXPECT_EQ(analyse_topology(Soup()).components, 0u);
}

TEST(Topology, WeldNamesTheFirst) {
  EXPECT_EQ(weld({{1, 2, 3}, {0, 0, 0}, {1, 2, 3}, {-0.0, 0, -0.0}, {1, 2, 3.0000000000000004}}),
            (std::vector<std::uint32_t>{0, 1, 0, 1, 4}));
}

}  // namespace
}  // namespace sonde
