// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace sonde {

/// Constants of a descent on sketches (SketchDescent). They decide how soon it ends and where. It
/// only guides a search, which verifies what it returns. Chosen by trial together with those of the
/// search on the poses of `tests/reference/depths.csv` (`sonde-depths`). Lengths are in grid cells
/// (`spacing()`) unless a line gives another unit.
struct SketchDescentTuning {
  /// Maximum number of points, the nearest, that give rows. Other points may enter the body; they
  /// then give rows in the next step.
  std::size_t most_rows = 40;
  double solved_to = 1e-2;  ///< tolerated violation of a row

  // Each step
  double largest_turn = 0.35;  ///< |Δv|, about half the angle, rad: limit of the linearisation
  double first_trust = 0.4;    ///< share of the initial |y|, or of a cell: the longest first step
  double trust_growth = 1.5;   ///< times the last step
  double trust_decay = 0.7;    ///< share of the last trust that is kept at least
  double reach = 0.4;          ///< share of the trust: points within it are examined
  /// A part of a step is taken back if, after it, a point lies deeper than `too_deep` times its
  /// length and deeper than `too_deep_at_least`.
  double too_deep = 0.25;
  double too_deep_at_least = 0.1;
  double taken_back_to = 0.4;         ///< share of the step that is kept
  double trust_after_too_deep = 1.2;  ///< times that share
  /// R per |Δv|: upper bound of the travel of a point of the probe, or of the other body seen from
  /// it (2 R, plus the curvature of the path).
  double travel_per_turn = 2.5;

  // The end
  double rough_tolerance = 0.05;  ///< share of |y|, with few points: shorter steps end a descent
  double tolerance = 0.01;        ///< share of |y|, with all points
  double shortest = 0.02;         ///< shorter steps end a descent too
  double arrived_within = 0.25;   ///< a descent with points no deeper than this has arrived
  /// A descent may be given up after this many steps, if its depth exceeds the depth to beat by
  /// LeapTuning::hopeless. The local optimum that it would have reached is then not found.
  int steps_before_hopeless = 2;
};
inline constexpr SketchDescentTuning sketch_descent_tuning;

}  // namespace sonde
