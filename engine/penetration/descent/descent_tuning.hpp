// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace sonde {

/// Constants of the steps of the two descents on contacts (Descent, which sweeps its path free, and
/// LeapDescent, which does not). They decide how soon a descent ends and, for the search, where.
/// The result is verified whatever they are. Unless a line says otherwise, they were chosen by
/// trial on the poses of `tests/reference` and the paths of the bundled scenes. Lengths are in m of
/// y unless a line gives another unit; R is the probe's radius.
struct DescentTuning {
  /// |v| of a pose: no descent begins beyond it (179.98°), since the chart ends at 1. None turns
  /// further than Chart::largest_v, or than where it began. (With 0.9, the best separations of four
  /// of the 16 dovetails of deep_tuning.csv, which turn by 138 to 150°, are never found. A plug
  /// that is the wrong way round in its socket turns back by all but its play: with 0.99999,
  /// 179.5°, one of seven keyed plugs with a play of 0.6° was answered 2.3 times as deep from there
  /// on.)
  double largest_start_v = 0.99999999;

  // Each step
  /// |Δv|, about half the angle, rad: beyond it, the linearisation of a turn is too inaccurate. A
  /// longer step is shortened, which costs more steps but does not mislead the descent.
  double largest_turn = 0.3;
  /// A step that leaves the chart slides along its rim if less than this share of the step lies
  /// inside. (On crumpled-soup, one tick did not converge with 0.001 to 0.1, and 189 with 0.5; 178
  /// did not if every such step slid along the rim.)
  double least_way_to_rim = 0.1;
  /// Maximum number of rows that are replaced at one pose. (More than a few do not occur; two rules
  /// that undo each other would go on for ever.)
  int most_replaced = 16;
  /// Maximum number of times that a step is recomputed to avoid obstacles on its path. After that,
  /// a swept step goes as far as its path is free, and a leap is not made; this is counted in
  /// Outcome::limited.
  int most_cuts = 6;
  /// 1/R: initial estimate of how strongly contacts bend into the path (κ).
  double first_bending = 0.5;
  double most_bending = 1e6;   ///< 1/R: beyond it, the room is the whole step anyway
  double least_bending = 0.1;  ///< 1/R
  double bending_growth = 4;   ///< factor after a contact cut the path short in its first half
  double bending_decay = 0.5;  ///< factor after any other path

  // Room above the contacts that a straight step leaves, because they bend into it
  /// Share of |step|²/|y|: more room would cost more depth than the step gains.
  double most_room = 0.8;
  /// Share of the step's squared length: least gain −y·step of a step that leaves room.
  double least_gain = 0.1;
  /// In margins: if a contact is nearer than `crowded_gap`, the step moves the probe away from it,
  /// up to one margin, even if |y| rises by up to `most_lift`. Otherwise the gaps, which shrink
  /// tick by tick, would finally block every straight path.
  double crowded_gap = 0.5;
  double most_lift = 1;
  double less_room = 0.25;     ///< factor on the room if a step with that room gains too little
  double rise_per_loss = 1.2;  ///< times the gap that a path lost to contacts that bend into it

  // Length of steps
  double first_scale = 0.05;        ///< R: length of the first step if nothing is known
  double first_longest = 0.02;      ///< R: longer paths are expensive where surfaces slide
  double longest_per_expected = 8;  ///< times the expected step
  double longest_growth = 1.5;      ///< factor from step to step
  /// Units of Effort, some 3 ms: a sweep that takes more is given up, and the next path is shorter.
  /// Where parts fit all round, its work grows with about the cube of its length, so that some
  /// short paths take far less than a long one. (Chosen on three nuts that jam on their bolts,
  /// among 50, 100 and 300 thousand: less makes the longest ticks shorter by a quarter to a half,
  /// and more ticks do not converge. On two other nuts the longest tick, a fall by half a turn,
  /// went from 1323 and 2378 ms without a limit to 118 and 101.)
  std::int64_t most_work_of_sweep = 300'000;
  /// Margins: no path is made shorter because its sweep takes too much.
  double least_path = 8;
  /// Factor on the length of a path whose sweep used up the effort: the next path is no longer.
  double longest_after_giving_up = 0.25;
  /// Share of that length, which grows by a factor from path to path: no path is longer. Else every
  /// third path is as long again, and its sweep in vain. (Longest ticks of two jammed nuts, ms, for
  /// a growth of 1.02, 1.05, 1.1 and 1.2: 54 and 33, 42 and 26, 45 and 30, 47 and 28; without this
  /// limit 65 and 38. With a share of 0.5 and 0.9, 49 and 25, 43 and 29. On three nuts that chose
  /// nothing, 83, 71 and 193 went to 48, 36 and 136.)
  double most_of_given_up = 0.7, given_up_growth = 1.05;
  /// Cosine of the angle between two consecutive steps: below it, the steps undo each other across
  /// a sharp edge.
  double turns_back = -0.25;
  /// Cosine of the angle between two consecutive steps: above it, the second continues the first.
  double same_way = 0.99;
  /// Difference of two ratios of consecutive steps: below it they are the same, and the steps make
  /// up a geometric series. (Of a ball of 16 sides in a groove they differ by 0.0003 to 0.01.
  /// Without this, steps of which obstacles cut off parts count as series: of a cone in its bore
  /// ten ticks did not converge where one did not.)
  double same_ratio = 0.05;
  /// Steps: a shorter sum is not worth its look at the path. (With 3, a coarse ball in its socket
  /// takes 6943 steps instead of 6427.)
  double least_extrapolation = 1.5;
  /// Steps of a run after which its steps are mixed (StepMixing): most runs end before. (Ticks that
  /// do not converge of a ball and an egg in grooves, peg-in-hole, terrain and crumpled-soup, which
  /// chose it: 27 without, 20 with. Before steps in a series were left out, it was 39, 29 and 24
  /// with 12, 16 and 24. Of 140 paths of 70 pairs of parts that chose nothing: 90 ticks without, 23
  /// with.)
  int steps_before_mixing = 16;
  /// Maximum number of consecutive secant steps: if more are needed, the wanted step is not a
  /// linear function of the pose.
  int most_secants = 3;

  // Reach of the search for rows
  double widest_reach = 0.03;  ///< R: gathering further costs more than it gains
  double reach_at_first = 2;   ///< times the expected step
  double reach_later = 0.5;    ///< times the last step: older rows still describe the rest
  double least_reach = 16;     ///< margins
  double flat_within = 4;      ///< margins: nearer pairs give the corners of their overlap as rows

  // The end
  double settled_gap = 1.9;     ///< margins: below it the probe touches; a descent aims at one
  double touching_gap = 2;      ///< margins: above it the probe is moved into contact
  double off_in_margins = 0.2;  ///< margins: a hand cannot feel a shorter step
  /// Consecutive steps without progress after which a descent ends; counted in Outcome::limited.
  int most_stalled = 4;
  double nowhere = 1e-3;  ///< of max(margin, 1e-3 of the wanted step): no progress
};
inline constexpr DescentTuning descent_tuning;

}  // namespace sonde
