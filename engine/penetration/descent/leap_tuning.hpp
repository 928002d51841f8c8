// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace sonde {

/// Constants of a descent by leaps (LeapDescent) that it does not share with the swept descent
/// (descent_tuning.hpp). They decide how soon it ends and where; the poses at which leaps end are
/// free whatever they are. Chosen by trial together with those of the search on the poses of
/// `tests/reference/depths.csv` (`sonde-depths`). Lengths are in m of y unless a line gives another
/// unit.
struct LeapTuning {
  /// Maximum numbers of pairs, the nearest, from which rows are made. If there are more,
  /// ContactRows::add_cuts finds those that obstruct a leap, up to DescentTuning::most_cuts times.
  /// With outlines these are not searched for, and the descent ends at a larger |y|.
  std::size_t few_pairs = 96;
  std::size_t many_pairs = 512;

  // Each leap
  /// Share of the gain that the first rows predicted: a leap that gains less is not made.
  double worth = 0.1;
  double most_room = 0.3;         ///< share of the leap: room for contacts that bend into it
  double trust_growth = 2;        ///< times max(free leap, half of the last trust)
  double trust_after_part = 1.2;  ///< times a leap around obstacles, or a partial leap
  double trust_kept = 0.5;        ///< share of the last trust that is kept after a leap
  double trust_lost = 0.1;        ///< share of a leap of which no part was free: next trust
  double parts[2] = {0.4, 0.16};  ///< shares of a leap that is not free: tried next
  /// Bisections of the straight line to the device pose: accurate to a hundredth of its length.
  int bisections = 7;

  // Reach of the search for rows
  double reach = 0.5;         ///< share of the trust
  double least_reach = 4;     ///< margins
  double widest_reach = 0.1;  ///< R: gathering further costs more than it gains

  // The end
  double margin_of_tolerance = 0.1;  ///< share of the tolerance: the gap aimed at
  double margin_of_clearance = 0.5;  ///< share of allowed_clearance: the least gap aimed at
  double least_trust = 0.2;          ///< margins: a shorter leap changes nothing
  /// A descent may be given up after this many steps, if its depth exceeds the depth to beat by
  /// this factor. The local optimum that it would have reached is then not found.
  int steps_before_hopeless = 3;
  double hopeless = 1.1;
};
inline constexpr LeapTuning leap_tuning;

}  // namespace sonde
