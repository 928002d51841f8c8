// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace sonde {

/// Constants of the static search. They decide how long it takes and how often it finds the best
/// separation. Its result is verified whatever they are, so a worse number costs depth or time,
/// never correctness. Lengths are in m of y unless a line gives another unit; R is the probe's
/// radius; the best depth is the least found so far.
///
/// What half and twice of each cost on the poses that chose them is a table of
/// resources/docs/understand/measurements.md ("What single numbers of the search are worth"). For
/// studies, separate_static accepts another struct of this type.
struct SearchTuning {
  // Budgets
  /// Shares of a time budget at which the search on sketches, the whole search, and the refinement
  /// end. The rest is for the exact test. A part that is not finished by then is cut off, and the
  /// answer may be deeper.
  double share_for_sketches = 0.45;
  double share_for_search = 0.7;
  double share_for_refining = 0.97;
  /// µs: a second thread takes a tenth of a millisecond to start and stop, and rounds wait for
  /// their longest start. With less time than this, one thread finds as much and keeps the time
  /// limit better.
  double shortest_for_two_threads = 5000;

  // What counts as equal, and what approximations are worth
  /// Share of the depth: depths that differ by less count as equal, and ends no further apart count
  /// as one local optimum. Agreement of starts ends the search, so if it is larger, the search may
  /// end at an optimum that is deeper by that share. Exact descents end at half of it (a share of
  /// |y|), and what ended further out than that is not refined. A translation no deeper than the
  /// best by more is refined with six degrees of freedom too.
  double same = 0.02;
  /// Share of the best depth: what is no further apart counts as one place. Ends on sketches are
  /// one local optimum, no start is made nearer to the best optimum or to the device pose, and no
  /// descent begins at a pose so near a known one. If it is larger, different optima are merged,
  /// and the better one may not be tried.
  double same_place = 0.1;
  /// Grid cells: estimated error of sketches. An end deeper than the best depth by more is not
  /// tried, and a random pose at which the sketches overlap more deeply is rejected without a test
  /// of the bodies. If it is lower, optima that the sketches show too deep are missed.
  double sketch_error = 0.3;
  /// Factor on a depth: upper limit of the error of an approximate depth (by few points, outlines
  /// or sketches). A descent by outlines, or on sketches with all points, is given up if it will
  /// end above this times the best depth (by few points: above the best depth itself); so is an
  /// overlap that is pushed further than that (PushApart). An end above it gets no exact descent.
  /// (A descent will end above a depth if it is still a tenth above it: `hopeless` of the
  /// descents.) If descents of the bodies end deeper than this times those of the sketches, the
  /// sketches lack features that hold the bodies (on depths.csv they end within 0.9 to 1.15 of it,
  /// but 1.7 to 5 times as deep between a solid and a thin surface); then the sketches are no
  /// evidence, and the search takes longer.
  double rough_error = 1.2;

  // Balls in which random poses are drawn
  double smallest_ball = 5e-3;  ///< R: the first ball about the device pose
  /// Largest ball in which a free pose is searched for: in R, or, for balls sized by the best
  /// depth, in multiples of that.
  double largest_ball = 4;
  double ball_growth = 1.4;  ///< factor from a ball without a free pose to the next one
  /// Number of tries: of random poses in a ball until one is free, of random axes until one is near
  /// enough, and in a search for PD_t of random overlaps, of which the least is pushed apart.
  int tries_in_a_ball = 12;
  /// Times the best depth: least and largest radius of the balls of far starts. (A ball of the best
  /// depth itself mostly has no free pose, and grows.)
  double least_ball = 0.75;
  double farthest_ball = 1.5;
  double end_ball = 0.5;          ///< times the best depth: largest ball about an end
  double farthest_overlap = 1.2;  ///< times the best depth: overlaps to push apart

  // Starts on sketches, of some 0.05 ms each
  /// At first, starts are made until `clear` of those about as far away as the best depth have
  /// independently reached the best end, or `most_first_sketches` are made; then their number is
  /// doubled up to `most_sketches` as long as it is unclear which end is the best. Agreement of
  /// starts near the device pose shows only that a wide passage leads out there. (When 8 of any
  /// starts sufficed, and 4 if no other end was within 1.08 times the best depth, 8 % of 400
  /// searches of a brick and a bar that are sunk by their radius into a block were over 1 % too
  /// deep, and 3.5 % over 5 %; now 2.0 and 0.3 %.)
  int clear = 8;
  int most_first_sketches = 64;
  int most_sketches = 256;

  // Ends from which more is tried
  /// Number of best ends on sketches from which the bodies descend if one end stands out, of best
  /// ends about which starts on sketches are made, and of local optima that are refined.
  std::size_t few_ends = 3;
  /// The same if none stands out, at about 1 ms each, and about which random starts are made: if
  /// there are many ends, the better ones lie together.
  std::size_t first_ends = 8;

  // Starts from overlaps, which are pushed apart (PushApart), and random starts
  /// Factor on the depth of the deepest sketch point in the other body at the device pose. If the
  /// best depth is larger, all random starts are overlaps, and agreement of starts proves nothing.
  /// (With 1e9 none are: of the 160 poses of deep_tuning.csv, 147 are then within 1 % instead of
  /// 155.)
  double narrow = 2.5;
  /// The same for one round of overlaps near the device pose. If the evidence is conclusive and the
  /// best depth is no larger than this, it needs none, since no separating motion is much shorter
  /// than the depth of that point. (Of 96 poses of plugs in fits with a room of 0.5 to 2 %, 13 are
  /// over 1 % too deep with 2.5, 11 with 1.8 and 8 with 1.5 and with 1.2. The median of depths.csv
  /// was 31 ms instead of 26.)
  double narrow_for_pushes = 1.5;
  /// Maximum number of random starts after the starts on sketches. Without sketches,
  /// StaticOptions::starts is the limit. (Of overlaps pushed apart, 32, 64, 128 and 256 leave 287,
  /// 306, 310 and 314 of 320 searches on deep_tuning.csv within 1 %, in medians of 61, 77, 103 and
  /// 175 ms.)
  int most_after_sketches = 128;
  /// The same for the overlaps of a search for PD_t. (Of 112 boxes, cups, bottles and tubes at
  /// cavities, 21 are over 1 % too deep without any, and 6, 3 and 3 with 16, 32 and 64, each the
  /// least of 16 overlaps.)
  int most_translations_pushed = 16;

  // Descents of one start, by leaps: roughly by outlines, then by the true contacts
  int descent_steps = 12;  ///< of each, and of one that moves sketches apart
  double reach = 0.2;      ///< share of |y|: the first leap

  // The lower bound if it must not take longer than the search
  /// Units of its work (BoundOptions) for each start on sketches and for each step of the bodies
  /// that the search made. On the 224 poses of depths.csv with a solid, the bound then takes 15 %
  /// of the time in the median, and its median is 0.77 of the reference instead of 0.85. With 1.5
  /// times as many units it is 0.80, and the bound takes longer than the search on 21 of these
  /// poses instead of 3.
  int bound_for_a_sketch = 28;
  int bound_for_a_step = 95;
  /// µs: if less than this is left of a limited time, no bound is computed unless time was reserved
  /// for it: its start points alone would take longer.
  double least_us_for_bound = 300;
};
inline constexpr SearchTuning search_tuning;

}  // namespace sonde
