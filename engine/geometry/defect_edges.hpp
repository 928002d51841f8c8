// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/geometry/soup.hpp"

namespace sonde {

/// The edges at which a mesh is not closed, for display: those that Topology counts, as pairs of
/// vertices.
struct DefectEdges {
  using Edge = std::array<std::uint32_t, 2>;
  std::vector<Edge> open;     ///< edges of only one triangle
  std::vector<Edge> flipped;  ///< edges of two or more triangles with inconsistent orientation
};

/// For a soup with one vertex for each place (Body::soup). Both lists are ascending.
DefectEdges defect_edges(const Soup& soup);

}  // namespace sonde
