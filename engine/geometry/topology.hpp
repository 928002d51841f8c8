// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/geometry/soup.hpp"

namespace sonde {

/// How the triangles of a soup hang together. Vertices at the same coordinates count as one, so a
/// mesh written corner by corner (STL) is closed where it looks closed.
struct Topology {
  std::size_t open_edges = 0;         ///< edges used by one triangle only
  std::size_t nonmanifold_edges = 0;  ///< edges used by three triangles or more
  /// Edges of two triangles or more whose uses in the two directions do not balance.
  std::size_t misoriented_edges = 0;
  std::size_t duplicate_triangles = 0;
  std::size_t components = 0;  ///< connected through shared vertices
  /// Component of each triangle, 0 .. components - 1.
  std::vector<std::uint32_t> component_of;
  /// Closed and consistently oriented: every edge is used equally often in both directions.
  bool closed = false;
};
Topology analyse_topology(const Soup& soup);

/// For each vertex the first one at the same coordinates (itself where it is the first).
std::vector<std::uint32_t> weld(const std::vector<Vec3>& vertices);

/// The components alone: fills in component_of and components.
void find_components(const Soup& soup, Topology& topology);

}  // namespace sonde
