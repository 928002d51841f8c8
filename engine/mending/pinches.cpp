// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/pinches.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace sonde {
namespace {

/// The side of a triangle that lies opposite to a vertex.
struct Opposite {
  std::uint32_t from, to;
};

bool has_repeated_corner(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

/// Whether one way along the sides, each from where the last one ends, has them all.
bool is_one_fan(std::span<const Opposite> sides) {
  if (sides.empty()) return true;
  std::size_t taken = 0;
  std::uint32_t at = sides.front().from;
  do {
    const auto next =
        std::ranges::find_if(sides, [at](const Opposite& side) { return side.from == at; });
    if (next == sides.end()) return true;  // open here: no fan that goes around
    at = next->to;
    ++taken;
  } while (at != sides.front().from && taken <= sides.size());
  return taken >= sides.size();
}

}  // namespace

bool has_pinches(const Soup& soup) {
  std::vector<std::size_t> end(soup.vertices.size() + 1, 0);
  const auto each_corner = [&](auto use) {
    for (const Triangle& t : soup.triangles)
      if (!has_repeated_corner(t))
        for (std::size_t k = 0; k < 3; ++k) use(t[k], Opposite{t[(k + 1) % 3], t[(k + 2) % 3]});
  };
  each_corner([&](std::uint32_t v, const Opposite&) { ++end[v + 1]; });
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<Opposite> all(end.back());
  // While they are stored, end[v] moves from the start of a vertex's sides to their end.
  each_corner([&](std::uint32_t v, const Opposite& side) { all[end[v]++] = side; });
  for (std::size_t v = 0, from = 0; v < soup.vertices.size(); from = end[v++])
    if (!is_one_fan(std::span(all).subspan(from, end[v] - from))) return true;
  return false;
}

}  // namespace sonde
