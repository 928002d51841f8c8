// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/progress.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {

/// A triangle by its corners, whichever is the first.
struct CornerTriangle {
  Triangle corners;        ///< ascending
  std::uint32_t triangle;  ///< of the soup
  bool even;               ///< goes round them in that order
};

/// The triangles of a soup, ascending by their corners and, where these are the same, by number:
/// those with the same corners lie beside each other. Throws Cancelled.
std::vector<CornerTriangle> triangles_by_corners(const Soup& soup, const Progress& progress = {});

/// Calls each(span of those that have the same corners), in order.
template <class Each>
void for_each_alike(const std::vector<CornerTriangle>& all, Each each) {
  for (std::size_t i = 0, j = 0; i < all.size(); i = j) {
    const Triangle& c = all[i].corners;
    for (j = i + 1; j < all.size(); ++j) {
      const Triangle& d = all[j].corners;
      if (c[0] != d[0] || c[1] != d[1] || c[2] != d[2]) break;
    }
    each(std::span<const CornerTriangle>(all.data() + i, j - i));
  }
}

}  // namespace sonde
