// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace sonde {

/// The numbers of a descent by leaps (LeapDescent) that it does not share with the one that sweeps
/// (descent_tuning.hpp). They decide how soon it ends and where; each pose on the way is free
/// whatever they are. Chosen by trial with those of the search on the poses of
/// `tests/reference/depths.csv` (`sonde-depths`). Lengths are in m of y unless a line gives another
/// unit.
struct LeapTuning {
  /// Pairs that rows are made of, the nearest. Where there are more, `cut` finds those in the way,
  /// as often as DescentTuning::most_cuts; by outlines nothing does, and the end is higher.
  std::size_t few_pairs = 96;
  std::size_t many_pairs = 512;

  // Each leap
  /// Of what the rows of the first guess promised: a leap that gains less is not worth while.
  double worth = 0.1;
  double most_room = 0.3;         ///< of the leap: what contacts that bend into it may take
  double trust_growth = 2;        ///< of a leap that was free, or half of the trust before
  double trust_after_part = 1.2;  ///< of a leap round something, or of a part of one
  double trust_kept = 0.5;        ///< of the trust before, at least, after a leap
  double trust_lost = 0.1;        ///< of a leap of which no part was free: what is trusted next
  double parts[2] = {0.4, 0.16};  ///< of a leap that is not free: what is tried of it
  /// Bisections on the way straight to the device pose: to a hundredth of it.
  int bisections = 7;

  // Where rows are looked for
  double reach = 0.5;         ///< of the trust
  double least_reach = 4;     ///< margins
  double widest_reach = 0.1;  ///< R: further costs more than it tells

  // The end
  double margin_of_tolerance = 0.1;  ///< the gap that is aimed at
  double margin_of_clearance = 0.5;  ///< the same, at least (allowed_clearance)
  double least_trust = 0.2;          ///< margins: a shorter leap changes nothing
  /// Steps after which a descent may be given up, and of the depth to beat: where it has to be
  /// above for that. Then a place that it would still have come to is lost.
  int steps_before_hopeless = 3;
  double hopeless = 1.1;
};
inline constexpr LeapTuning leap_tuning;

}  // namespace sonde
