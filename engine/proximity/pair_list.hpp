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
  /// more than it holds, or the effort ran out.
  bool build(const Transform& X, double reach, Effort& effort) noexcept;

  void clear() noexcept { count_ = 0, reach_ = -1; }
  std::size_t size() const noexcept { return count_; }
  std::size_t capacity() const noexcept { return items_.size(); }

  /// Every pair at a distance of at most this, at X, is in the list. Negative: no statement.
  double reach_at(const Transform& X) const noexcept;

  /// As near_pairs and sweep; the reach (and the path with the clearance) must lie within reach_at.
  NearPairs near(const Transform& X, double reach, std::span<NearPair> out,
                 Effort& effort) noexcept;
  Sweep sweep_along(const Motion& motion, double clearance, Effort& effort) noexcept;

 private:
  struct Item {
    std::uint32_t a, b;
    Vec3 normal;  ///< the last direction found to separate it; zero: none yet
  };
  /// The distance last known, and all that had been used up of it then, m: an item is not looked at
  /// until what is spare draws to an end. The longer the arm (of the triangle of A, from the centre
  /// of mass), the more a turn uses up.
  struct Due {
    double distance, arm;
  };
  /// No point of A, r away from the centre of mass, is further than linear + r·turn at X from
  /// where it is at another pose.
  struct Displacement {
    double linear = 0, turn = 0;  // m, rad
    double of(double arm) const { return linear + arm * turn; }
  };
  Displacement displacement(const Transform& from, const Transform& X) const noexcept;
  /// What rounding may add to a distance at either pose, m.
  double guard(const Transform& X) const noexcept;
  /// The probe has come to X.
  void travel_to(const Transform& X) noexcept;
  /// What is left of the distance that it was last known to have, m.
  double spare(const Due& d) const noexcept { return d.distance - linear_ - d.arm * turned_; }
  /// Calls visit(item) for all that may come within so much on the way that is ahead.
  template <class Visit>
  void each_due(const Displacement& ahead, double within, const Visit& visit) noexcept;
  /// Takes down what was found out about an item at the present travel.
  void learn(std::size_t item, double distance, double rounding) noexcept;
  /// Separates those items that no direction is known for and that may come within so much.
  void find_normals(const Motion& motion, const Transform& X, double clearance,
                    Effort& effort) noexcept;

  const Body& a_;
  const Body& b_;
  std::vector<Item> items_;
  std::vector<Due> due_;
  std::vector<Due> groups_;   // what is least in each group of items
  std::vector<double> arms_;  // of A's triangles, m
  std::size_t count_ = 0;
  Transform X_;        // of the list
  Transform last_;     // the pose last looked at
  double linear_ = 0;  // m: of the centre of mass, from pose to pose looked at
  double turned_ = 0;  // rad, in the same way
  double reach_ = -1;
};

}  // namespace sonde
