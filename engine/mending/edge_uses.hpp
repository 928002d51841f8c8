// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {

/// One use of an edge by a triangle.
struct EdgeUse {
  std::uint32_t low, high;  ///< the end vertices, the lower one first
  std::uint32_t side;       ///< 3 i + k: of triangle i, from its corner k to the next
  bool down;                ///< the triangle goes from the higher end to the lower one
  std::uint32_t triangle() const { return side / 3; }
};

/// Sorts by edge, and the uses of one edge by side.
void sort_uses(std::vector<EdgeUse>& uses, std::size_t vertices, const Progress& progress = {});

/// A side's use of the edge from one vertex to another.
inline EdgeUse edge_use(std::uint32_t from, std::uint32_t to, std::uint32_t side) {
  return from < to ? EdgeUse{from, to, side, false} : EdgeUse{to, from, side, true};
}

/// All uses of edges in a soup, sorted. Triangles with a repeated corner have none: they collapse
/// to an edge, whose two uses cancel.
std::vector<EdgeUse> edge_uses(const Soup& soup, const Progress& progress = {});

/// Calls use(span) for the uses of each edge in turn. @pre `uses` is sorted.
template <class Use>
void for_each_edge(std::span<const EdgeUse> uses, Use use) {
  for (std::size_t i = 0, j = 0; i < uses.size(); i = j) {
    for (j = i + 1; j < uses.size() && uses[j].low == uses[i].low && uses[j].high == uses[i].high;)
      ++j;
    use(uses.subspan(i, j - i));
  }
}

}  // namespace sonde
