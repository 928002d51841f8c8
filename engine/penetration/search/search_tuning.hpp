// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace sonde {

/// The numbers that the static search is made by. They decide how long it takes and how often it
/// ends at the best separation there is; what it returns is verified whatever they are, and a
/// number that is worse costs depth or time, never a promise. Lengths are in m of y unless a line
/// gives another unit; R is the probe's radius; the best depth is the least found so far.
///
/// Chosen by trial on the poses of `tests/reference/depths.csv` with three seeds (`sonde-depths`;
/// the rows are those of "How near the static search comes to the best known depth" in
/// resources/docs/understand/measurements.md), but where a line says otherwise. A number without a
/// figure of its own was chosen together with its neighbours. separate_static takes another struct
/// than this one, for studies.
struct SearchTuning {
  // Budgets
  /// Of a budget of time: until when sketches are searched, until when anything is, and until when
  /// what was found is refined. The rest is for the exact test. A share that ends leaves its part
  /// of the search undone, and the answer may be deeper.
  double share_for_sketches = 0.45;
  double share_for_search = 0.7;
  double share_for_refining = 0.97;
  /// µs: a second thread takes a tenth of a millisecond to come and go, and rounds wait for the
  /// longest of their starts. With less time than this, one thread finds as much and keeps the time
  /// better; nothing is lost.
  double shortest_for_two_threads = 5000;
  /// Counted steps that a first translation may take, so that there is one however few steps there
  /// are. Where it is cut short, it is a deeper first answer.
  int steps_of_first_translation = 8;

  // Starts on sketches, of some 0.05 ms each
  /// At first, until they agree or so many are made, and then twice as many again and again where
  /// the ends leave it open which is the best. On the 224 poses of depths.csv that have sketches
  /// and three seeds, 16 of them come to within a tenth of the depth of where the reference is on
  /// 442 of 672, 64 on 546, 256 on 588 and 512 on 597.
  int first_sketches = 16;
  int most_first_sketches = 64;
  int most_sketches = 256;
  /// For the first translation, which is only a start.
  int sketches_of_translations = 8;
  /// Starts on sketches that agree on which end is the best, each by itself; or so many, where no
  /// other end is within `alone` of the best depth. With 4, two poses more of 244 end over 1 % too
  /// deep, in 12.2 ms instead of 14.7 in the median.
  int clear = 8;
  int clear_alone = 4;
  double alone = 1.08;
  /// Of the depth: ends on sketches that are no further apart are one place. Larger: places are
  /// taken for one, and the better of them may not be tried.
  double same_place_on_sketches = 0.1;
  /// Of the depth: an end that is nearer than what was known of its place by this factor is worth a
  /// descent of the bodies of its own.
  double nearer_on_sketches = 0.98;
  /// Starts from the nearest free poses, before some are made near the best depth and the best
  /// ends.
  int near_sketches = 16;
  /// A free pose is looked for in ever larger balls, with so many tries in each.
  struct Balls {
    double growth;
    int tries;
  };
  double smallest_ball_of_sketches = 0.015;  ///< R: the first one
  Balls first_balls{1.6, 3};                 ///< as long as there is no end
  Balls near_balls{1.4, 12};                 ///< from half of where one was free
  Balls other_balls{1.25, 8};                ///< about the best depth, and about ends
  double least_far_ball = 0.8;               ///< of the best depth
  double largest_far_ball = 1.5;             ///< the same
  double least_end_ball = 0.1;               ///< of the best depth, about one of the best ends
  double largest_end_ball = 0.6;             ///< the same
  std::size_t ends_for_sketches = 3;         ///< the best ends that starts are made about
  double hopeless_few_points = 0.95;  ///< of the best depth: given up where it will not end below
  double hopeless_more_points = 1.1;  ///< the same, by all points: ends beside the best are wanted
  /// Of the best depth: descents on sketches by few points that end above are not made again by
  /// more. Lower: places are lost where few points mislead.
  double worth_more_points = 1.15;

  // From sketches to the bodies
  /// Ends on sketches that the bodies themselves are taken on from: where one end stands out (four
  /// of them find no more on depths.csv), at first where none does, and later. Ends beyond are not
  /// tried by the bodies; each takes about 1 ms.
  std::size_t ends_where_clear = 2;
  std::size_t first_ends = 8;
  std::size_t most_ends = 24;
  /// Grid cells: how far sketches are moved apart, one after the other, until the bodies are free,
  /// and the steps that each may take. Where none of them is free, the bodies are pushed apart.
  double apart[5] = {0, 0.1, 0.3, 0.6, 1.2};
  int steps_apart = 4;
  /// Of an end on sketches: where a free pose is tried straight beyond it, one after the other, if
  /// there is a budget of time. Where none of them is free, a pose from outside is the answer,
  /// which may be many times as deep.
  double beyond[6] = {1.02, 1.06, 1.15, 1.35, 1.8, 2.6};
  /// Grid cells: what sketches may be wrong by, about. An end deeper than the best depth by more is
  /// not tried.
  double sketch_error = 0.3;
  /// Of the depth on sketches: where the bodies end so much deeper, sketches miss what holds them
  /// (on depths.csv they end within 0.9 to 1.15 of it, but 1.7 to 5 times as deep between a solid
  /// and a thin surface). Then they are no evidence, and the search takes longer.
  double blind = 1.3;

  // Starts from overlaps, which are pushed apart (PushApart)
  /// Near the device pose: sketches that agree say nothing of a hole that they do not show (a
  /// cylinder in a hole, conforming_test.cpp). Without them its answer is out at the end of the
  /// hole; no pose of depths.csv needs them, and they cost a third of the median.
  std::size_t pushes = 8;
  /// Of the depth of the deepest point of a sketch in the other body at the device pose: a settled
  /// search with a best depth no larger needs no pushes, since no way out is much shorter than that
  /// point's. Of the 244 poses 241 are within 1 % with 1.5 and 2.5, as with pushes everywhere, in
  /// 15.3 and 13.9 ms in the median instead of 18.3 (beside other work). Beyond it the random
  /// starts of PD_g are overlaps too (with 1e9 none are: on the 128 poses of deep_tuning.csv, three
  /// seeds, 310 of 384 are then within 1 % instead of 359). Larger: a way out through a narrow gap
  /// may be missed.
  double narrow = 2.5;
  double nearest_push = 0.1;   ///< of the best depth, or of R where that is less
  double farthest_push = 0.8;  ///< the same
  /// Of the best depth: overlaps further out are not pushed apart, and where one has been pushed to
  /// within so much of the best place it would come down there.
  double given_up_at = 1.3;
  double known_within = 0.1;

  // Random starts
  /// After sketches have said what they can. On depths.csv, 16, 32, 64 and 160 of them leave the
  /// same poses of three seeds over 1 % too deep; with the bodies moved, 32 lose two poses more
  /// than 64, one by 22 %. StaticOptions::starts is the limit where there are no sketches.
  /// Where overlaps are pushed apart in their place: with 32, 64 and 128 of them 348, 359 and 368
  /// of those 384 are within 1 %, in 52 to 65, 62 to 79 and 88 to 100 ms in the median.
  int most_after_sketches = 64;
  /// Grid cells: where sketches lie deeper in each other, a random pose is no free one, and the
  /// bodies are not asked. Lower: poses are lost that sketches are wrong about.
  double plainly_deep = 0.3;
  /// Random poses of one ball, of which one is to be free. With none of them free the ball grows,
  /// and a way out close by may be passed over.
  int tries_in_a_ball = 50;
  int near_tries = 12;          ///< the same for near starts: pockets are small
  int near_tries_timed = 5;     ///< and with a budget of time, which they would use up
  double near_growth = 1.6;     ///< of the balls of near starts
  double far_growth = 1.2;      ///< of the balls of far starts
  double smallest_ball = 2e-3;  ///< R: of near starts; the first that is looked into
  /// R (far starts: of the first ball): no free pose is looked for further.
  double largest_ball = 4;
  double near_again = 0.3;  ///< of where one was free: the next one is looked for from here on
  /// |v|: poses that turn further, 128°, are left out: the chart bends strongly there. A way out by
  /// such a turn is found by descents only.
  double largest_start_v = 0.9;
  /// Best ends that starts are made about: where there are many, the better ones lie together.
  std::size_t ends_for_starts = 6;
  double about_nearest = 0.03;    ///< of the best depth: radius of the ball about an end, at least
  double about_wider = 0.47;      ///< and so much more at most; most are near the least
  double nearest_overlap = 0.1;   ///< of the best depth: between solids, overlaps to push apart
  double farthest_overlap = 1.2;  ///< the same
  double far_widths[3] = {0.75, 1.15, 1.5};  ///< of the best depth: that itself holds no free pose

  // Descents of one start, by leaps: roughly by outlines, then by the true contacts
  int rough_steps = 15;
  double rough_reach = 0.3;  ///< of |y|: the first leap
  /// Of the best depth: a rough descent that ends above is not made exact. Lower: places are lost
  /// that outlines make look worse than they are.
  double worth_exact = 1.2;
  int exact_steps = 12;
  double exact_reach = 0.1;
  int exact_steps_alone = 15;  ///< where there was no rough one
  double exact_reach_alone = 0.2;
  double exact_tolerance = 0.01;  ///< of |y|; refined later
  /// Of the best depth: where a descent, rough or exact, is given up since it will not end below.
  double hopeless_rough = 1.1;
  double hopeless_exact = 1.02;

  // The end
  /// Of the depth: depths that differ by less are the same one, and ends are at one place. Starts
  /// that agree stop the search: larger, it may stop at a place so much deeper.
  double same = 0.02;
  std::size_t refined = 3;  ///< places, the best
  /// Of the best depth: where descents ended further out nothing is refined. They end a thousandth
  /// or so above what there is.
  double worth_refining = 1.01;
  /// Of the best depth: a translation no deeper competes with six degrees, which go on from it.
  double translation_competes = 1.001;

  // The lower bound where it is not to take longer than the search
  /// Units of its work (BoundOptions) for each start on sketches and for each step of the bodies
  /// that the search made. On the 224 poses of depths.csv with a solid it then takes 17 % of the
  /// time in the median, and its median is 0.66 of the reference instead of 0.85. Half as many
  /// again: 0.70, and it takes longer than the search on 11 of them.
  int bound_for_a_sketch = 28;
  int bound_for_a_step = 95;
  /// µs: with less of a limited time left there is none, unless it was asked for: the points that
  /// it begins with would take longer.
  double least_us_for_bound = 300;
};
inline constexpr SearchTuning search_tuning;

}  // namespace sonde
