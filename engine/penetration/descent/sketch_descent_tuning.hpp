// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace sonde {

/// The numbers that a descent on sketches is made by (SketchDescent). They decide how soon it ends
/// and where; it only guides a search, which verifies what it returns. Chosen by trial with those
/// of the search on the poses of `tests/reference/depths.csv` (`sonde-depths`). Lengths are in grid
/// cells (`spacing()`) unless a line gives another unit.
struct SketchDescentTuning {
  /// Points, the nearest, that make rows. Those beyond are let in and push in the next step.
  std::size_t most_rows = 40;
  double solved_to = 1e-2;  ///< violations of rows that are let stand

  // Each step
  double largest_turn = 0.35;  ///< |Δv|, about half the angle, rad: linearised too far beyond
  double first_trust = 0.4;    ///< of |y| at the start, or of a cell: the longest first step
  double trust_growth = 1.5;   ///< of the last step
  double trust_decay = 0.7;    ///< of the trust before, at least
  double reach = 0.4;          ///< of the trust: where points are looked at
  /// How much deeper than wanted points may lie after a step before a part of it is taken back: of
  /// the step, and at least.
  double too_deep = 0.25;
  double too_deep_at_least = 0.1;
  double taken_back_to = 0.4;         ///< of the step
  double trust_after_too_deep = 1.2;  ///< of what is left of it
  /// R per |Δv|: more than a point of the probe, or of the other body seen from it, can travel (2 R
  /// and what bends).
  double travel_per_turn = 2.5;

  // The end
  double rough_tolerance = 0.05;  ///< of |y|, by few points: shorter steps end a descent
  double tolerance = 0.01;        ///< the same, by all of them
  double shortest = 0.02;         ///< so do these
  double arrived_within = 0.25;   ///< too deep by no more, it has arrived
  /// Steps after which a descent may be given up, and of the depth to beat: where it has to be
  /// above for that. Then a place that it would still have come to is lost.
  int steps_before_hopeless = 2;
  double hopeless = 1.1;
};
inline constexpr SketchDescentTuning sketch_descent_tuning;

}  // namespace sonde
