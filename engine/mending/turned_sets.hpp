// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace sonde {

/// Disjoint sets of indices, each identified by its lowest. An element may be turned relative to
/// that one.
class TurnedSets {
 public:
  explicit TurnedSets(std::size_t n) : parent_(n), turned_(n, false) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  struct Place {
    std::uint32_t set;
    bool turned;
  };
  Place find(std::uint32_t i) {
    std::uint32_t root = i;
    bool turned = false;
    while (parent_[root] != root) {
      turned ^= turned_[root];
      root = parent_[root];
    }
    for (bool left = turned; parent_[i] != i && i != root;) {  // path compression
      const bool own = turned_[i];
      turned_[i] = left;
      left ^= own;
      i = std::exchange(parent_[i], root);
    }
    return {root, turned};
  }
  /// Returns false if they are already in one set with the other relative orientation.
  bool join(std::uint32_t a, std::uint32_t b, bool turned = false) {
    const Place x = find(a), y = find(b);
    const bool way = x.turned ^ y.turned ^ turned;
    if (x.set == y.set) return !way;
    const std::uint32_t low = std::min(x.set, y.set), high = std::max(x.set, y.set);
    parent_[high] = low;
    turned_[high] = way;
    return true;
  }
  std::uint32_t set_of(std::uint32_t i) { return find(i).set; }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<bool> turned_;
};

}  // namespace sonde
