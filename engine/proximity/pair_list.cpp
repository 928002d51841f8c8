// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/pair_list.hpp"

#include "engine/proximity/pair_sweep.hpp"
#include "engine/proximity/placement.hpp"
#include "engine/proximity/triangle_batch.hpp"

namespace sonde {
namespace {

constexpr std::size_t group = 16;
// In the units of Effort.
constexpr int work_to_place = 3, work_to_advance = 20;

}  // namespace

PairList::PairList(const Body& a, const Body& b, std::size_t capacity)
    : a_(a), b_(b), items_(capacity), due_(capacity), groups_(capacity / group + 1) {
  if (capacity == 0) return;
  arms_.reserve(a.soup.triangles.size());
  for (std::uint32_t i = 0; i < a.soup.triangles.size(); ++i) {
    double arm = 0;
    for (const Vec3& x : corners(a.soup, i)) arm = std::max(arm, (x - a.mass.com).norm());
    arms_.push_back(arm * (1 + 1e-12));
  }
}

bool PairList::build(const Transform& X, double reach, Effort& effort) noexcept {
  const Placement at(a_, b_, X);
  PairStack<SlotPair> stack;
  SlotPairs children;
  X_ = last_ = X;
  linear_ = turned_ = 0;
  count_ = 0;
  reach_ = -1;
  stack.push(at.roots());
  while (!stack.empty()) {
    const SlotPair p = stack.pop();
    if (!at.is_leaf(p)) {
      at.open_near(p, at.above(reach), children);
      if (!effort.spend(work_to_open(children.count))) {
        count_ = 0;
        return false;
      }
      for (const SlotPair& child : children) stack.push(child);
      continue;
    }
    if (count_ == items_.size()) {
      count_ = 0;
      return false;
    }
    const Due due{at.below(p.bound), arms_[at.triangle_a(p)]};
    Due& least = groups_[count_ / group];
    if (count_ % group == 0) least = due;
    least = {std::min(least.distance, due.distance), std::max(least.arm, due.arm)};
    due_[count_] = due;
    items_[count_++] = {at.triangle_a(p), at.triangle_b(p), Vec3::Zero()};
  }
  reach_ = reach;
  return true;
}

PairList::Displacement PairList::displacement(const Transform& from,
                                              const Transform& X) const noexcept {
  // |R − R₀| as an operator is the Frobenius norm by √2, for rotations.
  const Vec3& com = a_.mass.com;
  return {(1 + 1e-12) * (X * com - from * com).norm(),
          (1 + 1e-12) * (X.R - from.R).norm() / std::sqrt(2.0)};
}

void PairList::travel_to(const Transform& X) noexcept {
  const Displacement more = displacement(last_, X);
  linear_ += more.linear * (1 + 1e-12);
  turned_ += more.turn * (1 + 1e-12);
  last_ = X;
  // Long travel within a small place would round the distances away.
  if (linear_ + turned_ * a_.mass.radius > 1e3 * reach_) {
    for (Due& due : due_) due.distance = 0;
    for (Due& least : groups_) least.distance = 0;
    linear_ = turned_ = 0;
  }
}

double PairList::guard(const Transform& X) const noexcept {
  return rounding_guard(extent(a_), extent(b_), X.p.cwiseAbs().cwiseMax(X_.p.cwiseAbs()));
}

double PairList::reach_at(const Transform& X) const noexcept {
  // Distances were rounded at the list's pose, and are again at this one.
  if (reach_ < 0) return -1;
  const Displacement since = displacement(X_, X);
  return reach_ - (since.linear + since.turn * a_.mass.radius) - 2 * guard(X);
}

void PairList::learn(std::size_t item, double distance, double rounding) noexcept {
  Due& due = due_[item];
  const double used_up = linear_ + due.arm * turned_;
  due.distance = std::max(due.distance, used_up + distance * (1 - 1e-12) - rounding);
}

template <class Visit>
void PairList::each_due(const Displacement& ahead, double within, const Visit& visit) noexcept {
  const auto is_due = [&](const Due& due) { return spare(due) <= within + ahead.of(due.arm); };
  for (std::size_t first = 0; first < count_; first += group) {
    Due& least = groups_[first / group];
    if (!is_due(least)) continue;
    const std::size_t end = std::min(first + group, count_);
    least.distance = due_[first].distance;
    for (std::size_t k = first; k < end; ++k) {
      least.distance = std::min(least.distance, due_[k].distance);
      if (is_due(due_[k])) visit(k);
    }
  }
}

void PairList::find_normals(const Motion& motion, const Transform& X, double clearance,
                            Effort& effort) noexcept {
  const double rounding = guard(X);
  const Displacement ahead{motion.linear_distance(), motion.turn_bound()};
  const double within = ahead.of(a_.mass.radius) + clearance;
  TriangleBatch batch(a_, b_, X);
  const auto look = [&] {
    effort.spend(TriangleBatch::work * batch.size());
    batch.flush(within, [&](const TriangleBatch::Pair& pair, int k, const ClosestPoints8& points) {
      learn(pair.tag, std::min(points.distance[k], within), rounding);
      if (points.distance[k] > within || !(points.distance[k] > 0)) return;
      items_[pair.tag].normal = normal(points, k);
    });
  };
  each_due(ahead, clearance + rounding, [&](std::size_t k) {
    if (items_[k].normal != Vec3::Zero() || effort.is_spent()) return;
    batch.add({items_[k].a, items_[k].b, static_cast<std::uint32_t>(k)},
              place(X, corners(a_.soup, items_[k].a)), corners(b_.soup, items_[k].b));
    if (batch.full()) look();
  });
  look();
}

NearPairs PairList::near(const Transform& X, double reach, std::span<NearPair> out,
                         Effort& effort) noexcept {
  travel_to(X);
  const double rounding = guard(X);
  // What lies beyond the reach is measured too: it is not looked at again until it has come near.
  const double limit = std::max(reach, reach_);
  TriangleBatch batch(a_, b_, X);
  std::size_t found = 0;
  const auto look = [&] {
    effort.spend(TriangleBatch::work * batch.size());
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
  each_due({}, reach + rounding, [&](std::size_t k) {
    if (!effort.spend(work_to_place)) return;
    const Item& item = items_[k];
    const Corners ta = place(X, corners(a_.soup, item.a));
    const Corners tb = corners(b_.soup, item.b);
    const double known = gap_along(item.normal, ta, tb);
    if (known > reach + rounding) {
      learn(k, known, rounding);
      return;
    }
    batch.add({item.a, item.b, static_cast<std::uint32_t>(k)}, ta, tb);
    if (batch.full()) look();
  });
  look();
  if (effort.is_spent()) return {0, -1};
  return {found, reach};
}

Sweep PairList::sweep_along(const Motion& motion, double clearance, Effort& effort) noexcept {
  PairSweep pairs(a_, b_, motion, clearance);
  travel_to(pairs.start().X);
  const double room = clearance + pairs.guard();
  find_normals(motion, pairs.start().X, room, effort);
  const Displacement ahead{motion.linear_distance(), motion.turn_bound()};
  each_due(ahead, room, [&](std::size_t k) {
    const double way = ahead.of(due_[k].arm), left = spare(due_[k]) - room;
    if (left > way * pairs.free_until()) return;
    if (effort.spend(work_to_advance))
      pairs.advance(items_[k].a, items_[k].b, 0, items_[k].normal);
    else
      pairs.give_up(std::max(0.0, left / way * (1 - 1e-12)));
  });
  return pairs.result();
}

}  // namespace sonde
