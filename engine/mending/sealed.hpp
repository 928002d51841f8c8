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

/// A soup as it is once mended: corners that belong together are one, sides are cut where corners
/// lie on them, triangles are turned to agree, and openings are capped. Every part of it is closed,
/// by indices: what counts windings or integrates works on this. What is touched does not: there no
/// coordinate has changed.
struct Sealed {
  static constexpr std::uint32_t no_cap = std::numeric_limits<std::uint32_t>::max();
  Soup soup;
  std::vector<std::uint32_t> part;  ///< of each triangle
  std::vector<std::uint32_t> cap;   ///< of each triangle: which cap it is of, or no_cap
};

Sealed seal(const Soup& soup, const Seams& seams, const Orientation& orientation,
            const std::vector<Cap>& caps);

/// The triangles of some parts, with all vertices.
Sealed parts_of(const Sealed& sealed, const std::vector<bool>& wanted);

}  // namespace sonde
