// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/pair_list.hpp"

#include "engine/proximity/pair_sweep.hpp"
#include "engine/proximity/placement.hpp"
#include "engine/proximity/triangle_batch.hpp"

namespace sonde {

PairList::PairList(const Body& a, const Body& b, std::size_t capacity)
    : a_(a), b_(b), items_(capacity), due_(capacity) {}

bool PairList::build(const Transform& X, double reach) noexcept {
  const Placement at(a_, b_, X);
  PairStack<SlotPair> stack;
  SlotPairs children;
  X_ = last_ = X;
  travel_ = 0;
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
    due_[count_] = at.below(p.bound);
    items_[count_++] = {at.triangle_a(p), at.triangle_b(p), Vec3::Zero()};
  }
  reach_ = reach;
  return true;
}

double PairList::displacement(const Transform& from, const Transform& X) const noexcept {
  // |R − R₀| as an operator is the Frobenius norm by √2, for rotations.
  const double turned = (X.R - from.R).norm() / std::sqrt(2.0);
  const Vec3& com = a_.mass.com;
  return (1 + 1e-12) * ((X * com - from * com).norm() + turned * a_.mass.radius);
}

double PairList::travel_to(const Transform& X) noexcept {
  travel_ += displacement(last_, X) * (1 + 1e-12);
  last_ = X;
  // Long travel within a small place would round the times away.
  if (travel_ > 1e3 * reach_) {
    std::fill_n(due_.begin(), count_, 0.0);
    travel_ = 0;
  }
  return travel_;
}

double PairList::guard(const Transform& X) const noexcept {
  return rounding_guard(extent(a_), extent(b_), X.p.cwiseAbs().cwiseMax(X_.p.cwiseAbs()));
}

double PairList::reach_at(const Transform& X) const noexcept {
  // Distances were rounded at the list's pose, and are again at this one.
  return reach_ < 0 ? -1 : reach_ - displacement(X_, X) - 2 * guard(X);
}

void PairList::learn(std::size_t item, double distance, double rounding) noexcept {
  due_[item] = std::max(due_[item], travel_ + distance * (1 - 1e-12) - rounding);
}

void PairList::find_normals(const Transform& X, double within) noexcept {
  const double rounding = guard(X);
  TriangleBatch batch(a_, b_, X);
  const auto look = [&] {
    batch.flush(within, [&](const TriangleBatch::Pair& pair, int k, const ClosestPoints8& points) {
      learn(pair.tag, std::min(points.distance[k], within), rounding);
      if (points.distance[k] > within || !(points.distance[k] > 0)) return;
      items_[pair.tag].normal = normal(points, k);
    });
  };
  for (std::size_t k = 0; k < count_; ++k) {
    if (due_[k] - travel_ > within + rounding || items_[k].normal != Vec3::Zero()) continue;
    batch.add({items_[k].a, items_[k].b, static_cast<std::uint32_t>(k)},
              place(X, corners(a_.soup, items_[k].a)), corners(b_.soup, items_[k].b));
    if (batch.full()) look();
  }
  look();
}

NearPairs PairList::near(const Transform& X, double reach, std::span<NearPair> out) noexcept {
  const double travel = travel_to(X);
  const double rounding = guard(X);
  // What lies beyond the reach is measured too: it is not looked at again until it has come near.
  const double limit = std::max(reach, reach_);
  TriangleBatch batch(a_, b_, X);
  std::size_t found = 0;
  const auto look = [&] {
    batch.flush(limit, [&](const TriangleBatch::Pair& pair, int k, const ClosestPoints8& points) {
      learn(pair.tag, std::min(points.distance[k], limit), rounding);
      if (points.distance[k] > limit || !(points.distance[k] > 0)) return;
      const NearPair near = near_pair(pair, k, points);
      items_[pair.tag].normal = near.normal;
      if (points.distance[k] > reach) return;
      if (found == out.size()) found = keep_nearer_half(out, reach);
      out[found++] = near;
    });
  };
  for (std::size_t k = 0; k < count_; ++k) {
    if (due_[k] - travel > reach + rounding) continue;
    const Item& item = items_[k];
    const Corners ta = place(X, corners(a_.soup, item.a));
    const Corners tb = corners(b_.soup, item.b);
    const double known = gap_along(item.normal, ta, tb);
    if (known > reach + rounding) {
      learn(k, known, rounding);
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
  const double travel = travel_to(pairs.start().X);
  const double path = motion.farthest(a_.mass.radius);
  find_normals(pairs.start().X, path + clearance + pairs.guard());
  for (std::size_t k = 0; k < count_ && pairs.free_until() > 0; ++k) {
    if (due_[k] - travel - path * pairs.free_until() > clearance + pairs.guard()) continue;
    pairs.advance(items_[k].a, items_[k].b, 0, items_[k].normal);
  }
  return pairs.result();
}

}  // namespace sonde
