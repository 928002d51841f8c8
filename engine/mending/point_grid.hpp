// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/base/ordering.hpp"
#include "engine/geometry/pose.hpp"

namespace sonde {

/// Some of a list of points, in the cubes of a grid.
class PointGrid {
 public:
  /// @param cell Side of a cube, m, positive. Indices of cubes must fit in 21 bits along each axis
  /// from `low`; otherwise cubes coincide, which only costs time.
  PointGrid(const std::vector<Vec3>& points, const std::vector<std::uint32_t>& some,
            const Vec3& low, double cell)
      : low_(low), cell_(cell) {
    points_.reserve(some.size());
    for (const std::uint32_t i : some) points_.emplace_back(key(cube(points[i])), i);
    ordering::sort(points_.begin(), points_.end());
    slots_.assign(std::bit_ceil(2 * points_.size() + 1), none);
    for (std::uint32_t k = 0; k < points_.size(); ++k)
      if (k == 0 || points_[k].first != points_[k - 1].first)
        slots_[free_slot(points_[k].first)] = k;
  }

  /// Calls use(i) for the points in the cubes that a box touches, for some perhaps more than once.
  template <class Use>
  void each_within(const Vec3& low, const Vec3& high, Use use) const {
    const Cube from = cube(low), to = cube(high);
    for (std::int64_t x = from.x; x <= to.x; ++x)
      for (std::int64_t y = from.y; y <= to.y; ++y)
        for (std::int64_t z = from.z; z <= to.z; ++z) {
          const std::uint64_t wanted = key({x, y, z});
          for (std::uint32_t k = slots_[free_slot(wanted)];
               k < points_.size() && points_[k].first == wanted; ++k)
            use(points_[k].second);
        }
  }
  double cell() const { return cell_; }

 private:
  static constexpr std::uint32_t none = 0xffffffffu;
  struct Cube {
    std::int64_t x, y, z;
  };
  Cube cube(const Vec3& p) const {
    const Vec3 q = (p - low_) / cell_;
    return {static_cast<std::int64_t>(std::floor(q.x())),
            static_cast<std::int64_t>(std::floor(q.y())),
            static_cast<std::int64_t>(std::floor(q.z()))};
  }
  static std::uint64_t key(const Cube& c) {
    constexpr std::uint64_t most = (1u << 21) - 1;
    return (static_cast<std::uint64_t>(c.x) & most) << 42 |
           (static_cast<std::uint64_t>(c.y) & most) << 21 |
           (static_cast<std::uint64_t>(c.z) & most);
  }
  /// The slot that holds a cube's points, or where they would be inserted.
  std::size_t free_slot(std::uint64_t wanted) const {
    std::uint64_t h = (wanted ^ (wanted >> 30)) * 0xbf58476d1ce4e5b9u;
    h ^= h >> 31;
    std::size_t slot = h & (slots_.size() - 1);
    while (slots_[slot] != none && points_[slots_[slot]].first != wanted)
      slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }

  Vec3 low_;
  double cell_;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> points_;  // by the key of their cube
  std::vector<std::uint32_t> slots_;  // open addressing: the first point of a cube
};

}  // namespace sonde
