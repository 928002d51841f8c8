// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/queries/violation.hpp"

#include <algorithm>

#include "engine/base/ordering.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/queries/triangle_batch.hpp"

namespace sonde {

std::size_t find_violations(const Body& a, const Body& b, const Transform& X_BA, double least,
                            std::span<Violation> out, Effort& effort) {
  const Placement at(a, b, X_BA);
  TriangleBatch batch(a, b, at.X);
  PairStack<SlotPair> stack;
  SlotPairs children;
  std::size_t found = 0;
  const float limit = at.to_unit_rounded_up(least);
  const auto look = [&] {
    effort.spend(TriangleBatch::work * batch.size());
    batch.flush(least, [&](const TriangleBatch::Pair& pair, int k, const ClosestPoints8& points) {
      if (points.distance[k] > least || found == out.size()) return;
      out[found++] = {pair.i, pair.j, points.distance[k] > 0 ? points.gap[k] : 0};
    });
  };
  stack.push(at.roots());
  while (!stack.empty() && found < out.size()) {
    const SlotPair p = stack.pop();
    if (at.is_leaf(p)) {
      batch.add(at.triangle_a(p), at.triangle_b(p));
      if (batch.full()) look();
      continue;
    }
    at.open_near(p, limit, children);
    if (!effort.spend(work_to_open(children.count))) break;
    // The deepest overlap is examined first.
    ordering::sort(children.begin(), children.end(),
                   [](const SlotPair& x, const SlotPair& y) { return x.bound > y.bound; });
    for (const SlotPair& child : children) stack.push(child);
  }
  look();
  return found;
}

}  // namespace sonde
