// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/geometry/soup.hpp"

namespace sonde {

/// Triangles of a soup that have the same three corners, and how many of them stay.
struct SameTriangles {
  Triangle corners;             ///< ascending
  std::uint32_t component = 0;  ///< of the soup
  std::size_t begin, end;       ///< range in the list of all triangles, sorted by corners
  long evens = 0, odds = 0;     ///< number in each orientation
  long wanted = 1;              ///< number that stay, of the prevailing orientation
  bool once = false;            ///< one stays, and the others are copies of it
  bool decided = false;         ///< the decision is final
  bool shared = false;          ///< shared with other shells that occur in both orientations
  long net() const { return evens - odds; }
  long pairs() const { return std::min(evens, odds); }  ///< number of opposed pairs
  std::size_t size() const { return end - begin; }
};

inline std::array<std::uint64_t, 3> edge_keys(const Triangle& t) {
  const auto key = [](std::uint32_t a, std::uint32_t b) {
    return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
  };
  return {key(t[0], t[1]), key(t[1], t[2]), key(t[2], t[0])};
}

}  // namespace sonde
