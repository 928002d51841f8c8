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
    : a_(a),
      b_(b),
      items_(capacity),
      due_(capacity),
      groups_(capacity / group + 1),
      centre_(a.mass.com) {
  clear();
}

PairList::Displacement PairList::along(const Motion& motion, const Vec3& centre) noexcept {
  const Motion::Velocity v = motion.velocity(0);
  const Vec3 arm = motion.at(0).R * (centre - motion.com());
  const double bend = 0.5 * motion.acceleration_per_radius() * arm.norm();
  return {((v.linear + v.angular.cross(arm)).norm() + bend) * (1 + 1e-9),
          motion.turn_bound() * (1 + 1e-12)};
}

bool PairList::build(const Transform& X, const Vec3& centre, const Displacement& room,
                     Effort& effort) noexcept {
  const Placement at(a_, b_, X);
  PairStack<SlotPair> stack;
  SlotPairs children;
  clear();
  X_ = last_ = X;
  linear_ = turned_ = 0;
  centre_ = centre;
  longest_arm_ = ((centre - a_.mass.com).norm() + a_.mass.radius) * (1 + 1e-12);
  const auto arm_of = [&](const SlotPair& p) {
    return (a_.tree.center(p.a) - centre).norm() * (1 + 1e-6) + a_.tree.half_diagonal(p.a);
  };
  stack.push(at.roots());
  while (!stack.empty()) {
    const SlotPair p = stack.pop();
    const double arm = arm_of(p);
    const float limit = at.above(room.of(arm));
    if (p.bound > limit) continue;
    if (!at.is_leaf(p)) {
      at.open_near(p, limit, children);
      if (!effort.spend(work_to_open(children.count))) return clear(), false;
      for (const SlotPair& child : children) stack.push(child);
      continue;
    }
    if (count_ == items_.size()) return clear(), false;
    const Due due{at.below(p.bound), arm};
    Due& least = groups_[count_ / group];
    if (count_ % group == 0) least = due;
    least = {std::min(least.distance, due.distance), std::max(least.arm, due.arm)};
    due_[count_] = due;
    items_[count_++] = {at.triangle_a(p), at.triangle_b(p), Vec3::Zero()};
  }
  room_ = room;
  return true;
}

PairList::Displacement PairList::displacement(const Transform& from,
                                              const Transform& X) const noexcept {
  // |R − R₀| as an operator is the Frobenius norm by √2, for rotations.
  return {(1 + 1e-12) * (X * centre_ - from * centre_).norm(),
          (1 + 1e-12) * (X.R - from.R).norm() / std::sqrt(2.0)};
}

void PairList::travel_to(const Transform& X) noexcept {
  const Displacement more = displacement(last_, X);
  linear_ += more.linear * (1 + 1e-12);
  turned_ += more.turn * (1 + 1e-12);
  last_ = X;
  // Long travel within a small place would round the distances away.
  if (linear_ + turned_ * longest_arm_ > 1e3 * room_.of(longest_arm_)) {
    for (Due& due : due_) due.distance = 0;
    for (Due& least : groups_) least.distance = 0;
    linear_ = turned_ = 0;
  }
}

double PairList::guard(const Transform& X) const noexcept {
  return rounding_guard(extent(a_), extent(b_), X.p.cwiseAbs().cwiseMax(X_.p.cwiseAbs()));
}

double PairList::reach_after(const Transform& X, const Displacement& more) const noexcept {
  if (room_.linear < 0) return -1;
  // The least of what is left for any arm. Distances were rounded at the list's pose, and are again
  // at this one.
  const Displacement since = displacement(X_, X);
  const Displacement left{room_.linear - since.linear - more.linear,
                          room_.turn - since.turn - more.turn};
  return std::min(left.linear, left.of(longest_arm_)) - 2 * guard(X);
}

bool PairList::covers(const Motion& motion, double clearance) const noexcept {
  return reach_after(motion.at(0), along(motion, centre_)) > clearance;
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

NearPairs PairList::near(const Transform& X, double reach, std::span<NearPair> out,
                         Effort& effort) noexcept {
  travel_to(X);
  const double rounding = guard(X);
  // What lies beyond the reach is measured too: it is not looked at again until it has come near.
  const double limit = std::max(reach, room_.of(longest_arm_));
  Vec3 hint = Vec3::Zero();
  TriangleBatch batch(a_, b_, X);
  std::size_t found = 0;
  const auto look = [&] {
    effort.spend(TriangleBatch::work * batch.size());
    batch.flush(limit, [&](const TriangleBatch::Pair& pair, int k, const ClosestPoints8& points) {
      learn(pair.tag, std::min(points.distance[k], limit), rounding);
      if (points.distance[k] > limit || !(points.distance[k] > 0)) return;
      const NearPair near = near_pair(pair, k, points);
      items_[pair.tag].normal = hint = near.normal;
      if (points.distance[k] > reach) return;
      if (found == out.size()) found = keep_nearer_half(out, reach);
      out[found++] = near;
    });
  };
  each_due({}, reach + rounding, [&](std::size_t k) {
    if (!effort.spend(work_to_place)) return;
    Item& item = items_[k];
    const Corners ta = place(X, corners(surface(a_), item.a));
    const Corners tb = corners(surface(b_), item.b);
    const bool is_new = item.normal == Vec3::Zero();
    const double known = gap_along(is_new ? hint : item.normal, ta, tb);
    if (known > reach + rounding) {
      hint = item.normal = is_new ? hint : item.normal;
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
  const Moment& start = pairs.start();
  travel_to(start.X);
  const double rounding = guard(start.X), room = clearance + pairs.guard();
  const double farthest = room_.of(longest_arm_);
  const Displacement ahead = along(motion, centre_);
  // Free up to here by itself: a share of what is spare.
  const auto known = [&](std::size_t k) {
    return (spare(due_[k]) - room) / std::max(ahead.of(due_[k].arm), 1e-300) * (1 - 1e-12);
  };
  Vec3 hint = Vec3::Zero();
  TriangleBatch batch(a_, b_, start.X);
  // Most pairs are done with along the direction known for them, or for the one before; of the
  // others, after a closer look, which eight take together.
  const auto look = [&] {
    batch.flush(farthest,
                [&](const TriangleBatch::Pair& pair, int k, const ClosestPoints8& points) {
                  learn(pair.tag, std::min(points.distance[k], farthest), rounding);
                  if (!effort.spend(work_to_advance)) {
                    pairs.give_up(std::max(0.0, known(pair.tag)));
                    return;
                  }
                  Vec3& n = items_[pair.tag].normal;
                  double from = 0;
                  if (points.distance[k] <= farthest && points.gap[k] > 2 * clearance) {
                    n = hint = normal(points, k);
                    from = pairs.step_along(pair.i, pair.j, n, start).length;
                  }
                  if (from < pairs.free_until())
                    effort.spend(pairs.advance(pair.i, pair.j, from, n));
                });
  };
  each_due(ahead, room, [&](std::size_t k) {
    Item& item = items_[k];
    if (known(k) > pairs.free_until()) return;
    if (!effort.spend(work_to_place)) return pairs.give_up(std::max(0.0, known(k)));
    const bool is_new = item.normal == Vec3::Zero();
    const Vec3& n = is_new ? hint : item.normal;
    if (n != Vec3::Zero()) {
      const PairSweep::Step step = pairs.step_along(item.a, item.b, n, start);
      learn(k, step.gap, rounding);
      if (step.length >= pairs.free_until()) {
        hint = item.normal = n;
        return;
      }
    }
    batch.add({item.a, item.b, static_cast<std::uint32_t>(k)},
              place(start.X, corners(surface(a_), item.a)), corners(surface(b_), item.b));
    if (batch.full()) look();
  });
  look();
  return pairs.result();
}

}  // namespace sonde
