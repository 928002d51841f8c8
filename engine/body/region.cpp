// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/body/region.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>

namespace sonde {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
constexpr int unknown = -1;
struct Depth {
  int value = unknown;  ///< number of segments between a place and the outside
};
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Face = CGAL::Constrained_triangulation_face_base_2<
    Kernel, CGAL::Triangulation_face_base_with_info_2<Depth, Kernel>>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel,
                                               CGAL::Triangulation_data_structure_2<Vertex, Face>,
                                               CGAL::No_constraint_intersection_tag>;

void mark_depths(Triangulation& triangulation) {
  std::vector<Triangulation::Face_handle> level{triangulation.infinite_face()}, next;
  for (int depth = 0; !level.empty(); ++depth, level.swap(next), next.clear())
    while (!level.empty()) {
      const Triangulation::Face_handle face = level.back();
      level.pop_back();
      if (face->info().value != unknown) continue;
      face->info().value = depth;
      for (int k = 0; k < 3; ++k) {
        const Triangulation::Face_handle other = face->neighbor(k);
        if (other->info().value != unknown) continue;
        (triangulation.is_constrained({face, k}) ? next : level).push_back(other);
      }
    }
}

/// False if a segment passes through a point, or along another one: CGAL then splits it.
bool has_whole(const Triangulation& triangulation, const PlanarRegion& region,
               const std::vector<Triangulation::Vertex_handle>& vertices) {
  for (const auto& [a, b] : region.outline)
    if (!triangulation.is_edge(vertices[a], vertices[b])) return false;
  const auto edges = triangulation.finite_edges();
  const auto constrained = std::count_if(edges.begin(), edges.end(), [&](const auto& edge) {
    return triangulation.is_constrained(edge);
  });
  return static_cast<std::size_t>(constrained) == region.outline.size();
}

}  // namespace

std::optional<std::vector<std::array<std::uint32_t, 3>>> triangulate(const PlanarRegion& region) {
  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> vertices;
  vertices.reserve(region.points.size());
  for (std::uint32_t i = 0; i < region.points.size(); ++i) {
    const auto& [x, y] = region.points[i];
    vertices.push_back(triangulation.insert({x, y}));
    vertices.back()->info() = i;
  }
  if (triangulation.number_of_vertices() != region.points.size()) return std::nullopt;
  try {
    for (const auto& [a, b] : region.outline)
      triangulation.insert_constraint(vertices[a], vertices[b]);
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    return std::nullopt;
  }
  if (triangulation.dimension() < 2) return std::nullopt;  // all on a line: there is no triangle
  if (!has_whole(triangulation, region, vertices)) return std::nullopt;
  mark_depths(triangulation);
  std::vector<std::array<std::uint32_t, 3>> out;
  for (const auto face : triangulation.finite_face_handles())
    if (face->info().value % 2 == 1)
      out.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  return out;
}

}  // namespace sonde
