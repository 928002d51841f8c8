// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "engine/geometry/soup.hpp"
#include "engine/mending/caps.hpp"
#include "engine/mending/orientation.hpp"
#include "engine/mending/seams.hpp"

namespace sonde {

/// A mended soup: corners that belong together are one, sides are cut where corners lie on them,
/// triangles agree in orientation, and openings are capped. Every part of it is closed, by indices.
/// Winding numbers and integrals are computed on this. Contact does not use it: there no coordinate
/// has changed.
struct Sealed {
  static constexpr std::uint32_t no_cap = std::numeric_limits<std::uint32_t>::max();
  Soup soup;
  std::vector<std::uint32_t> part;  ///< for each triangle
  std::vector<std::uint32_t> cap;   ///< for each triangle: its cap, or no_cap
};

Sealed seal(const Soup& soup, const Seams& seams, const Orientation& orientation,
            const std::vector<Cap>& caps);

/// The triangles of the wanted parts, with all vertices.
Sealed parts_of(const Sealed& sealed, const std::vector<bool>& wanted);

}  // namespace sonde
