// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/queries/near_pairs.hpp"

#include <algorithm>
#include <utility>

#include "engine/base/ordering.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/queries/triangle_batch.hpp"

namespace sonde {

std::size_t keep_nearer_half(std::span<NearPair> out, double& reach) {
  const auto middle = out.begin() + static_cast<std::ptrdiff_t>(out.size() / 2);
  const auto nearer = [](const NearPair& x, const NearPair& y) {
    if (x.gap != y.gap) return x.gap < y.gap;
    return std::pair(x.triangle_a, x.triangle_b) < std::pair(y.triangle_a, y.triangle_b);
  };
  ordering::nth_element(out.begin(), middle, out.end(), nearer);
  reach = std::min(reach, middle->gap);
  return out.size() / 2;
}

NearPairs near_pairs(const Body& a, const Body& b, const Transform& X_BA, double reach,
                     std::span<NearPair> out) {
  Effort unlimited;
  return near_pairs(a, b, X_BA, reach, out, unlimited);
}

NearPairs near_pairs(const Body& a, const Body& b, const Transform& X_BA, double reach,
                     std::span<NearPair> out, Effort& effort) {
  const Placement at(a, b, X_BA);
  TriangleBatch batch(a, b, at.X);
  PairStack<SlotPair> stack;
  SlotPairs children;
  std::size_t found = 0;
  bool crowded = false;
  const auto look = [&] {
    effort.spend(TriangleBatch::work * batch.size());
    batch.flush(reach, [&](const TriangleBatch::Pair& pair, int k, const ClosestPoints8& points) {
      if (!(points.distance[k] > 0) || points.distance[k] > reach) return;
      if (found == out.size()) found = keep_nearer_half(out, reach), crowded = true;
      out[found++] = near_pair(pair, k, points);
    });
  };
  stack.push(at.roots());
  while (!stack.empty()) {
    const SlotPair p = stack.pop();
    const float limit = at.to_unit_rounded_up(reach);
    if (p.bound > limit) continue;
    if (at.is_leaf(p)) {
      batch.add(at.triangle_a(p), at.triangle_b(p));
      if (batch.full()) look();
      continue;
    }
    at.open_near(p, limit, children);
    if (!effort.spend(work_to_open(children.count))) return {0, -1};
    // If not all pairs fit, the nearest boxes come first, so that farther ones need not be
    // examined.
    if (crowded)
      ordering::sort(children.begin(), children.end(),
                     [](const SlotPair& x, const SlotPair& y) { return x.bound > y.bound; });
    for (const SlotPair& child : children) stack.push(child);
  }
  look();
  return {found, reach};
}

}  // namespace sonde
