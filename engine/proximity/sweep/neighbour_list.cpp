// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/sweep/neighbour_list.hpp"

#include <array>

#include "engine/base/numbers.hpp"
#include "engine/base/ordering.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/queries/triangle_batch.hpp"

namespace sonde {
namespace {

// Units of Effort: for a block of pairs, and for one pair.
constexpr int work_to_look = 5, work_to_advance = 20;

/// The position of the centre of mass, and the rotation of arms from it.
ArmMap arms_at(const Body& a, const Transform& X) { return arm_map(X.R, X * a.mass.com); }

}  // namespace

std::size_t NeighbourList::enough(const Body& a, const Body& b) {
  constexpr std::size_t least = 32'768, most = 131'072, per_triangle = 8;
  return std::clamp(per_triangle * (surface(a).triangles.size() + surface(b).triangles.size()),
                    least, most);
}

NeighbourList::NeighbourList(const Body& a, const Body& b, std::size_t capacity)
    : a_(a),
      b_(b),
      items_((capacity + block - 1) / block),
      lanes_(items_.size()),
      block_bounds_(items_.size()),
      pair_bounds_(capacity),
      unproven_(capacity),
      capacity_(capacity),
      centre_(a.mass.com),
      to_visit_(capacity > 0 ? 1 : 0) {
  clear();
}

void NeighbourList::travel_to(const Transform& X) noexcept {
  const DisplacementBound more = displacement_bound(last_, X, centre_);
  linear_ += more.linear * (1 + 1e-12);
  turned_ += more.turn * (1 + 1e-12);
  last_ = X;
  // Travel that is long compared with the reach would make the stored distances inaccurate.
  if (linear_ + turned_ * longest_arm_ >
      1e3 * (coverage_.around.of(longest_arm_) + coverage_.ahead.size().of(longest_arm_))) {
    for (std::size_t k = 0; k < blocks(); ++k) block_bounds_[k].distance = 0;
    linear_ = turned_ = 0;
  }
}

double NeighbourList::guard(const Transform& X) const noexcept {
  // Arms are relative to the centre of mass, which may lie far outside the mesh.
  return rounding_guard(extent(a_) + a_.mass.com.norm(), extent(b_),
                        X.p.cwiseAbs().cwiseMax(X_.p.cwiseAbs()));
}

double NeighbourList::left(const Coverage& room, const Transform& X,
                           const LinearizedMotion& path) const noexcept {
  // The minimum over all arms. Distances are rounded at the list's pose and again at this one.
  const DisplacementBound off = deviation(X_, room.ahead, X, path, centre_, longest_arm_);
  const DisplacementBound left{room.around.linear - off.linear, room.around.turn - off.turn};
  return std::min(left.linear, left.of(longest_arm_)) - 2 * guard(X);
}

bool NeighbourList::covers(const Motion& motion, double clearance) const noexcept {
  return reach_at(motion.at(0), linearized(motion, centre_)) > clearance;
}

void NeighbourList::learn(std::size_t k, double gap, double rounding) noexcept {
  BlockBound& due = block_bounds_[k];
  const double used_up = linear_ + due.arm * turned_;
  due.distance = std::max(due.distance, used_up + gap * (1 - 1e-12) - rounding);
}

template <class Visit>
void NeighbourList::each_due(const DisplacementBound& ahead, double within,
                             const Visit& visit) const noexcept {
  for (std::size_t k = 0; k < blocks(); ++k) {
    if (spare(block_bounds_[k]) > within + ahead.of(block_bounds_[k].arm)) continue;
    visit(k);
  }
}

Vec3 NeighbourList::normal_of(std::uint32_t item) const noexcept {
  const PairLanes& lanes = lanes_[item / block];
  const std::size_t k = item % block;
  return {lanes.normal[0][k], lanes.normal[1][k], lanes.normal[2][k]};
}

void NeighbourList::set_normal(std::uint32_t item, const Vec3& normal) noexcept {
  PairLanes& lanes = lanes_[item / block];
  const std::size_t lane = item % block;
  const Corners tb = corners(surface(b_), items_[item / block].b[lane]);
  for (std::size_t i = 0; i < 3; ++i) lanes.normal[i][lane] = normal[static_cast<int>(i)];
  lanes.top[lane] = std::max({normal.dot(tb[0]), normal.dot(tb[1]), normal.dot(tb[2])});
}

NearPairs NeighbourList::near(const Transform& X, double reach, std::span<NearPair> out,
                              Effort& effort) noexcept {
  travel_to(X);
  const double rounding = guard(X);
  const ArmMap at = arms_at(a_, X);
  TriangleBatch batch(a_, b_, X);
  std::size_t found = 0;
  const auto look = [&] {
    effort.spend(TriangleBatch::work * batch.size());
    batch.flush(infinity,
                [&](const TriangleBatch::Pair& pair, int k, const ClosestPoints8& points) {
                  if (!(points.distance[k] > 0)) return;
                  // The direction that is known for the pair says too little: the next look would
                  // compare the pair again, and a limit that ends this look would end that one too.
                  if (points.distance[k] > reach) return set_normal(pair.tag, normal(points, k));
                  const NearPair near = near_pair(pair, k, points);
                  if (found == out.size()) found = keep_nearer_half(out, reach);
                  out[found++] = near;
                });
  };
  each_due({}, reach + rounding, [&](std::size_t k) {
    if (!effort.spend(work_to_look)) return;
    alignas(64) double gap[block];
    gaps_at(lanes_[k], at, gap);
    learn(k, *std::min_element(gap, gap + block), rounding);
    for (std::size_t lane = 0; lane < size_of(k); ++lane) {
      if (gap[lane] > reach + rounding) continue;
      batch.add(items_[k].a[lane], items_[k].b[lane], static_cast<std::uint32_t>(k * block + lane));
      if (batch.full()) look();
    }
  });
  look();
  if (effort.is_spent()) return {0, -1};
  return {found, reach};
}

std::size_t NeighbourList::violations(const Transform& X, double least, std::span<Violation> out,
                                      Effort& effort) noexcept {
  const double rounding = guard(X);
  const ArmMap at = arms_at(a_, X);
  const auto deeper = [](const Violation& x, const Violation& y) { return x.gap < y.gap; };
  std::size_t found = 0;
  TriangleBatch batch(a_, b_, X);
  std::array<double, block> along{};  // gaps of the pairs in the batch
  const auto look = [&] {
    effort.spend(TriangleBatch::work * batch.size());
    batch.flush(least, [&](const TriangleBatch::Pair& pair, int k, const ClosestPoints8& points) {
      if (points.distance[k] > least) return;
      const double known = std::min(0.0, along[static_cast<std::size_t>(k)]);
      const Violation one{pair.i, pair.j, points.distance[k] > 0 ? points.gap[k] : known};
      if (found == out.size()) {
        if (!deeper(one, out[0])) return;
        ordering::pop_heap(out.begin(), out.end(), deeper);
        --found;
      }
      out[found++] = one;
      ordering::push_heap(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(found), deeper);
    });
  };
  each_due(displacement_bound(last_, X, centre_), least + rounding, [&](std::size_t k) {
    if (!effort.spend(work_to_look)) return;
    alignas(64) double gap[block];
    gaps_at(lanes_[k], at, gap);
    for (std::size_t lane = 0; lane < size_of(k); ++lane) {
      if (gap[lane] > least + rounding) continue;
      along[static_cast<std::size_t>(batch.size())] = gap[lane];
      batch.add(items_[k].a[lane], items_[k].b[lane]);
      if (batch.full()) look();
    }
  });
  look();
  return found;
}

Sweep NeighbourList::sweep_along(const Motion& motion, double clearance, Effort& effort) noexcept {
  PairSweep pairs(a_, b_, motion, clearance);
  travel_to(pairs.start().X);
  const double rounding = guard(pairs.start().X), room = clearance + pairs.guard();
  const DisplacementBound ahead = displacement_bound_along(motion, centre_);
  const ArmMap from = arms_at(a_, pairs.start().X), to = arms_at(a_, pairs.end());
  const ArmMap bend = arm_map(motion.bend(), Vec3::Zero());
  std::size_t open = 0;
  each_due(ahead, room, [&](std::size_t k) {
    if (!effort.spend(2 * work_to_look)) {
      const double known =
          (spare(block_bounds_[k]) - room) / std::max(ahead.of(block_bounds_[k].arm), 1e-300);
      return pairs.give_up(std::max(0.0, known * (1 - 1e-12)));
    }
    PathLanes path;
    gaps_along(lanes_[k], from, to, bend, path);
    learn(k, *std::min_element(path.from, path.from + block), rounding);
    for (std::size_t lane = 0; lane < size_of(k); ++lane) {
      const double floor = pairs.floor_of(path.from[lane]);
      if (stays_above(path.from[lane] - floor, path.to[lane] - floor,
                      pairs.hangs_by(path.bend[lane])))
        continue;
      const double room = path.from[lane] - floor, used = path.from[lane] - path.to[lane];
      unproven_[open++] = {static_cast<std::uint32_t>(k * block + lane), room <= 0     ? 0
                                                                         : room < used ? room / used
                                                                                       : 1};
    }
  });
  // The pairs that may stop the path soonest come first: the others must then be clear only up to
  // that stop.
  const auto first = unproven_.begin(), last = first + static_cast<std::ptrdiff_t>(open);
  const auto few = first + static_cast<std::ptrdiff_t>(std::min(open, block));
  ordering::partial_sort(first, few, last, [](const UnprovenPair& x, const UnprovenPair& y) {
    return x.until != y.until ? x.until < y.until : x.item < y.item;
  });
  follow({unproven_.data(), open}, pairs, ahead, effort);
  return pairs.result();
}

void NeighbourList::follow(std::span<const UnprovenPair> open, PairSweep& pairs,
                           const DisplacementBound& ahead, Effort& effort) noexcept {
  const double clearance = pairs.clearance();
  TriangleBatch at_start(a_, b_, pairs.start().X), at_end(a_, b_, pairs.end());
  const auto passes = [&](const TriangleBatch::Pair& pair, const Vec3& n) {
    return pairs.is_clear_along(pair.i, pair.j, n);
  };
  // If an edge slides past an edge with little room, a surface normal separates the pair all along
  // the path, whereas the direction of its closest points changes sides.
  Vec3 hint = Vec3::Zero();
  const auto passes_over = [&](const TriangleBatch::Pair& pair) {
    const Corners ta = place(pairs.start().X, corners(surface(a_), pair.i));
    const Corners tb = corners(surface(b_), pair.j);
    for (const Vec3& way : {hint, area_normal(tb).normalized(), area_normal(ta).normalized()})
      for (const double side : {1.0, -1.0}) {
        const Vec3 n = side * way;
        if (!(gap_along(n, ta, tb) > 0) || !passes(pair, n)) continue;
        set_normal(pair.tag, n);
        hint = n;
        return true;
      }
    return false;
  };
  // From the direction at the start to the one at the end, or along one of the two that turns with
  // A: if a face of A slides past a corner of B, the normal of that face separates them all along.
  const Mat3 turn = pairs.end().R * pairs.start().X.R.transpose();
  const auto slides = [&](const TriangleBatch::Pair& pair, const Vec3& from, const Vec3& to) {
    const auto is_clear = [&](const Vec3& first, const Vec3& last) {
      return pairs.is_clear_between(pair.i, pair.j, 0, pairs.start(), first, last);
    };
    const bool starts = from != Vec3::Zero(), ends = to != Vec3::Zero();
    return (starts && ends && is_clear(from, to)) || (starts && is_clear(from, turn * from)) ||
           (ends && is_clear(turn.transpose() * to, to));
  };
  const auto look_at_end = [&] {
    effort.spend(TriangleBatch::work * at_end.size());
    at_end.flush(infinity, [&](const TriangleBatch::Pair& pair, int k, const ClosestPoints8& p) {
      if (p.distance[k] > 0 && passes(pair, normal(p, k)))
        return set_normal(pair.tag, normal(p, k));
      if (!effort.spend(work_to_advance)) {
        const BlockBound& due = block_bounds_[pair.tag / block];
        const double room = clearance + pairs.guard();
        const double known = (spare(due) - room) / std::max(ahead.of(due.arm), 1e-300);
        return pairs.give_up(std::max(0.0, known * (1 - 1e-12)));
      }
      Vec3 n = normal_of(pair.tag);
      if (slides(pair, n, p.distance[k] > 0 ? normal(p, k) : Vec3::Zero())) return;
      double from = 0;
      if (n != Vec3::Zero()) {
        const PairSweep::Step step = pairs.step_along(pair.i, pair.j, n, pairs.start());
        if (step.gap > 2 * clearance) from = step.length;
      }
      if (from < pairs.free_until()) effort.spend(pairs.advance(pair.i, pair.j, from, n));
    });
  };
  const auto look_at_start = [&] {
    effort.spend(TriangleBatch::work * at_start.size());
    at_start.flush(infinity, [&](const TriangleBatch::Pair& pair, int k, const ClosestPoints8& p) {
      for (int i = 0; k == 0 && i < at_start.size(); ++i) pairs.saw_at_start(p.distance[i]);
      if (p.distance[k] > 0) {
        set_normal(pair.tag, normal(p, k));
        if (passes(pair, normal(p, k)) || passes_over(pair)) return;
      }
      at_end.add(pair, place(pairs.end(), corners(surface(a_), pair.i)),
                 corners(surface(b_), pair.j));
      if (at_end.full()) look_at_end();
    });
  };
  std::size_t looked_at = 0;
  for (const UnprovenPair& one : open) {
    const Pairs& of = items_[one.item / block];
    const TriangleBatch::Pair pair{of.a[one.item % block], of.b[one.item % block], one.item};
    const Vec3 n = normal_of(one.item);
    if (pairs.free_until() < 1 && n != Vec3::Zero() && passes(pair, n)) continue;
    at_start.add(pair, place(pairs.start().X, corners(surface(a_), pair.i)),
                 corners(surface(b_), pair.j));
    // The first pair is decided before any other is examined: the others must be clear only up to
    // its stop.
    if (at_start.full() || ++looked_at == 1) look_at_start(), look_at_end();
  }
  look_at_start();
  look_at_end();
}

}  // namespace sonde
