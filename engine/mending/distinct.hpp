// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {

/// Repeated triangles, counted once.
struct Distinct {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  /// For each triangle, its representative: itself if it stays, or one that stays and has the same
  /// three corners; none if it and its copies cancel, as in a wall between two bodies.
  std::vector<std::uint32_t> by;
  /// Triangles that are left out as copies of one that stays: of components in which each triangle
  /// has an opposite one, as in an export of both sides; and those repeated by accident.
  std::vector<bool> backs;
  /// Triangles that stay of as many in each orientation: which of the two is no one's intention.
  std::vector<bool> both_ways;
  std::size_t repeated = 0;  ///< triangles that do not stay
};

/// In each connected component, of the triangles with the same three corners as many stay as keep
/// the ratios of its winding numbers (if all of it is written twice: half of it); one stays, if the
/// rest of the component is open without it. Throws Cancelled.
Distinct find_distinct(const Soup& soup, const Progress& progress = {});

}  // namespace sonde
