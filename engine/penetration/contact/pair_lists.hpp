// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "engine/proximity/sweep/course.hpp"
#include "engine/proximity/sweep/neighbour_list.hpp"
#include "engine/proximity/sweep/neighbour_reach.hpp"

namespace sonde {

/// The lists of pairs that a probe goes by (neighbour_list.hpp): the one that serves, and the next.
/// Where the effort of a tick is limited the next list is made ahead of time, of what ticks leave
/// over: a list may take longer than a tick has, and the probe would wait for it. Without a limit
/// it is made when it is due, which takes less. Nothing here allocates but the constructor.
class PairLists {
 public:
  /// `capacity`: pairs of a list; 0: there are no lists.
  PairLists(const Body& probe, const Body& fixed, std::size_t capacity);

  /// What comes next has nothing to do with what was before.
  void forget() noexcept;
  NeighbourList& serving() noexcept { return lists_[serving_]; }
  const NeighbourList& serving() const noexcept { return lists_[serving_]; }

  /// The probe is to go along this: the longest path of late is what lists are made for.
  void remember(const Motion& path) noexcept;
  /// Paths as long as of late have no room in a list.
  void expect_less() noexcept;
  /// Where the probe goes of late from X, seen from a point of it (its mesh frame).
  Course usual(const Transform& X, const Vec3& centre) const noexcept;
  /// rad, of the same.
  double usual_turn() const noexcept { return turning_.norm(); }

  /// What a list is made for.
  struct Wanted {
    double reach = 0;  ///< m: what it must cover at the end of the path
    double near = 0;   ///< m: the same at any time, if there is room
    double least = 0;  ///< m: what will do of a list that was made ahead
    Vec3 centre = Vec3::Zero();
    Path path;
  };
  /// Makes the list that serves anew, for the path and others like it; not where that is long and a
  /// list would not pay. One that was made ahead serves if it will do. Where the effort does not
  /// suffice the next calls go on.
  void renew(const Transform& X, const Wanted& wanted, Effort& effort) noexcept;
  /// At the end of a tick: goes on with the next list, or begins with it where the one that serves
  /// does not last until it would be there.
  void look_ahead(const Transform& X, const Wanted& wanted, Effort& effort) noexcept;

 private:
  NeighbourList& next() noexcept { return lists_[1 - serving_]; }
  NeighbourList::Room room(const Transform& X, const Wanted& wanted, double length) const noexcept;
  /// m: how far the probe is to go and to see.
  double travel(const Wanted& wanted) const noexcept;
  void begin(const Transform& X, const Wanted& wanted, double at_least, Effort& effort) noexcept;
  void end(bool fits) noexcept;

  double radius_;
  std::array<NeighbourList, 2> lists_;
  std::size_t serving_ = 0;
  NeighbourReach reach_;
  // Of a path of late, the longest, forgotten bit by bit: of the centre of mass, m; rad. In the
  // fixed body's axes.
  Vec3 sliding_ = Vec3::Zero(), turning_ = Vec3::Zero();
  Vec3 com_;  // of the probe, mesh frame
  /// The list that was begun last: m, and units of work.
  struct Begun {
    double travel = 0, ample = 0, least = 0;
    std::int64_t affordable = 0;
  };
  Begun begun_;
  std::int64_t last_work_ = 0;  // of a list
  double left_over_ = 0;        // of the effort of a tick of late, for the next list
};

}  // namespace sonde
