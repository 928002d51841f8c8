// SPDX-License-Identifier: GPL-3.0-or-later
// Construction of a neighbour list.
#include <array>
#include <utility>

#include "engine/base/recent.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/queries/triangle_batch.hpp"
#include "engine/proximity/sweep/neighbour_list.hpp"

namespace sonde {
namespace {

constexpr int work_to_take = 4;  // to add one pair, in units of Effort

}  // namespace

NeighbourList::BoxMotion NeighbourList::box_motion(std::uint32_t slot) const noexcept {
  const Vec3 to_center = a_.tree.center(slot) - centre_;
  const double half = a_.tree.half_diagonal(slot);
  const Course& course = planned_.ahead;
  return {to_center.norm() * (1 + 1e-6) + half, course.of(X_.R * to_center),
          course.turn.norm() * half * (1 + 1e-6)};
}

bool NeighbourList::is_in_plan(const Pair& pair, const BlockBound& due,
                               const Vec3& normal) const noexcept {
  const double room = planned_.around.of(due.arm);
  if (due.distance <= room || normal == Vec3::Zero()) return true;
  // Along the course, the gap along the normal changes by that of the corner that approaches most.
  const Course& course = planned_.ahead;
  const Vec3 per_arm = X_.R.transpose() * normal.cross(course.turn);
  const Corners ta = corners(surface(a_), pair.a);
  const double turned = std::min(
      {per_arm.dot(ta[0] - centre_), per_arm.dot(ta[1] - centre_), per_arm.dot(ta[2] - centre_)});
  const double gap = gap_along(normal, place(X_, ta), corners(surface(b_), pair.b));
  return gap * (1 - 1e-12) - guard(X_) + std::min(0.0, normal.dot(course.linear) + turned) <= room;
}

/// Candidate pairs of triangles, compared eight at a time.
struct NeighbourList::Candidates {
  TriangleBatch batch;
  double rounding;                        // m
  std::array<BoxMotion, block> motion{};  // of the boxes that hold the triangles of A
  std::array<double, block> reach{};      // m: a pair further away cannot be added
  bool fit = true;                        // all pairs found so far fit
};

void NeighbourList::start(const Transform& X, const Vec3& centre) noexcept {
  clear();
  X_ = last_ = X;
  linear_ = turned_ = 0;
  centre_ = centre;
  work_of_build_ = 0;
  longest_arm_ = ((centre - a_.mass.com).norm() + a_.mass.radius) * (1 + 1e-12);
}

void NeighbourList::append_covered(Candidates& of) noexcept {
  const double widest = *std::max_element(of.reach.begin(), of.reach.end());
  of.batch.flush(widest + 2 * of.rounding, [&](const TriangleBatch::Pair& pair, int lane,
                                               const ClosestPoints8& points) {
    const double distance = points.distance[lane] * (1 - 1e-12) - of.rounding;
    const auto& [arm, shift, spread] = of.motion[static_cast<std::size_t>(lane)];
    if (distance > of.reach[static_cast<std::size_t>(lane)] || !of.fit) return;
    const Vec3 direction = points.distance[lane] > 0 ? normal(points, lane) : Vec3::Zero();
    const double gap = points.gap[lane] * (1 - 1e-12) - of.rounding;
    const double closing = std::max(0.0, -direction.dot(shift)) + spread;
    if (std::min(distance, gap - closing) > planned_.around.of(arm)) return;
    const Pair of_lane{pair.i, pair.j};
    if (count_ == capacity_ && !fallback_only_) {
      fall_back();
      if (!is_in_plan(of_lane, {distance, arm}, direction)) return;
    }
    of.fit = count_ < capacity_;
    if (of.fit) append(of_lane, {distance, arm}, direction);
  });
}

void NeighbourList::fall_back() noexcept {
  planned_ = plan_.fallback;
  fallback_only_ = true;
  const std::size_t found = std::exchange(count_, 0);
  for (std::size_t i = 0; i < found; ++i) {
    const BlockBound due = pair_bounds_[i];
    const Pairs& of_block = items_[i / block];
    const Pair pair{of_block.a[i % block], of_block.b[i % block]};
    const Vec3 normal = normal_of(static_cast<std::uint32_t>(i));
    if (is_in_plan(pair, due, normal)) append(pair, due, normal);
  }
}

bool NeighbourList::build_by(const BuildPlan& plan, const Transform& X, const Vec3& centre,
                             Effort& effort) noexcept {
  start(X, centre);
  plan_ = plan;
  // The initial search also covers the fallback.
  DisplacementBound& around = plan_.wanted.around;
  around = {std::max(around.linear, plan.fallback.around.linear),
            std::max(around.turn, plan.fallback.around.turn)};
  planned_ = plan_.wanted;
  const auto length = [&](const Coverage& room) {
    return room.around.of(longest_arm_) + room.ahead.size().of(longest_arm_);
  };
  fallback_only_ = length(planned_) <= length(plan.fallback);
  if (to_visit_.empty()) return false;
  to_visit_.front().clear();
  to_visit_.front().push(roots(a_.tree, b_.tree));
  return go_on(effort);
}

bool NeighbourList::go_on(Effort& effort) noexcept {
  Placement at(a_, b_, X_);
  SlotPairs found;
  Recent<BoxMotion> motions;
  Candidates candidates{{a_, b_, X_}, guard(X_)};
  const auto spend = [&](int work) { return work_of_build_ += work, effort.spend(work); };
  // Pairs found below a pair use the arm of its box of A, which is longer than theirs.
  const auto sort_out = [&](const SlotPair& p, const BoxMotion& motion) {
    if (!at.is_leaf(p)) return to_visit_.front().push(p);
    spend(work_to_take);
    const auto lane = static_cast<std::size_t>(candidates.batch.size());
    candidates.motion[lane] = motion;
    candidates.reach[lane] = planned_.around.of(motion.arm) + motion.shift.norm() + motion.spread;
    candidates.batch.add(at.triangle_a(p), at.triangle_b(p));
    if (candidates.batch.full()) append_covered(candidates);
  };
  unfinished_ = false;
  while (candidates.fit && !unfinished_ && !to_visit_.front().empty()) {
    const SlotPair p = to_visit_.front().pop();
    const BoxMotion motion = motions.at(p.a, [&](std::uint32_t slot) { return box_motion(slot); });
    const float limit = at.to_unit_rounded_up(planned_.around.of(motion.arm)),
                spread = at.to_unit_rounded_up(motion.spread);
    if (p.bound > limit) continue;
    if (at.is_leaf(p)) {  // only if the roots are leaves
      sort_out(p, motion);
      continue;
    }
    // All points in the box of A follow its displacement to within the spread.
    at.open_shifted(p, motion.shift, limit + spread, found);
    for (SlotPair& child : found) child.bound -= spread, sort_out(child, motion);
    unfinished_ = !spend(work_to_open(found.count));
    if (work_of_build_ > plan_.most_work && !fallback_only_) {
      append_covered(candidates);
      fall_back();
      motions = {};
    }
  }
  append_covered(candidates);
  if (!candidates.fit) return clear(), false;
  if (unfinished_) return false;
  fill_last();
  coverage_ = planned_;
  return true;
}

void NeighbourList::append(const Pair& pair, const BlockBound& due, const Vec3& normal) noexcept {
  const std::size_t k = count_ / block, lane = count_ % block;
  pair_bounds_[count_] = due;
  block_bounds_[k] = lane == 0 ? due
                               : BlockBound{std::min(block_bounds_[k].distance, due.distance),
                                            std::max(block_bounds_[k].arm, due.arm)};
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
