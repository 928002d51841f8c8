// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace sonde {

/// Constants of the static search. They decide how long it takes and how often it finds the best
/// separation. Its result is verified whatever they are, so a worse number costs depth or time,
/// never correctness. Lengths are in m of y unless a line gives another unit; R is the probe's
/// radius; the best depth is the least found so far.
///
/// Unless a line says otherwise, the numbers were chosen by trial on the poses of
/// `tests/reference/depths.csv` with three seeds (`sonde-depths`; the rows are those of "How near
/// the static search comes to the best known depth" in resources/docs/understand/measurements.md).
/// A number without a figure of its own was chosen together with its neighbours. For studies,
/// separate_static accepts another struct of this type.
struct SearchTuning {
  // Budgets
  /// Shares of a time budget at which the search on sketches, the whole search, and the refinement
  /// end. The rest is for the exact test. What is not finished by its share is left undone, and the
  /// answer may be deeper.
  double share_for_sketches = 0.45;
  double share_for_search = 0.7;
  double share_for_refining = 0.97;
  /// µs: a second thread takes a tenth of a millisecond to start and stop, and rounds wait for
  /// their longest start. With less time than this, one thread finds as much and keeps the time
  /// limit better.
  double shortest_for_two_threads = 5000;
  /// Counted steps that a first translation may take, so that there is one even with few steps. If
  /// it is cut short, the first answer is deeper.
  int steps_of_first_translation = 8;

  // Starts on sketches, of some 0.05 ms each
  /// At first, starts are made until they agree or `most_first_sketches` are made; then their
  /// number doubles as long as the ends leave it open which is the best. On the 224 poses of
  /// depths.csv that have sketches and three seeds, 16 starts come to within a tenth of the depth
  /// of the reference pose on 442 of 672, 64 on 546, 256 on 588 and 512 on 597.
  int first_sketches = 16;
  int most_first_sketches = 64;
  int most_sketches = 256;
  /// Starts for the first translation, which is only a start itself.
  int sketches_of_translations = 8;
  /// Number of starts on sketches that must independently reach the best end; `clear_alone`
  /// suffices if no other end is within `alone` of the best depth. With 4, two poses more of 244
  /// end over 1 % too deep, in 12.2 ms instead of 14.7 in the median.
  int clear = 8;
  int clear_alone = 4;
  double alone = 1.08;
  /// Share of the depth: ends on sketches that are no further apart are one place. If it is larger,
  /// different places are merged, and the better one may not be tried.
  double same_place_on_sketches = 0.1;
  /// Factor: an end nearer than the known depth of its place by this factor is worth another
  /// descent of the bodies.
  double nearer_on_sketches = 0.98;
  /// Number of starts from the nearest free poses, before some are made near the best depth and the
  /// best ends.
  int near_sketches = 16;
  /// A free pose is searched for in growing balls, with `tries` attempts in each.
  struct Balls {
    double growth;
    int tries;
  };
  double smallest_ball_of_sketches = 0.015;  ///< R: the first ball
  Balls first_balls{1.6, 3};                 ///< while there is no end yet
  Balls near_balls{1.4, 12};                 ///< from half the distance of the nearest free start
  Balls other_balls{1.25, 8};                ///< about the best depth, and about ends
  double least_far_ball = 0.8;               ///< times the best depth
  double largest_far_ball = 1.5;             ///< times the best depth
  double least_end_ball = 0.1;               ///< times the best depth, about one of the best ends
  double largest_end_ball = 0.6;             ///< times the best depth
  std::size_t ends_for_sketches = 3;         ///< number of best ends about which starts are made
  /// Times the best depth: a descent that will end above is given up.
  double hopeless_few_points = 0.95;
  double hopeless_more_points = 1.1;  ///< the same with all points: ends beside the best are wanted
  /// Factor on the best depth: descents with few points that end above are not repeated with all
  /// points. If it is lower, places are lost where few points mislead.
  double worth_more_points = 1.15;

  // From sketches to the bodies
  /// Maximum numbers of ends on sketches from which the bodies descend: if one end stands out (four
  /// find no more on depths.csv), at first if none does, and later. Ends beyond these are not
  /// tried; each takes about 1 ms.
  std::size_t ends_where_clear = 2;
  std::size_t first_ends = 8;
  std::size_t most_ends = 24;
  /// Grid cells: gaps to which sketches are moved apart, one after the other, until the bodies are
  /// free, and the steps allowed for each. If no pose is free, the bodies are pushed apart.
  double apart[5] = {0, 0.1, 0.3, 0.6, 1.2};
  int steps_apart = 4;
  /// Factors on an end on sketches: with a time budget, free poses are tried straight beyond it,
  /// one after the other. If none is free, a pose from outside is the answer, which may be many
  /// times as deep.
  double beyond[6] = {1.02, 1.06, 1.15, 1.35, 1.8, 2.6};
  /// Grid cells: estimated error of sketches. An end deeper than the best depth by more is not
  /// tried.
  double sketch_error = 0.3;
  /// Factor on the depth on sketches: if the bodies end deeper than this, the sketches miss what
  /// holds the bodies (on depths.csv they end within 0.9 to 1.15 of it, but 1.7 to 5 times as deep
  /// between a solid and a thin surface). Then sketches are no evidence, and the search takes
  /// longer.
  double blind = 1.3;

  // Starts from overlaps, which are pushed apart (PushApart)
  /// Number of starts near the device pose: sketches that agree prove nothing about a hole that
  /// they do not resolve (a cylinder in a hole, conforming_test.cpp). Without these starts its
  /// answer is out at the end of the hole; no pose of depths.csv needs them, and they cost a third
  /// of the median.
  std::size_t pushes = 8;
  /// Factor on the depth of the deepest sketch point in the other body at the device pose: a
  /// settled search with a best depth no larger needs no pushes, since no way out is much shorter
  /// than that point's. Of the 244 poses 241 are within 1 % with 1.5 and 2.5, as with pushes
  /// everywhere, in 15.3 and 13.9 ms in the median instead of 18.3 (beside other work). Beyond it
  /// the random starts of PD_g are overlaps too (with 1e9 none are: on the 128 poses of
  /// deep_tuning.csv, three seeds, 310 of 384 are then within 1 % instead of 359). If it is larger,
  /// a way out through a narrow gap may be missed.
  double narrow = 2.5;
  double nearest_push = 0.1;   ///< times the best depth, or R if that is less
  double farthest_push = 0.8;  ///< the same
  /// Factors on the best depth: limit of the distance to which an overlap is pushed apart, and
  /// distance from the best place within which a freed pose is not descended, since it would end
  /// there.
  double given_up_at = 1.3;
  double known_within = 0.1;

  // Random starts
  /// Maximum number of random starts after the starts on sketches. On depths.csv, 16, 32, 64 and
  /// 160 of them leave the same poses of three seeds over 1 % too deep; with the bodies moved, 32
  /// lose two poses more than 64, one by 22 %. Without sketches, StaticOptions::starts is the
  /// limit. If overlaps are pushed apart instead: with 32, 64 and 128 of them 348, 359 and 368 of
  /// those 384 are within 1 %, in 52 to 65, 62 to 79 and 88 to 100 ms in the median.
  int most_after_sketches = 64;
  /// Grid cells: a random pose at which the sketches overlap more deeply is rejected without a test
  /// of the bodies. If it is lower, poses are lost where the sketches are wrong.
  double plainly_deep = 0.3;
  /// Random poses tried in one ball until one is free. If none is, the ball grows, and a way out
  /// close by may be missed.
  int tries_in_a_ball = 50;
  int near_tries = 12;          ///< the same for near starts: pockets are small
  int near_tries_timed = 5;     ///< the same with a budget of time, which they would use up
  double near_growth = 1.6;     ///< growth of the balls of near starts
  double far_growth = 1.2;      ///< growth of the balls of far starts
  double smallest_ball = 2e-3;  ///< R: the first ball of near starts
  /// R (far starts: of the first ball): limit of the search for a free pose.
  double largest_ball = 4;
  /// Factor on the radius of the last free pose: the next search begins there.
  double near_again = 0.3;
  /// |v|: poses with larger turns, 128°, are not used as starts, since the chart is strongly curved
  /// there. Only descents reach a way out with such a turn.
  double largest_start_v = 0.9;
  /// Number of best ends about which starts are made: if there are many, the better ones lie
  /// together.
  std::size_t ends_for_starts = 6;
  double about_nearest = 0.03;    ///< times the best depth: least radius of the ball about an end
  double about_wider = 0.47;      ///< times the best depth: added at most; most are near the least
  double nearest_overlap = 0.1;   ///< times the best depth: between solids, overlaps to push apart
  double farthest_overlap = 1.2;  ///< the same
  /// Times the best depth: that ball itself has no free pose.
  double far_widths[3] = {0.75, 1.15, 1.5};

  // Descents of one start, by leaps: roughly by outlines, then by the true contacts
  int rough_steps = 15;
  double rough_reach = 0.3;  ///< share of |y|: the first leap
  /// Factor on the best depth: a rough descent that ends above is not repeated exactly. If it is
  /// lower, places are lost that look worse by outlines than they are.
  double worth_exact = 1.2;
  int exact_steps = 12;
  double exact_reach = 0.1;
  int exact_steps_alone = 15;  ///< if there was no rough descent
  double exact_reach_alone = 0.2;
  double exact_tolerance = 0.01;  ///< share of |y|; refined later
  /// Factors on the best depth: a rough or an exact descent that will end above is given up.
  double hopeless_rough = 1.1;
  double hopeless_exact = 1.02;

  // The end
  /// Share of the depth: depths that differ by less are equal, and ends no further apart are one
  /// place. Starts that agree end the search; if it is larger, the search may end at a place deeper
  /// by that share.
  double same = 0.02;
  std::size_t refined = 3;  ///< number of best places that are refined
  /// Factor on the best depth: descents that ended further out are not refined. Descents end a
  /// thousandth or so above their optimum.
  double worth_refining = 1.01;
  /// Factor on the best depth: a translation no deeper is refined with six degrees of freedom too.
  double translation_competes = 1.001;

  // The lower bound if it must not take longer than the search
  /// Units of its work (BoundOptions) for each start on sketches and for each step of the bodies
  /// that the search made. On the 224 poses of depths.csv with a solid it then takes 17 % of the
  /// time in the median, and its median is 0.66 of the reference instead of 0.85. Half as many
  /// again: 0.70, and it takes longer than the search on 11 of them.
  int bound_for_a_sketch = 28;
  int bound_for_a_step = 95;
  /// µs: if less of a limited time is left, no bound is computed unless time was reserved for it:
  /// its start points alone would take longer.
  double least_us_for_bound = 300;
};
inline constexpr SearchTuning search_tuning;

}  // namespace sonde
