// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/queries/self_intersections.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <numbers>
#include <set>
#include <utility>

#include "engine/base/error.hpp"

namespace sonde {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// A closed tube of n × m vertices along a trefoil: wider than the knot leaves room for, it crosses
/// itself.
Soup tube(std::uint32_t n, std::uint32_t m, double radius) {
  Soup soup;
  const auto centre = [](double t) {
    return Vec3(std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t),
                -std::sin(3 * t));
  };
  for (std::uint32_t i = 0; i < n; ++i) {
    const double t = 2 * std::numbers::pi * i / n;
    const Vec3 along = (centre(t + 1e-4) - centre(t - 1e-4)).normalized();
    const Vec3 u = along.cross(Vec3(0.1, 0.2, 1)).normalized(), v = along.cross(u);
    for (std::uint32_t j = 0; j < m; ++j) {
      const double s = 2 * std::numbers::pi * j / m;
      soup.vertices.push_back(centre(t) + radius * (std::cos(s) * u + std::sin(s) * v));
    }
  }
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return (i % n) * m + j % m; };
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < m; ++j) {
      soup.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      soup.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return soup;
}

/// CGAL's own answer, on a halfedge mesh, which it wants to be a manifold.
struct Reference {
  std::set<std::uint32_t> triangles;
  std::size_t pairs = 0;
};
Reference reference(const Soup& soup) {
  SurfaceMesh mesh;
  for (const Vec3& x : soup.vertices) mesh.add_vertex({x.x(), x.y(), x.z()});
  const auto corner = [](std::uint32_t i) { return SurfaceMesh::Vertex_index(i); };
  for (const Triangle& t : soup.triangles)
    EXPECT_NE(mesh.add_face(corner(t[0]), corner(t[1]), corner(t[2])), SurfaceMesh::null_face());
  std::vector<std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
  Reference found;
  for (const auto& [a, b] : pairs) {
    found.triangles.insert(a);
    found.triangles.insert(b);
  }
  found.pairs = pairs.size();
  return found;
}

TEST(SelfIntersections, finds_what_cgal_finds_in_manifolds) {
  for (const double radius : {0.3, 0.9, 1.2, 2.5}) {
    SCOPED_TRACE(radius);
    const Soup soup = tube(90, 14, radius);
    const Reference expected = reference(soup);
    const SelfIntersections found = self_intersections(soup);
    EXPECT_EQ(found.pairs, expected.pairs);
    EXPECT_EQ(std::set<std::uint32_t>(found.triangles.begin(), found.triangles.end()),
              expected.triangles);
    EXPECT_TRUE(found.all);
    EXPECT_EQ(found.pairs > 0, radius > 0.5) << "both kinds are here";
  }
}

TEST(SelfIntersections, knows_what_neighbours_may_share) {
  Soup soup;
  soup.vertices = {{0, 0, 0},     {1, 0, 0},      {0, 1, 0}, {1, 1, 0},
                   {0.2, 0.2, 1}, {0.2, 0.2, -1}, {2, 0, 0}};
  const auto pairs = [&](const Triangle& a, const Triangle& b) {
    soup.triangles = {a, b};
    return self_intersections(soup).pairs;
  };
  EXPECT_EQ(pairs({0, 1, 2}, {1, 3, 2}), 0u) << "an edge between them";
  EXPECT_EQ(pairs({0, 1, 2}, {0, 1, 3}), 1u) << "folded onto each other over an edge";
  EXPECT_EQ(pairs({0, 1, 2}, {0, 1, 4}), 0u) << "folded, at an angle";
  EXPECT_EQ(pairs({0, 1, 2}, {1, 6, 3}), 0u) << "a corner between them";
  EXPECT_EQ(pairs({0, 1, 2}, {0, 4, 5}), 1u) << "a corner between them, and a line";
  EXPECT_EQ(pairs({0, 1, 2}, {2, 0, 1}), 0u) << "the same again is no crossing";
  EXPECT_EQ(pairs({0, 1, 2}, {4, 5, 6}), 1u);
}

TEST(SelfIntersections, ends_where_it_is_told_to) {
  const Soup soup = tube(90, 14, 1.2);
  EXPECT_THROW(self_intersections(soup, [](double) { return false; }), Cancelled);
  const SelfIntersections few = self_intersections(soup, {}, 5);
  EXPECT_EQ(few.pairs, 5u);
  EXPECT_FALSE(few.all);
  EXPECT_TRUE(self_intersections(Soup{}).triangles.empty());
}

}  // namespace
}  // namespace sonde
