// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/body.hpp"
#include "engine/proximity/motion.hpp"
#include "engine/proximity/near_pairs.hpp"
#include "engine/proximity/sweep.hpp"

namespace sonde {

/// The pairs of triangles that were within a reach of each other at one pose. As long as the probe
/// has moved by less than that, near pairs and sweeps need to look at these alone: a walk of the
/// trees pays for many small steps (after the neighbour lists of L. Verlet, 1967). Nothing here
/// allocates but the constructor.
class PairList {
 public:
  static constexpr std::size_t enough = 16384;
  PairList(const Body& a, const Body& b, std::size_t capacity = enough);

  /// Takes down every pair that may be within reach at X. False (and an empty list) where there are
  /// more than it holds.
  bool build(const Transform& X, double reach) noexcept;

  void clear() noexcept { count_ = 0, reach_ = -1; }
  std::size_t capacity() const noexcept { return items_.size(); }

  /// Every pair at a distance of at most this, at X, is in the list. Negative: no statement.
  double reach_at(const Transform& X) const noexcept;

  /// As near_pairs and sweep; the reach (and the path with the clearance) must lie within reach_at.
  NearPairs near(const Transform& X, double reach, std::span<NearPair> out) noexcept;
  Sweep sweep_along(const Motion& motion, double clearance) noexcept;

 private:
  struct Item {
    std::uint32_t a, b;
    Vec3 normal;  ///< the last direction found to separate it; zero: none yet
  };
  /// How far any point of A may be at X from where it is at another pose, m.
  double displacement(const Transform& from, const Transform& X) const noexcept;
  /// What rounding may add to a distance at either pose, m.
  double guard(const Transform& X) const noexcept;
  /// The travel when the probe has come to X.
  double travel_to(const Transform& X) noexcept;
  /// Takes down what was found out about an item at the present travel.
  void learn(std::size_t item, double distance, double rounding) noexcept;
  /// Separates those items that no direction is known for and that may come within so much.
  void find_normals(const Transform& X, double within) noexcept;

  const Body& a_;
  const Body& b_;
  std::vector<Item> items_;
  /// Of each item, the travel before which its triangles cannot meet: it is not looked at until
  /// that draws near.
  std::vector<double> due_;
  std::size_t count_ = 0;
  Transform X_;        // of the list
  Transform last_;     // the pose last looked at
  double travel_ = 0;  // m: from pose to pose looked at, since the list was made
  double reach_ = -1;
};

}  // namespace sonde
