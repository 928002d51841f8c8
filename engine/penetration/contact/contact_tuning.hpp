// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace sonde {

/// Constants of the contact rows, of the least-distance problem that they form, and of contact
/// clusters. Sweeps and overlap tests decide what a step may do, so missing or bad rows make a step
/// shorter but never wrong. Unless a line says otherwise, the numbers were chosen by trial on the
/// paths of the bundled scenes (`sonde-ticks`).
struct ContactTuning {
  // Caps on rows and pairs (ContactRows)
  /// Maximum number of rows; at most six of them are active. When it is reached, further contacts
  /// give no row. Steps that they block are cut short, and if that ends the descent, the answer is
  /// not converged.
  std::size_t most_rows = 256;
  /// Pairs that a gather of the coherent solver makes rows of, the nearest. These rows are a first
  /// guess; cut() finds the others.
  std::size_t most_pairs = 48;
  /// Pairs, the deepest, that one check of a path may find; the next check finds the others. Where
  /// faces lie on each other, many pairs keep their gaps and are not in the way.
  std::size_t most_cut = 48;
  /// Pairs that every gather examines again, wherever the probe is. Six pairs hold the probe at a
  /// time; there is room for those found in the last few ticks. A pair that is forgotten cuts a
  /// step short again.
  std::size_t most_kept = 32;

  // What makes a row
  /// Share of a pair's gap, or of the margin if that is smaller, that a step must leave. A smaller
  /// loss gives no row. A gap that shrinks tick by tick does not recover while the probe is
  /// pressed.
  double kept_share = 0.95;
  /// Expected turn (rad) × radius / reach: a gather keeps the rows that come in within this turn.
  /// (A step as long as the reach turns the probe this far about its thinnest axis; with 2, steps
  /// of torus-knots alternated between two sets of rows.)
  double turn_per_reach = 8;
  /// Share of a row's gap: a pair that the row's direction separates by at least this takes over
  /// that direction. (Where faces lie on each other, the own direction of a pair beside the contact
  /// may lie in the faces: a wall where there is none. With 1 - 1e-9, rounding decided, and old
  /// rows of a block that rocks on a slab erred by 2 % of the torque instead of 0.0004 %.)
  double same_gap = 0.99;
  /// Factor on a row's gap, or on the margin if that is larger: a pair further away is held by its
  /// own direction, not by the row's. (With 100, a bore's wall held a rod that was 0.3 µm clear of
  /// it and free to leave.)
  double far_from_row = 2;
  double same_normal = 1 - 1e-12;  ///< cosine: of rows this parallel, the nearer may suffice
  /// Cosine between a face and the normal: below it, two triangles are seen edge on and have no
  /// overlap.
  double edge_on = 0.05;
  /// Share of the largest |v|: beyond it, the rim of the chart is a row too.
  double rim_from = 0.9;

  // Where pairs are looked for
  /// Share of the reach that a gather asks for: a list in use that reaches this far suffices, and
  /// cut() finds the missing pairs.
  double least_share_of_reach = 0.1;
  /// Share of a step's length: the reach that a list made for the step has left at its end, for the
  /// gather there. (p99 of a tick with nothing left: nut-on-bolt 1678 µs; with 0.05, 0.1 and 0.2 of
  /// it 1417, 1324 and 1462 µs. With a budget of 800 µs, 187 of its ticks did not converge, and
  /// 200, 131 and 171. The other scenes differ by at most 5 %.)
  double reach_after_step = 0.1;
  double least_reach_of_flat = 4;  ///< times the gap of a flat pair: least reach of any gather
  double crowded_to = 0.5;         ///< factor on the reach after a gather that was too much work
  double crowded_growth = 1.5;     ///< growth of the reach from gather to gather after that
  double path_kept = 0.9;          ///< decay of the recent path per tick; a longer one replaces it
  double path_without_room = 0.5;  ///< factor on the recent path if its list had no room

  // Lists of pairs
  /// Share of the effort left in a tick that a list may take. A longer list is continued in the
  /// next ticks.
  double share_for_list = 0.75;
  /// Multiple of the same effort: a list that takes more (as much as several ticks have) is made
  /// smaller the next time.
  double affordable_list = 8;
  /// Share of a list's reach that is kept for deviations from the recent course; the rest is for
  /// travel along it. When lists were due, the probe was off their course by 1 % of its path on
  /// nut-on-bolt and peg-in-hole, and by 10 to 14 % on torus-knots, linked-tori and spoon-in-cup
  /// (medians; 2 to 30 % in three of four).
  double share_beside_course = 0.25;
  /// Least share of that for turning, and for sliding; the remainder is split as in the course.
  /// (Ticks of the ball in its socket, nut-on-bolt and the nut jam that did not converge with
  /// 80 000 units a tick: with 0.2 293, 51 and 1766, with 0.3 269, 14 and 1589, with 0.4 229, 14
  /// and 1754. With 0.5, a rod that slides in its hole without turning has no list.)
  double least_share_of_turn = 0.3;
  /// Share of the effort that a tick leaves over, for the next list. That list is to serve for
  /// `ticks_of_next_list` ticks beyond those that it takes to make (estimated from the recent
  /// left-overs), but for no more than `most_ticks_ahead` ticks in all; if that costs too much, for
  /// a share of them (`least_of_next_list`). (nut-on-bolt with 90 000 units a tick, ticks that did
  /// not converge: 120; with 1, 3 and 6 ticks 178, 141 and 164, with 12 at most 129, with the
  /// left-over of the last tick alone 162, with a share of 0.6 131. A probe that falls behind may
  /// stay behind for hundreds of ticks.)
  double share_for_next_list = 0.8;
  double left_over_learned = 0.1;
  double ticks_of_next_list = 4;
  double most_ticks_ahead = 8;
  double least_of_next_list = 0.4;
  double room_for_path = 1.5;  ///< factor on the path ahead that a list covers at least

  // Work, in units of Effort
  int work_of_pair = 16;

  // Triangles that touch (separating_directions, touching_points)
  /// Sine of an angle: edges more nearly parallel give no direction and have no crossing. They
  /// touch along a line, whose ends are corners.
  double parallel_edges = 1e-6;
  /// rad: directions that differ by less count as one, which is accurate to a thousandth of the
  /// displacement that the probe may make.
  double same_direction = 1e-12;
  /// Directions tried, each with all pairs: 10 ns each. A corner in a corner of solids has some 50,
  /// a corner of six faces on another some 400. If there are more, the pose is left to the search.
  std::size_t most_directions = 512;

  // The nearest point (least_distance)
  double solved_to = 0.05;  ///< share of the margin: tolerated violation of a row
  /// Rounds (each adds the most violated row), and rows that may leave in one round. Both limits
  /// act only if rounding makes the method cycle. At the first the current point is returned, at
  /// the second "infeasible", and the step is made from open rows, or shorter.
  int most_rounds = 200;
  int most_leaving = 64;
  double dependent = 1e-14;        ///< |rest|²/|n|²: a normal that depends on the active ones
  double least_influence = 1e-12;  ///< of an active row on a new normal; less is rounding
  /// Ratio of pivots: start rows that are more nearly dependent than this are not used. The
  /// multipliers lose accuracy with its square.
  double start_dependent = 1e-3;

  // Clusters (contact_clusters)
  /// Distance (in R) and cosine between normals (15°) up to which contacts are one to the eye and
  /// to the hand. A smooth contact patch, which lies on a few triangles, stays one cluster as it
  /// slides over others.
  double near_by = 0.25;
  double agreed = 0.966;
  /// Tilt (rad) and height (in R) up to which faces lie on each other: what the clearance, at most
  /// 1e-4 R, leaves them.
  double flat = 1e-3;
};
inline constexpr ContactTuning contact_tuning;

}  // namespace sonde
