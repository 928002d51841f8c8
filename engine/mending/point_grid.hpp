// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "engine/geometry/pose.hpp"

namespace sonde {

/// Some of a list of points, in cubes of a grid.
class PointGrid {
 public:
  /// @param cell Side of a cube, m, positive. The numbers of the cubes must fit 21 bits along each
  /// axis from `low`: others share a cube, which costs time alone.
  PointGrid(const std::vector<Vec3>& points, const std::vector<std::uint32_t>& some,
            const Vec3& low, double cell)
      : low_(low), cell_(cell) {
    for (const std::uint32_t i : some) cubes_[key(cube(points[i]))].push_back(i);
  }

  /// Calls use(i) for the points in the cubes that a box touches, some perhaps more than once.
  template <class Use>
  void each_within(const Vec3& low, const Vec3& high, Use use) const {
    const Cube from = cube(low), to = cube(high);
    for (std::int64_t x = from.x; x <= to.x; ++x)
      for (std::int64_t y = from.y; y <= to.y; ++y)
        for (std::int64_t z = from.z; z <= to.z; ++z)
          if (const auto found = cubes_.find(key({x, y, z})); found != cubes_.end())
            for (const std::uint32_t i : found->second) use(i);
  }
  double cell() const { return cell_; }

 private:
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

  Vec3 low_;
  double cell_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cubes_;
};

}  // namespace sonde
