// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/geometry/soup.hpp"

namespace sonde {

/// The edges where a mesh is not closed, to be shown: those that Topology counts, as pairs of
/// vertices.
struct DefectEdges {
  using Edge = std::array<std::uint32_t, 2>;
  std::vector<Edge> open;     ///< of one triangle only
  std::vector<Edge> flipped;  ///< of two triangles or more that do not agree which side is out
};

/// Of a soup with one vertex for each place (Body::soup). Both lists ascend.
DefectEdges defect_edges(const Soup& soup);

}  // namespace sonde
