// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/pair_list.hpp"

#include "engine/proximity/pair_sweep.hpp"
#include "engine/proximity/placement.hpp"
#include "engine/proximity/triangle_batch.hpp"

namespace sonde {

PairList::PairList(const Body& a, const Body& b, std::size_t capacity)
    : a_(a), b_(b), items_(capacity) {}

bool PairList::build(const Transform& X, double reach) noexcept {
  const Placement at(a_, b_, X);
  PairStack<SlotPair> stack;
  SlotPairs children;
  X_ = X;
  count_ = 0;
  reach_ = -1;
  stack.push(at.roots());
  while (!stack.empty()) {
    const SlotPair p = stack.pop();
    if (!at.is_leaf(p)) {
      at.open_near(p, at.above(reach), children);
      for (const SlotPair& child : children) stack.push(child);
      continue;
    }
    if (count_ == items_.size()) {
      count_ = 0;
      return false;
    }
    items_[count_++] = {at.triangle_a(p), at.triangle_b(p), at.below(p.bound), Vec3::Zero()};
  }
  reach_ = reach;
  return true;
}

double PairList::displacement(const Transform& X) const noexcept {
  // |R − R₀| as an operator is the Frobenius norm by √2, for rotations.
  const double turned = (X.R - X_.R).norm() / std::sqrt(2.0);
  const Vec3& com = a_.mass.com;
  return (1 + 1e-12) * ((X * com - X_ * com).norm() + turned * a_.mass.radius);
}

double PairList::guard(const Transform& X) const noexcept {
  return rounding_guard(extent(a_), extent(b_), X.p.cwiseAbs().cwiseMax(X_.p.cwiseAbs()));
}

double PairList::reach_at(const Transform& X) const noexcept {
  // Distances were rounded at the list's pose, and are again at this one.
  return reach_ < 0 ? -1 : reach_ - displacement(X) - 2 * guard(X);
}

NearPairs PairList::near(const Transform& X, double reach, std::span<NearPair> out) noexcept {
  const double moved = displacement(X);
  const double rounding = guard(X);
  TriangleBatch batch(a_, b_, X);
  std::size_t found = 0;
  const auto look = [&] {
    batch.flush(reach, [&](const TriangleBatch::Pair& pair, int k, const ClosestPoints8& points) {
      Item& item = items_[pair.tag];
      const double least = std::min(points.distance[k], reach);  // of what is beyond, that alone
      item.bound = std::max(item.bound, least * (1 - 1e-12) - moved);
      if (points.distance[k] > reach || !(points.distance[k] > 0)) return;
      const NearPair near = near_pair(pair, k, points);
      item.normal = near.normal;
      if (found == out.size()) found = keep_nearer_half(out, reach);
      out[found++] = near;
    });
  };
  for (std::size_t k = 0; k < count_; ++k) {
    Item& item = items_[k];
    if (item.bound - moved > reach + rounding) continue;
    const Corners ta = place(X, corners(a_.soup, item.a));
    const Corners tb = corners(b_.soup, item.b);
    const double known = gap_along(item.normal, ta, tb);
    if (known > reach + rounding) {
      item.bound = std::max(item.bound, known * (1 - 1e-12) - moved);
      continue;
    }
    batch.add({item.a, item.b, static_cast<std::uint32_t>(k)}, ta, tb);
    if (batch.full()) look();
  }
  look();
  return {found, reach};
}

Sweep PairList::sweep_along(const Motion& motion, double clearance) noexcept {
  PairSweep pairs(a_, b_, motion, clearance);
  const double moved = displacement(pairs.start().X);
  const double path = motion.farthest(a_.mass.radius);
  for (std::size_t k = 0; k < count_ && pairs.free_until() > 0; ++k) {
    Item& item = items_[k];
    if (item.bound - moved - path * pairs.free_until() > clearance + pairs.guard()) continue;
    pairs.advance(item.a, item.b, 0, item.normal);
  }
  return pairs.result();
}

}  // namespace sonde
