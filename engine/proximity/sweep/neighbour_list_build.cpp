// SPDX-License-Identifier: GPL-3.0-or-later
// How a list is made.
#include <array>
#include <utility>

#include "engine/base/recent.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/queries/triangle_batch.hpp"
#include "engine/proximity/sweep/neighbour_list.hpp"

namespace sonde {
namespace {

constexpr int work_to_take = 4;  // a pair, in the units of Effort

}  // namespace

double NeighbourList::arm_of(std::uint32_t slot) const noexcept {
  return (a_.tree.center(slot) - centre_).norm() * (1 + 1e-6) + a_.tree.half_diagonal(slot);
}

/// Pairs of triangles on their way into the list, eight of which are compared at a time.
struct NeighbourList::Candidates {
  TriangleBatch batch;
  Displacement room;
  double rounding;                  // m
  std::array<double, block> arm{};  // m
  bool fit = true;                  // so far
};

void NeighbourList::start(const Transform& X, const Vec3& centre) noexcept {
  clear();
  X_ = last_ = X;
  linear_ = turned_ = 0;
  centre_ = centre;
  work_of_build_ = 0;
  longest_arm_ = ((centre - a_.mass.com).norm() + a_.mass.radius) * (1 + 1e-12);
}

void NeighbourList::take(Candidates& of) noexcept {
  const double widest = of.room.of(*std::max_element(of.arm.begin(), of.arm.end()));
  of.batch.flush(widest + 2 * of.rounding, [&](const TriangleBatch::Pair& pair, int lane,
                                               const ClosestPoints8& points) {
    const double distance = points.distance[lane] * (1 - 1e-12) - of.rounding;
    const double arm = of.arm[static_cast<std::size_t>(lane)];
    if (distance > of.room.of(arm) || !of.fit) return;
    if (count_ == capacity_ && !least_only_) {
      shrink(of);
      if (distance > of.room.of(arm)) return;
    }
    of.fit = count_ < capacity_;
    if (!of.fit) return;
    const bool apart = points.distance[lane] > 0;
    append({pair.i, pair.j}, {distance, arm}, apart ? normal(points, lane) : Vec3::Zero());
  });
}

void NeighbourList::shrink(Candidates& of) noexcept {
  planned_ = of.room = plan_.least;
  least_only_ = true;
  const std::size_t found = std::exchange(count_, 0);
  for (std::size_t i = 0; i < found; ++i) {
    const Due due = due_of_pair_[i];
    if (due.distance > planned_.of(due.arm)) continue;
    const Pairs& of_block = items_[i / block];
    const std::size_t lane = i % block;
    append({of_block.a[lane], of_block.b[lane]}, due, normal_of(static_cast<std::uint32_t>(i)));
  }
}

bool NeighbourList::build_by(const Plan& plan, const Transform& X, const Vec3& centre,
                             Effort& effort) noexcept {
  start(X, centre);
  plan_ = plan;
  planned_ = plan.ample;
  least_only_ = plan.ample.linear <= plan.least.linear && plan.ample.turn <= plan.least.turn;
  to_visit_.clear();
  to_visit_.push(roots(a_.tree, b_.tree));
  return go_on(effort);
}

bool NeighbourList::go_on(Effort& effort) noexcept {
  const Placement at(a_, b_, X_);
  SlotPairs found;
  Recent<double> arms;
  Candidates candidates{{a_, b_, X_}, planned_, guard(X_)};
  const auto spend = [&](int work) { return work_of_build_ += work, effort.spend(work); };
  // What is found below a pair goes by the arm of its box of A, which is the longer one.
  const auto sort_out = [&](const SlotPair& p, double arm) {
    if (!at.is_leaf(p)) return to_visit_.push(p);
    spend(work_to_take);
    candidates.arm[static_cast<std::size_t>(candidates.batch.size())] = arm;
    candidates.batch.add(at.triangle_a(p), at.triangle_b(p));
    if (candidates.batch.full()) take(candidates);
  };
  unfinished_ = false;
  while (candidates.fit && !unfinished_ && !to_visit_.empty()) {
    const SlotPair p = to_visit_.pop();
    const double arm = arms.at(p.a, [&](std::uint32_t slot) { return arm_of(slot); });
    const float limit = at.above(planned_.of(arm));
    if (p.bound > limit) continue;
    if (at.is_leaf(p)) {  // the roots alone
      sort_out(p, arm);
      continue;
    }
    at.open_by_faces(p, limit, found);
    for (const SlotPair& child : found) sort_out(child, arm);
    unfinished_ = !spend(work_to_open(found.count));
    if (work_of_build_ > plan_.most && !least_only_) shrink(candidates);
  }
  take(candidates);
  if (!candidates.fit) return clear(), false;
  if (unfinished_) return false;
  fill_last();
  room_ = planned_;
  return true;
}

void NeighbourList::append(const Pair& pair, const Due& due, const Vec3& normal) noexcept {
  const std::size_t k = count_ / block, lane = count_ % block;
  due_of_pair_[count_] = due;
  due_[k] = lane == 0
                ? due
                : Due{std::min(due_[k].distance, due.distance), std::max(due_[k].arm, due.arm)};
  items_[k].a[lane] = pair.a;
  items_[k].b[lane] = pair.b;
  const Corners ta = corners(surface(a_), pair.a);
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < 3; ++i)
      lanes_[k].arm[c][i][lane] = ta[c][static_cast<int>(i)] - a_.mass.com[static_cast<int>(i)];
  set_normal(static_cast<std::uint32_t>(count_++), normal);
}

void NeighbourList::fill_last() noexcept {
  if (count_ % block == 0) return;
  PairLanes& lanes = lanes_[count_ / block];
  const std::size_t last = count_ % block - 1;
  for (std::size_t lane = last + 1; lane < block; ++lane) {
    for (auto& corner : lanes.arm)
      for (auto& row : corner) row[lane] = row[last];
    for (auto& row : lanes.normal) row[lane] = row[last];
    lanes.top[lane] = lanes.top[last];
  }
}

}  // namespace sonde
