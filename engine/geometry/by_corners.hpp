// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/progress.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {

/// A triangle identified by its corners, independent of which is the first.
struct CornerTriangle {
  Triangle corners;        ///< ascending
  std::uint32_t triangle;  ///< its index in the soup
  bool even;               ///< its orientation agrees with that order
};

/// The triangles of a soup, ascending by their corners and, if these are equal, by index: triangles
/// with the same corners are adjacent. Throws Cancelled.
std::vector<CornerTriangle> triangles_by_corners(const Soup& soup, const Progress& progress = {});

/// Calls each(span of the triangles that have the same corners), in order.
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
