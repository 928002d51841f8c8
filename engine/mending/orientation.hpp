// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/geometry/soup.hpp"
#include "engine/mending/edge_uses.hpp"

namespace sonde {

/// Which triangles must be turned so that neighbours agree, and which triangles form a part.
struct Orientation {
  std::vector<bool> turned;         ///< of each triangle
  std::vector<std::uint32_t> part;  ///< of each triangle, 0 .. parts - 1
  std::size_t parts = 0;
  std::size_t turned_triangles = 0;
  /// Of each part: edges of two triangles that cannot agree, as along a Möbius strip.
  std::vector<std::size_t> conflicts;
};

/// `uses` must be sorted. Triangles that meet at an edge with two uses form a *patch*, and agree
/// within it; a patch keeps the orientation of most of its area. Where more meet, patches are
/// turned as long as that shortens the border (edges whose uses in the two directions do not
/// balance). A *part* is a smallest set of patches that balances by itself at every edge where it
/// can. Throws Cancelled.
Orientation find_orientation(const Soup& soup, const std::vector<EdgeUse>& uses,
                             const Progress& progress = {});

}  // namespace sonde
