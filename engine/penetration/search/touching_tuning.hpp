// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace sonde {

/// The numbers of the look for a touch (touching_separation). They decide which poses are answered
/// without a search; what is answered is verified free and no deeper than the level whatever they
/// are. What a limit here leaves out is searched, at the search's cost.
struct TouchingTuning {
  /// The level of depth up to which a touch is its own answer, m: the clearance that an answer of
  /// no depth may keep (allowed_clearance, 1e-9 R), or so many times what placing the bodies can
  /// lose to rounding where that is more (rounding_guard: 64 ε × extents; far from the origin, or
  /// beside a large body). An answer below it cannot be told from one of depth 0.
  double level_in_roundings = 64;
  /// Of the same rounding: the gaps asked for, in turn. One is well above what coordinates lose
  /// when the pose is rounded; where it does not come free, what a descent keeps at least.
  double gaps[2] = {1, 16};
  /// Levels: pairs that are nearer may come into the way. A touch moves no point of the probe
  /// further, but for one that is far beyond the others (a needle).
  double reach = 4;
  /// Pairs of a first look: where one of them overlaps by more than the level, as one does in
  /// nearly all poses that are not a touch, no other is looked for. 1 to 5 µs.
  std::size_t first_pairs = 16;
  /// Pairs that touch, at most: 1 ms of work. Flat parts are few triangles however finely they are
  /// cut; it takes curved surfaces that fit each other to have more.
  std::size_t most_pairs = 512;
  /// Of the gap: violations of rows that are let stand, as in a descent.
  double solved_to = 0.05;
};
inline constexpr TouchingTuning touching_tuning;

}  // namespace sonde
