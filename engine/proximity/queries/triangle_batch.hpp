// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "engine/base/recent.hpp"
#include "engine/geometry/transform.hpp"
#include "engine/proximity/queries/near_pairs.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/triangles/triangle_lanes.hpp"

namespace sonde {

/// Pairs of triangles of two bodies, compared eight at a time.
class TriangleBatch {
 public:
  static constexpr int work = 5;  ///< to compare one pair, in units of Effort

  TriangleBatch(const Body& a, const Body& b, const Transform& X_BA) : a_(a), b_(b), X_(X_BA) {}

  struct Pair {
    std::uint32_t i, j;
    std::uint32_t tag;  // the caller's identifier
  };

  bool full() const { return count_ == static_cast<int>(pairs_.size()); }
  bool empty() const { return count_ == 0; }
  int size() const { return count_; }

  /// @pre The batch is not full.
  void add(std::uint32_t i, std::uint32_t j, std::uint32_t tag = 0) {
    add({i, j, tag}, placed(i), corners(surface(b_), j));
  }
  void add(const Pair& pair, const Corners& a, const Corners& b) {
    set_lane(lanes_, count_, a, b);
    pairs_[static_cast<std::size_t>(count_++)] = pair;
  }

  /// Compares the pairs, calls visit(pair, lane, points) for each, even if its distance is beyond
  /// the limit, and empties the batch.
  template <class Visit>
  void flush(double limit, const Visit& visit) {
    if (count_ == 0) return;
    closest_points(lanes_, count_, limit, points_);
    for (int k = 0; k < count_; ++k) visit(pairs_[static_cast<std::size_t>(k)], k, points_);
    count_ = 0;
  }

 private:
  /// Caches placed triangles: a query compares the same triangle of A with several triangles of B
  /// in a row, and then its neighbours, which are next to it in the order of the tree.
  const Corners& placed(std::uint32_t i) {
    return placed_.at(i, [&](std::uint32_t k) { return place(X_, corners(surface(a_), k)); });
  }

  const Body& a_;
  const Body& b_;
  const Transform& X_;
  Recent<Corners> placed_;
  int count_ = 0;
  std::array<Pair, 8> pairs_;
  TrianglePairs8 lanes_;
  ClosestPoints8 points_;
};

inline NearPair near_pair(const TriangleBatch::Pair& pair, int lane, const ClosestPoints8& p) {
  return {on_a(p, lane), on_b(p, lane), normal(p, lane), p.gap[lane], pair.i, pair.j};
}

}  // namespace sonde
