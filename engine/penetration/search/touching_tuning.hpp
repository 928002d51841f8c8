// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace sonde {

/// Constants of the test for a touch (touching_separation). They decide which poses are answered
/// without a search. The answer is verified free and no deeper than the level whatever they are.
/// Poses that a limit here excludes are searched, at the search's cost.
struct TouchingTuning {
  /// In rounding errors of placing the bodies (rounding_guard: 64 ε × extents; large far from the
  /// origin, or beside a large body): an overlap up to this depth is a touch, and is answered
  /// without a search. It is at least the clearance that an answer of no depth may keep
  /// (allowed_clearance, 1e-9 R). An answer below it cannot be distinguished from one of depth 0.
  double level_in_roundings = 64;
  /// In the same rounding errors: gaps that the answer's contacts get, tried in turn until its pose
  /// is free. The first is well above the error of coordinates when the pose is rounded. The second
  /// is the least gap that a descent keeps; the coherent solver starts with it (lifted_off).
  double gaps[2] = {1, 16};
  /// In levels: pairs within this distance may become obstacles. The answer to a touch moves no
  /// point of the probe further, except a point far beyond the others (a needle).
  double reach = 4;
  /// Number of pairs examined first. In nearly all poses that are not a touch, one of them overlaps
  /// by more than the level, and the test ends after 1 to 5 µs.
  std::size_t first_pairs = 16;
  /// Maximum number of touching pairs: 1 ms of work. Flat parts have few touching triangles however
  /// finely they are cut; only curved surfaces that fit each other have more.
  std::size_t most_pairs = 512;
};
inline constexpr TouchingTuning touching_tuning;

}  // namespace sonde
