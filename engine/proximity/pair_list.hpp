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
/// trees pays for many small steps (after the neighbour lists of L. Verlet, 1967). How far a
/// triangle has moved is reckoned from a point of the probe, best one at the contacts: what is
/// there hardly moves while the probe rolls or turns, what is far from it is mostly far from the
/// fixed body too. Nothing here allocates but the constructor.
class PairList {
 public:
  static constexpr std::size_t enough = 16384;
  PairList(const Body& a, const Body& b, std::size_t capacity = enough);

  /// No point of A, r away from a point of it that is the centre, is further than linear + r·turn
  /// from where it was.
  struct Displacement {
    double linear = 0, turn = 0;  // m, rad
    double of(double arm) const { return linear + arm * turn; }
  };
  /// Along a motion, at most; at s of it, by no more than s times that.
  static Displacement along(const Motion& motion, const Vec3& centre) noexcept;

  /// Takes down every pair at a distance of at most room.of(its arm) at X, the arm being that of
  /// the triangle of A about the centre (A's mesh frame). False (and an empty list) where there are
  /// more than it holds, or the effort ran out.
  bool build(const Transform& X, const Vec3& centre, const Displacement& room,
             Effort& effort) noexcept;
  /// Every pair that may be within reach at X.
  bool build(const Transform& X, double reach, Effort& effort) noexcept {
    return build(X, a_.mass.com, {reach, 0}, effort);
  }

  void clear() noexcept { count_ = 0, room_.linear = -1; }
  std::size_t size() const noexcept { return count_; }
  std::size_t capacity() const noexcept { return items_.size(); }

  /// Every pair at a distance of at most this, at X, is in the list. Negative: no statement.
  double reach_at(const Transform& X) const noexcept { return reach_after(X, {}); }
  /// Is every pair that may come within the clearance along the motion?
  bool covers(const Motion& motion, double clearance) const noexcept;

  /// As near_pairs and sweep; the reach must lie within reach_at, the motion must be covered.
  NearPairs near(const Transform& X, double reach, std::span<NearPair> out,
                 Effort& effort) noexcept;
  Sweep sweep_along(const Motion& motion, double clearance, Effort& effort) noexcept;

 private:
  struct Item {
    std::uint32_t a, b;
    Vec3 normal;  ///< the last direction found to separate it; zero: none yet
  };
  /// The distance last known, and all that had been used up of it then, m: an item is not looked at
  /// until what is spare draws to an end. The longer the arm (of the triangle of A, from the
  /// centre), the more a turn uses up.
  struct Due {
    double distance, arm;
  };
  double reach_after(const Transform& X, const Displacement& more) const noexcept;
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

  const Body& a_;
  const Body& b_;
  std::vector<Item> items_;
  std::vector<Due> due_;
  std::vector<Due> groups_;  // what is least in each group of items
  std::size_t count_ = 0;
  Vec3 centre_;  // A's mesh frame
  double longest_arm_ = 0;
  Displacement room_;  // of the list; linear negative: there is none
  Transform X_;        // of the list
  Transform last_;     // the pose last looked at
  double linear_ = 0;  // m: of the centre, from pose to pose looked at
  double turned_ = 0;  // rad, in the same way
};

}  // namespace sonde
