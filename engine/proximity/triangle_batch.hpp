// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "engine/proximity/placement.hpp"
#include "engine/proximity/triangle_lanes.hpp"

namespace sonde {

/// Pairs of triangles of two bodies, eight of which are compared at a time.
class TriangleBatch {
 public:
  TriangleBatch(const Body& a, const Body& b, const Transform& X_BA) : a_(a), b_(b), X_(X_BA) {}

  bool full() const { return count_ == static_cast<int>(triangles_.size()); }
  bool empty() const { return count_ == 0; }

  /// Not while it is full.
  void add(std::uint32_t i, std::uint32_t j) {
    set_lane(pairs_, count_, place(X_, corners(a_.soup, i)), corners(b_.soup, j));
    triangles_[static_cast<std::size_t>(count_++)] = {i, j};
  }

  /// Compares them and calls visit(i, j, lane, points) for each pair no further apart than the
  /// limit; the batch is empty then.
  template <class Visit>
  void flush(double limit, const Visit& visit) {
    if (count_ == 0) return;
    closest_points(pairs_, count_, limit, points_);
    for (int k = 0; k < count_; ++k)
      if (points_.distance[k] <= limit) {
        const Pair& pair = triangles_[static_cast<std::size_t>(k)];
        visit(pair.i, pair.j, k, points_);
      }
    count_ = 0;
  }

 private:
  struct Pair {
    std::uint32_t i, j;
  };
  const Body& a_;
  const Body& b_;
  const Transform& X_;
  int count_ = 0;
  std::array<Pair, 8> triangles_;
  TrianglePairs8 pairs_;
  ClosestPoints8 points_;
};

}  // namespace sonde
