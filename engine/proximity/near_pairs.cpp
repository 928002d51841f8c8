// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/near_pairs.hpp"

#include <algorithm>
#include <utility>

#include "engine/proximity/placement.hpp"

namespace sonde {

std::size_t keep_nearer_half(std::span<NearPair> out, double& reach) {
  const auto middle = out.begin() + static_cast<std::ptrdiff_t>(out.size() / 2);
  const auto nearer = [](const NearPair& x, const NearPair& y) {
    if (x.gap != y.gap) return x.gap < y.gap;
    return std::pair(x.triangle_a, x.triangle_b) < std::pair(y.triangle_a, y.triangle_b);
  };
  std::nth_element(out.begin(), middle, out.end(), nearer);
  reach = std::min(reach, middle->gap);
  return out.size() / 2;
}

NearPairs near_pairs(const Body& a, const Body& b, const Transform& X_BA, double reach,
                     std::span<NearPair> out) {
  const Placement at(a, b, X_BA);
  struct Entry {
    std::uint32_t a, b;
  };
  PairStack<Entry> stack;
  std::size_t found = 0;
  stack.push({0, 0});
  while (!stack.empty()) {
    const Entry e = stack.pop();
    const Tree::Node& na = a.tree.nodes[e.a];
    const Tree::Node& nb = b.tree.nodes[e.b];
    if (at.box_distance(na, nb) > reach) continue;
    if (na.is_leaf() && nb.is_leaf()) {
      for (std::uint32_t i = na.first; i < na.first + na.count; ++i) {
        const Corners ta = at.corners_a(i);
        for (std::uint32_t j = nb.first; j < nb.first + nb.count; ++j) {
          const Corners tb = at.corners_b(j);
          const ClosestPoints c = closest_points(ta, tb, reach);
          if (!(c.distance > 0) || c.distance > reach) continue;
          if (found == out.size()) found = keep_nearer_half(out, reach);
          const Separator apart = separator(c, ta, tb);
          out[found++] = {c.a, c.b, apart.normal, apart.gap, i, j};
        }
      }
    } else if (open_first(na, nb)) {
      stack.push({na.first + 1, e.b});
      stack.push({na.first, e.b});
    } else {
      stack.push({e.a, nb.first + 1});
      stack.push({e.a, nb.first});
    }
  }
  return {found, reach};
}

}  // namespace sonde
