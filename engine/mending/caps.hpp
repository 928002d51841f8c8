// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/geometry/soup.hpp"
#include "engine/mending/edge_uses.hpp"
#include "engine/mending/orientation.hpp"

namespace sonde {

/// A closed opening of a part: a loop of its border, and the triangles across it.
struct Cap {
  std::uint32_t part = 0;
  std::vector<std::uint32_t> loop;  ///< vertices (labels), opposite to the border's direction
  std::vector<Triangle> triangles;  ///< between vertices of the loop
  double area = 0;                  ///< m²
};

/// The caps that close every part: with them, all edges between labels balance. A loop is
/// triangulated by ear clipping in its best-fit plane. `uses` must be sorted; the result is ordered
/// by part.
std::vector<Cap> find_caps(const Soup& soup, const std::vector<EdgeUse>& uses,
                           const Orientation& orientation);

}  // namespace sonde
