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
  std::size_t begin, end;       ///< in the list of all triangles that they are told by
  long evens = 0, odds = 0;     ///< in either orientation
  long wanted = 1;              ///< how many stay, of the orientation that prevails
  bool once = false;            ///< one stays, and all others are copies of it
  bool settled = false;         ///< that is no longer in doubt
  bool shared = false;          ///< a shell that is there both ways round shares it with others
  long net() const { return evens - odds; }
  long pairs() const { return std::min(evens, odds); }  ///< that stand against each other
  std::size_t size() const { return end - begin; }
};

inline std::array<std::uint64_t, 3> edge_keys(const Triangle& t) {
  const auto key = [](std::uint32_t a, std::uint32_t b) {
    return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
  };
  return {key(t[0], t[1]), key(t[1], t[2]), key(t[2], t[0])};
}

}  // namespace sonde
