// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/pair_list.hpp"

#include "engine/proximity/pair_sweep.hpp"
#include "engine/proximity/placement.hpp"

namespace sonde {
namespace {
constexpr std::size_t most_items = 16384;
}

PairList::PairList(const Body& a, const Body& b) : a_(a), b_(b), items_(most_items) {}

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

double PairList::reach_at(const Transform& X) const noexcept {
  return reach_ < 0 ? -1 : reach_ - displacement(X);
}

NearPairs PairList::near(const Transform& X, double reach, std::span<NearPair> out) noexcept {
  const double moved = displacement(X);
  std::size_t found = 0;
  for (std::size_t k = 0; k < count_; ++k) {
    Item& item = items_[k];
    if (item.bound - moved > reach) continue;
    const Corners ta = place(X, corners(a_.soup, item.a));
    const Corners tb = corners(b_.soup, item.b);
    const double known = gap_along(item.normal, ta, tb);
    if (known > reach) {
      item.bound = std::max(item.bound, known * (1 - 1e-12) - moved);
      continue;
    }
    const ClosestPoints c = closest_points(ta, tb, reach);
    if (c.distance > reach) {
      item.bound = std::max(item.bound, reach - moved);
      continue;
    }
    item.bound = std::max(item.bound, c.distance * (1 - 1e-12) - moved);
    if (!(c.distance > 0)) continue;
    item.normal = c.normal;
    if (found == out.size()) found = keep_nearer_half(out, reach);
    out[found++] = {c.a, c.b, c.normal, c.gap, item.a, item.b};
  }
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
