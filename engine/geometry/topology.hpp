// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {

/// How the triangles of a soup meet at their edges.
struct Topology {
  std::size_t open_edges = 0;         ///< edges used by one triangle only
  std::size_t nonmanifold_edges = 0;  ///< edges used by three triangles or more
  /// Edges of two triangles or more whose uses in the two directions do not balance.
  std::size_t misoriented_edges = 0;
  std::size_t duplicate_triangles = 0;
  /// Closed and consistently oriented: every edge is used equally often in both directions.
  bool closed = false;
};

/// Which triangles are connected through shared vertices.
struct Components {
  std::size_t count = 0;
  std::vector<std::uint32_t> of;  ///< component of each triangle, 0 .. count - 1
};

/// For each vertex, the first one at the same coordinates (itself if it is the first).
std::vector<std::uint32_t> weld(const std::vector<Vec3>& vertices, const Progress& progress = {});

/// The soup with one vertex for each place, in the order in which the triangles use them, without
/// unused vertices. A mesh written corner by corner (STL) is closed only after this: the functions
/// below treat vertices with different indices as different.
Soup compacted(Soup soup, const Progress& progress = {});

Topology analyse_topology(const Soup& soup, const Progress& progress = {});
Components find_components(const Soup& soup, const Progress& progress = {});

}  // namespace sonde
