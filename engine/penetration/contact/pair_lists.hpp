// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "engine/geometry/transform.hpp"
#include "engine/proximity/sweep/linearized_motion.hpp"
#include "engine/proximity/sweep/neighbour_list.hpp"
#include "engine/proximity/sweep/neighbour_reach.hpp"

namespace sonde {

/// The two neighbour lists of a probe (neighbour_list.hpp): the one in use, and the next one. If
/// the effort of ticks is limited, the next list is made in advance, with the effort that ticks
/// leave over. (A list may cost more than one tick has, and the probe would have to wait for it.)
/// Without a limit, a list is made when it is needed, which costs less. Only the constructor
/// allocates.
class PairLists {
 public:
  /// A list holds at most `capacity` pairs. 0: there are no lists.
  PairLists(const Body& probe, const Body& fixed, std::size_t capacity);

  /// Clears both lists, the recent course and the learned costs of lists.
  void forget() noexcept;
  /// The list in use. Before a query on it, check reach_at() or covers().
  NeighbourList& serving() noexcept { return lists_[serving_]; }
  const NeighbourList& serving() const noexcept { return lists_[serving_]; }

  /// Notes a path that the probe is about to take. Lists are made for the longest recent path.
  void note_path(const Motion& path) noexcept;
  /// Halves the recent course. Call it if a list for paths of that length does not fit.
  void expect_shorter_paths() noexcept;
  /// The recent path of the probe, continued from X, as the motion of one of its points. `centre`
  /// is that point in the probe's mesh frame.
  Course recent_course(const Transform& X, const Vec3& centre) const noexcept;
  /// rad: the turn of that path.
  double recent_turn() const noexcept { return turning_.norm(); }

  /// The range that a list must cover.
  struct Wanted {
    double reach_at_end = 0;      ///< m: at the end of the path
    double reach_on_path = 0;     ///< m: on all of the path, if there is room for so many pairs
    double reach_acceptable = 0;  ///< m: a list made in advance is used if its reach exceeds this
    Vec3 centre = Vec3::Zero();   ///< motions are measured about this point, probe's mesh frame
    LinearizedMotion path;
  };
  /// Replaces the list in use by one that covers `wanted` from X on: by the list made in advance if
  /// its reach is acceptable, otherwise by a new one. Does nothing if the path is so long that a
  /// list would cost more than it saves. If the effort runs out, the next calls continue.
  void renew(const Transform& X, const Wanted& wanted, Effort& effort) noexcept;
  /// Works on the next list at the end of a tick. Continues one that was begun. Otherwise begins
  /// one, if the list in use would expire before a new one could be ready.
  void prepare_next_list(const Transform& X, const Wanted& wanted, Effort& effort) noexcept;

 private:
  NeighbourList& next() noexcept { return lists_[1 - serving_]; }
  NeighbourList::Coverage coverage(const Transform& X, const Wanted& wanted,
                                   double length) const noexcept;
  /// m: the length of the path plus the reach at its end.
  double travel(const Wanted& wanted) const noexcept;
  void begin(const Transform& X, const Wanted& wanted, double at_least, Effort& effort) noexcept;
  void end(bool fits) noexcept;

  double radius_;
  std::array<NeighbourList, 2> lists_;
  std::size_t serving_ = 0;
  NeighbourReach reach_;
  // The longest recent path: displacement of the centre of mass, m, and turn, rad, in the fixed
  // body's axes. Each shorter path reduces both a little.
  Vec3 sliding_ = Vec3::Zero(), turning_ = Vec3::Zero();
  Vec3 com_;  // of the probe, mesh frame
  /// The list that was begun last.
  struct Begun {
    double travel = 0;            ///< m: travel() that it was made for
    double ample = 0, least = 0;  ///< m: the reach wanted, and that of the fallback
    std::int64_t affordable = 0;  ///< work that it should take at most
  };
  Begun begun_;
  std::int64_t last_work_ = 0;  // of the last list
  double left_over_ = 0;        // work that recent ticks left over for the next list, on average
};

}  // namespace sonde
