// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/geometry/soup.hpp"
#include "engine/mending/edge_uses.hpp"

namespace sonde {

/// Which triangles must be turned so that neighbours agree, and what hangs together.
struct Orientation {
  std::vector<bool> turned;         ///< of each triangle
  std::vector<std::uint32_t> part;  ///< of each triangle, 0 .. parts - 1
  std::size_t parts = 0;
  std::size_t turned_triangles = 0;
  /// Of each part: edges of two triangles across which they cannot agree, as along a Möbius strip.
  std::vector<std::size_t> conflicts;
};

/// `uses` are sorted. Triangles that meet at an edge of two uses form a *patch*, and agree in it;
/// a patch keeps the way that most of its area is turned. Where more meet, a patch is turned as
/// long as that shortens the border (edges whose uses in the two directions do not balance). A
/// *part* is the least set of patches that balances by itself at every edge where it can. Throws
/// Cancelled.
Orientation find_orientation(const Soup& soup, const std::vector<EdgeUse>& uses,
                             const Progress& progress = {});

}  // namespace sonde
