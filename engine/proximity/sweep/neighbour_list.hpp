// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "engine/body/body.hpp"
#include "engine/proximity/queries/near_pairs.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/queries/violation.hpp"
#include "engine/proximity/sweep/course.hpp"
#include "engine/proximity/sweep/motion.hpp"
#include "engine/proximity/sweep/pair_sweep.hpp"
#include "engine/proximity/sweep/sweep.hpp"
#include "engine/proximity/triangles/pair_lanes.hpp"

namespace sonde {

/// The pairs of triangles that were within a reach of each other at one pose. As long as the probe
/// has moved by less than that, near pairs and sweeps need to look at these alone: a walk of the
/// trees pays for many small steps (after the neighbour lists of L. Verlet, 1967). How far a
/// triangle has moved is reckoned from a point of the probe, best one at the contacts: what is
/// there hardly moves while the probe rolls or turns, what is far from it is mostly far from the
/// fixed body too. Nothing here allocates but the constructor.
class NeighbourList {
 public:
  static constexpr std::size_t enough = 8192;
  NeighbourList(const Body& a, const Body& b, std::size_t capacity = enough);

  /// What a list is to hold: every pair that comes within around.of(its arm) on the course, the arm
  /// being that of the triangle of A about the centre. A probe that slides goes on as it went: a
  /// list for its course is a part of one for every way that is as long, and serves as long.
  struct Room {
    Displacement around;
    Course ahead = {};
  };
  /// How much room a list is to have: as much as `ample`, or where it turns out on the way that
  /// this takes more work than `most` or more pairs than fit, no more than `least`. What was found
  /// by then serves: no list is begun anew.
  struct Plan {
    Room ample;
    Room least;  ///< its course a part of ample's
    std::int64_t most = std::numeric_limits<std::int64_t>::max();
  };

  /// Takes down every pair of the room at X, the centre being in A's mesh frame. False (and nothing
  /// is covered) where there are more than it holds, or the effort ran out: then go_on() can finish
  /// it, some other time.
  bool build_by(const Plan& plan, const Transform& X, const Vec3& centre, Effort& effort) noexcept;
  bool build(const Transform& X, const Vec3& centre, const Displacement& room,
             Effort& effort) noexcept {
    return build_by({{room}, {room}}, X, centre, effort);
  }
  /// Every pair that may be within reach at X.
  bool build(const Transform& X, double reach, Effort& effort) noexcept {
    return build(X, a_.mass.com, {reach, 0}, effort);
  }

  bool go_on(Effort& effort) noexcept;
  bool is_unfinished() const noexcept { return unfinished_; }
  /// As reach_at, on all of a path from X, of the list once it is finished.
  double reach_when_finished(const Transform& X, const Path& path) const noexcept {
    return planned_.around.linear < 0 ? -1 : left(planned_, X, path);
  }

  void clear() noexcept {
    count_ = 0, unfinished_ = false;
    room_.around.linear = planned_.around.linear = -1;
  }
  std::size_t size() const noexcept { return count_; }
  std::size_t capacity() const noexcept { return capacity_; }
  /// Has the last list no more room than the least of its plan?
  bool is_least() const noexcept { return least_only_; }
  /// What the last list took to make, in the units of Effort.
  std::int64_t work_of_build() const noexcept { return work_of_build_; }

  /// Every pair at a distance of at most this, at X and on all of the path from there, is in the
  /// list. Negative: no statement.
  double reach_at(const Transform& X, const Path& path = {}) const noexcept {
    return room_.around.linear < 0 ? -1 : left(room_, X, path);
  }
  /// Is every pair that may come within the clearance along the motion?
  bool covers(const Motion& motion, double clearance) const noexcept;

  /// As near_pairs and sweep; the reach must lie within reach_at, the motion must be covered.
  NearPairs near(const Transform& X, double reach, std::span<NearPair> out,
                 Effort& effort) noexcept;
  Sweep sweep_along(const Motion& motion, double clearance, Effort& effort) noexcept;

  /// The pairs that are nearer than `least` at X or meet, the deepest of them where there are more
  /// than fit; X must be covered (reach_at). The probe stays where it is. Returns how many.
  std::size_t violations(const Transform& X, double least, std::span<Violation> out,
                         Effort& effort) noexcept;

 private:
  static constexpr std::size_t block = 8;  ///< pairs that are looked at together
  struct Pair {
    std::uint32_t a, b;  ///< triangles
  };
  struct Pairs {
    std::uint32_t a[block], b[block];
  };
  /// The least distance of a block's pairs last known, and all that had been used up of it then, m:
  /// a block is not looked at until what is spare draws to an end. The longer the arm (of the
  /// triangles of A, from the centre), the more a turn uses up.
  struct Due {
    double distance, arm;
  };
  /// A pair that was not found clear of a path by the direction that separated it last.
  struct Open {
    std::uint32_t item;
    double until;  ///< of the path: about where it may be stopped
  };
  double left(const Room& room, const Transform& X, const Path& path) const noexcept;
  /// What rounding may add to a distance at either pose, m.
  double guard(const Transform& X) const noexcept;
  /// The probe has come to X.
  void travel_to(const Transform& X) noexcept;
  /// What is left of the distance that it was last known to have, m.
  double spare(const Due& d) const noexcept { return d.distance - linear_ - d.arm * turned_; }
  std::size_t blocks() const noexcept { return (count_ + block - 1) / block; }
  std::size_t size_of(std::size_t k) const noexcept { return std::min(block, count_ - k * block); }
  /// Calls visit(block) for all that may come within so much on the way that is ahead.
  template <class Visit>
  void each_due(const Displacement& ahead, double within, const Visit& visit) const noexcept;
  struct Candidates;
  /// Of a box of A where it goes on the planned course.
  struct Way {
    double arm = 0;           ///< m
    Vec3 way = Vec3::Zero();  ///< of its centre, m, fixed frame
    double spread = 0;        ///< m: no point of the box goes further from that
  };
  Way way_of(std::uint32_t slot) const noexcept;
  /// Does a pair come into the planned room, where it is known how far it is away, and along which
  /// direction (zero: none)?
  bool comes_in(const Pair& pair, const Due& due, const Vec3& normal) const noexcept;
  void start(const Transform& X, const Vec3& centre) noexcept;
  /// Takes down those of them that are near enough.
  void take(Candidates& of) noexcept;
  /// Goes on with the least room: the pairs that are beyond it are dropped.
  void shrink() noexcept;
  /// Takes down a pair, and the direction that separates it where the probe is (zero: none).
  void append(const Pair& pair, const Due& due, const Vec3& normal) noexcept;
  /// Lanes that are not used repeat the last one.
  void fill_last() noexcept;
  Vec3 normal_of(std::uint32_t item) const noexcept;
  void set_normal(std::uint32_t item, const Vec3& normal) noexcept;
  /// Takes down the least gap found in a block where the probe is.
  void learn(std::size_t k, double gap, double rounding) noexcept;
  /// Follows the pairs that are not clear of the path by what is known of them.
  void follow(std::span<const Open> open, PairSweep& pairs, const Displacement& ahead,
              Effort& effort) noexcept;

  const Body& a_;
  const Body& b_;
  std::vector<Pairs> items_;
  std::vector<PairLanes> lanes_;
  std::vector<Due> due_;
  std::vector<Due> due_of_pair_;  // of a list that is being made
  std::vector<Open> open_;
  std::size_t count_ = 0;
  std::size_t capacity_;
  std::int64_t work_of_build_ = 0;
  Vec3 centre_;  // A's mesh frame
  double longest_arm_ = 0;
  Room room_;                // of the list; around.linear negative: there is none
  Room planned_;             // of the list that is being made
  Plan plan_;                // for it
  bool least_only_ = false;  // nothing is planned but the least
  std::unique_ptr<PairStack<SlotPair>> to_visit_;  // for it; large; none for no pairs
  bool unfinished_ = false;
  Transform X_;        // of the list
  Transform last_;     // the pose last looked at
  double linear_ = 0;  // m: of the centre, from pose to pose looked at
  double turned_ = 0;  // rad, in the same way
};

}  // namespace sonde
