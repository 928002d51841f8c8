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
/// `tests/reference/depths.csv` with three seeds (`sonde-depths`; for its tables see "How near the
/// static search comes to the best known depth" in resources/docs/understand/measurements.md). A
/// number without a figure of its own was chosen together with its neighbours. For studies,
/// separate_static accepts another struct of this type.
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
  /// Maximum number of counted steps of the first translation, so that one is found even with few
  /// steps. If it is cut short, the first answer is deeper.
  int steps_of_first_translation = 8;

  // Starts on sketches, of some 0.05 ms each
  /// At first, starts are made until they agree or `most_first_sketches` are made; then their
  /// number is doubled as long as it is unclear which end is the best. On the 224 poses of
  /// depths.csv that have sketches and three seeds, 16 starts come to within a tenth of the depth
  /// of the reference pose on 442 of 672, 64 on 546, 256 on 588 and 512 on 597 (when three of eight
  /// began near the device pose and two far away). `clear` needs 24 of them at least.
  int first_sketches = 16;  ///< half as many for the first translation, which is only a start
  int most_first_sketches = 64;
  int most_sketches = 256;
  /// Number of starts on sketches about as far away as the best depth that must independently reach
  /// the best end. That starts near the device pose agree shows only that a wide way leads out
  /// there. (When 8 of any starts sufficed, and 4 if no other end was within 1.08 times the best
  /// depth, 8 % of 400 searches of a brick and a bar that are sunk by their radius into a block
  /// were over 1 % too deep, and 3.5 % over 5 %; now 2.0 and 0.3 %. The median of depths.csv is 21
  /// to 24 ms instead of 19 to 20.)
  int clear = 8;
  /// Share of the best depth: what is no further apart counts as one place. Ends on sketches are
  /// one local optimum, no start is made nearer to the best optimum or to the device pose, and no
  /// descent begins at a pose so near a known one. If it is larger, different optima are merged,
  /// and the better one may not be tried. (Half or twice of it in any one of these uses changes no
  /// more poses than another seed does.)
  double same_place = 0.1;
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
  double largest_end_ball = 0.6;             ///< times the best depth, about one of the best ends
  std::size_t ends_for_sketches = 3;         ///< number of best ends about which starts are made
  /// Times the best depth: a descent with few points that will end above is given up. With all
  /// points it is `hopeless`: ends beside the best are wanted.
  double hopeless_few_points = 0.95;
  /// Factor on the best depth: descents with few points that end above are not repeated with all
  /// points. If it is lower, optima are lost whose depth is too large with few points.
  double worth_more_points = 1.15;

  // From sketches to the bodies
  /// Maximum numbers of ends on sketches from which the bodies descend, at about 1 ms each:
  /// `ends_where_clear` if one end stands out (four find no more on depths.csv), `first_ends` at
  /// first if none does, and `most_ends` later. Further ends are not tried.
  std::size_t ends_where_clear = 2;
  std::size_t first_ends = 8;
  std::size_t most_ends = 24;
  /// Grid cells: gaps to which sketches are moved apart, one after the other, until the bodies are
  /// free, and the steps allowed for each. If no pose is free, the bodies are pushed apart.
  double apart[5] = {0, 0.1, 0.3, 0.6, 1.2};
  int steps_apart = 4;
  /// Factors on an end on sketches: with a time budget, free poses are tried straight beyond it,
  /// one after the other. If none is free, the answer comes from a start outside, and may be many
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
  /// Number of starts near the device pose: agreement of sketches proves nothing about a hole that
  /// they do not resolve (a cylinder in a hole, conforming_test.cpp). Without these starts, the
  /// answer for that cylinder leaves through the end of the hole. No pose of depths.csv needs them,
  /// and they cost a third of the median.
  std::size_t pushes = 8;
  /// Factor on the depth of the deepest sketch point in the other body at the device pose. If the
  /// evidence is conclusive and the best depth is no larger than this, it needs no pushes, since no
  /// separating motion is much shorter than the depth of that point. (With 1.5, with 2.5, and with
  /// pushes on every pose, 241 of the 244 poses are within 1 %; the median is 15.3, 13.9 and 18.3
  /// ms, measured beside other work.) If the best depth is larger, the random starts are
  /// overlaps too. (With 1e9 none are: of the 160 poses of deep_tuning.csv, 147 are then within
  /// 1 % instead of 155.) If the factor is larger, a separating motion through a narrow gap may be
  /// missed.
  double narrow = 2.5;
  /// The same for these few pushes: conclusive evidence needs none up to this. (Of 96 poses of
  /// plugs in fits with a room of 0.5 to 2 %, 13 are over 1 % too deep with 2.5, 11 with 1.8 and 8
  /// with 1.5 and with 1.2. The median of depths.csv is 31 ms instead of 26.)
  double narrow_for_pushes = 1.5;
  double farthest_push = 0.8;  ///< times the best depth, or R if that is less
  /// Factor on the best depth: limit of |y| while an overlap is pushed apart. Beyond it, it is
  /// moved back, and after some returns given up (PushApartTuning).
  double given_up_at = 1.3;

  // Random starts
  /// Maximum number of random starts after the starts on sketches. On depths.csv, 16, 32, 64 and
  /// 160 of them leave the same poses of three seeds over 1 % too deep; with the bodies moved, 32
  /// lose two poses more than 64, one by 22 %. Without sketches, StaticOptions::starts is the
  /// limit. If overlaps are pushed apart instead (see `narrow`) for PD_g: with 32, 64, 128 and 256
  /// of them 287, 306, 310 and 314 of 320 searches on deep_tuning.csv are within 1 %, in medians of
  /// 61, 77, 103 and 175 ms.
  int most_after_sketches = 128;
  /// The same for PD_t, in each of its two searches, and the number of random overlaps of which one
  /// is pushed apart. (Of 112 boxes, cups, bottles and tubes at cavities, 21 are over 1 % too deep
  /// without any, 8 with 64 pushes of any overlap, and 6, 3 and 3 with 16, 32 and 64 of the least
  /// of 16.)
  int most_translations_pushed = 16;
  int overlaps_compared = 16;
  /// Grid cells: a random pose at which the sketches overlap more deeply is rejected without a test
  /// of the bodies. If it is lower, free poses are rejected where the sketches are wrong.
  double plainly_deep = 0.3;
  /// Random poses tried in one ball until one is free, and random axes until one is near enough. If
  /// none is, the ball grows, and a short separating motion may be missed.
  int tries_in_a_ball = 50;
  int near_tries = 12;          ///< the same for near starts: pockets are small
  int near_tries_timed = 5;     ///< the same with a time budget, which more would use up
  double near_growth = 1.6;     ///< growth of the balls of near starts
  double far_growth = 1.2;      ///< growth of the balls of far starts
  double smallest_ball = 2e-3;  ///< R: the first ball of near starts
  /// In R, or for far starts in radii of the first ball: limit of the search for a free pose.
  double largest_ball = 4;
  /// Factor on the radius of the last free pose: the next search begins there.
  double near_again = 0.3;
  /// Number of best ends about which starts are made: if there are many, the better ones lie
  /// together.
  std::size_t ends_for_starts = 6;
  double about_nearest = 0.03;  ///< times the best depth: least radius of the ball about an end
  double about_wider = 0.47;    ///< times the best depth: largest addition; small ones are likelier
  double farthest_overlap = 1.2;  ///< times the best depth: overlaps to push apart
  /// Times the best depth: radii of the first balls of far starts. (The ball of the best depth
  /// itself has no free pose.)
  double far_widths[3] = {0.75, 1.15, 1.5};

  // Descents of one start, by leaps: roughly by outlines, then by the true contacts
  int rough_steps = 15;      ///< and of an exact descent without a rough one before it
  double rough_reach = 0.3;  ///< share of |y|: the first leap
  /// Factor on the best depth: a rough descent that ends above is not repeated exactly. If it is
  /// lower, optima are lost whose depth is too large with outlines.
  double worth_exact = 1.2;
  int exact_steps = 12;
  double exact_reach = 0.1;
  double exact_reach_alone = 0.2;  ///< if there was no rough descent
  /// Factor on the best depth: a rough descent that will end above it is given up; an exact one
  /// ends at `same` above it.
  double hopeless = 1.1;

  // The end
  /// Share of the depth: depths that differ by less count as equal, and ends no further apart count
  /// as one local optimum. Agreement of starts ends the search, so if it is larger, the search may
  /// end at an optimum that is deeper by that share. Exact descents end at half of it (a share of
  /// |y|), and what ended further out than that is not refined.
  double same = 0.02;
  std::size_t refined = 3;  ///< number of best local optima that are refined
  /// Factor on the best depth: a translation no deeper is refined with six degrees of freedom too.
  double translation_competes = 1.001;

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
