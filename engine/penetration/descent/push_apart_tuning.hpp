// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace sonde {

/// Constants of pushing overlaps apart (PushApart). They decide how often it succeeds, not whether
/// its result is free. Where no other poses are named, a number was chosen by trial on the device
/// poses of `tests/reference/depths.csv`, of which 181 of the 244 become free, and 137 of those
/// lead down to the reference depth, to 1 %. Lengths are in parts of R, the probe's radius.
struct PushApartTuning {
  /// Maximum number of steps. After that, this start is given up and another one is tried. (Of
  /// searches on the first eight families of deep_tuning.csv with four seeds and 24 pairs, 503 of
  /// 512 are within 1 % with 40 steps and 5 returns, and 496 with 25 and 3.)
  int most_looks = 40;
  /// Pairs that one step considers. The pairs of a deep overlap contradict each other; more of them
  /// cost more and do not succeed more often: with 24, 32 and 48, 308, 309 and 308 of 320 searches
  /// on deep_tuning.csv are within 1 %, in medians of 102, 109 and 113 ms. But with 24, a ball in
  /// the hole of a plate is pushed to and fro, by one side of the rim at a time.
  std::size_t most_pairs = 32;
  /// How often a pose that is pushed out of the ball is moved back before the start is given up.
  /// Without, four of five random overlaps of deep_tuning.csv leave the ball of 1.3 times the best
  /// depth, and 5 % become free; with any number of returns, a third does.
  int most_returns = 5;
  double returns_to = 0.9;  ///< share of the ball's radius
  double margin = 2e-4;     ///< distance to which triangles are separated
  /// In a fit with less room than that on both sides, rows contradict each other. So in the second
  /// half of the looks, each look has this factor on the margin: fits with a room of 1e-6 R are
  /// found. (A square peg with 1 µm of room that was 11 µm aside was answered 39 mm deep instead of
  /// 10 µm. Of the 244 and 160 poses of depths.csv and deep_tuning.csv as many as before are within
  /// 1 %.)
  double less_margin = 0.5;
  /// Cosine between the outward normal of a solid's face and a separating direction: a direction
  /// that points inwards by no more than this is still allowed, because a direction in the plane of
  /// a face leads neither in nor out.
  double aside = 0.1;

  // The compromise between pairs
  /// Limit of the displacement that a row demands, as a multiple of the median of all rows. (A
  /// dovetail of 12 triangles, 7 mm aside in its groove, was pushed out of it lengthwise by 1.6 m
  /// at the first step: of 16 such poses, 15 were answered over 1 % too deep, by up to 76 times.
  /// With 10, 4 and 2 it is 12, 2 and 1; of 192 searches of hexagons, T's, rods and blades 15 with
  /// 4, and 18 with 2.)
  double longest_way = 4;
  int sweeps = 8;     ///< Gauss-Seidel sweeps; the next step handles what is not settled
  double give = 0.3;  ///< share of a row's |n|²: how far it yields to contradicting rows
};
inline constexpr PushApartTuning push_apart_tuning;

}  // namespace sonde
