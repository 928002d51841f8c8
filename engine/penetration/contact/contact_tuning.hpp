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
  /// Maximum number of pairs, the nearest, from which a gather of the coherent solver makes rows.
  /// These rows are a first guess; add_cuts() finds the others.
  std::size_t most_pairs = 48;
  /// Maximum number of pairs, the deepest, that one check of a path may find; the next check finds
  /// the others. Where faces lie on each other, many pairs keep their gaps and do not obstruct the
  /// path.
  std::size_t most_cut = 48;
  /// Maximum number of pairs that are kept and examined again by every gather, wherever the probe
  /// is. At most six pairs hold the probe at a time, so there is room for those found in the last
  /// few ticks. A pair that is forgotten obstructs a step again.
  std::size_t most_kept = 32;

  // What makes a row
  /// Share of min(gap, margin) that a step must leave to a pair. A pair that loses less gets no
  /// row. Only a small loss is tolerated, because a gap that shrinks tick by tick does not recover
  /// while the probe is pressed.
  double kept_share = 0.95;
  /// Expected turn (rad) × radius / reach: a gather keeps every row that a turn up to the expected
  /// one can make the nearer one. (A step as long as the reach turns the probe this far about its
  /// thinnest axis; with 2, steps of torus-knots alternated between two sets of rows.)
  double turn_per_reach = 8;
  /// Share of a row's gap: if the row's normal separates another pair by at least this, that pair
  /// uses the same normal. (Where faces lie on each other, the closest points of a pair beside the
  /// contact may have a direction in the plane of the faces; a row along it would forbid sliding
  /// that nothing obstructs. With 1 - 1e-9, rounding decided which normal was used, and rows some
  /// ticks old, of a block that rocks on a slab, had an error of 2 % of the torque instead of
  /// 0.0004 %.)
  double same_gap = 0.99;
  /// Factor on max(gap of a row, margin): if the row's pair is further apart than this along the
  /// direction of its own closest points, that direction replaces the row's normal. (With 100, a
  /// bore's wall held a rod that was 0.3 µm clear of it and free to leave.)
  double far_from_row = 2;
  /// Share of min(gap of a row, margin): the least gap along another axis that may replace the
  /// row's normal. A straight step keeps that gap, and later steps regain the margin.
  double other_gap = 0.25;
  /// Mean slope, the fall of |y| per length, of the step that another axis allows: a row is not
  /// replaced for a smaller one. (Seven ticks of a chain's link on another link: with 0.1, the
  /// probe stayed held in four of them, although unobstructed steps with slopes of 0.11 to 0.16
  /// began there; with this value in none.)
  double least_slope = 0.05;
  /// Cosine: of two rows that are this parallel, the nearer may imply the other.
  double same_normal = 1 - 1e-12;
  /// Cosine between a face and the normal: below it, two triangles are seen edge on and have no
  /// overlap.
  double edge_on = 0.05;
  /// Share of Chart::largest_v: if |v| exceeds it, the rim of the chart is a row too.
  double rim_from = 0.9;

  // Reach of the search for pairs
  /// Share of the reach that a gather asks for: a list in use that has at least this reach
  /// suffices, and add_cuts() finds the missing pairs.
  double least_share_of_reach = 0.1;
  /// Share of a step's length: the reach that a list made for the step still has at the end of the
  /// step, for the gather there. (On nut-on-bolt, with 0, 0.05, 0.1 and 0.2, the p99 of a tick is
  /// 1678, 1417, 1324 and 1462 µs, and with a budget of 800 µs 187, 200, 131 and 171 ticks do not
  /// converge. The other scenes differ by at most 5 %.)
  double reach_after_step = 0.1;
  double least_reach_of_flat = 4;  ///< times the gap of a flat pair: least reach of any gather
  double crowded_to = 0.5;         ///< factor on the reach after a gather that was too much work
  double crowded_growth = 1.5;     ///< growth of the reach from gather to gather after that
  double path_kept = 0.9;  ///< factor on the recent path per tick; a longer path replaces it
  double path_without_room = 0.5;  ///< factor on the recent path if its list had no room

  // Lists of pairs
  /// Share of a tick's remaining effort that building a list may take. A list that needs more is
  /// continued in the next ticks.
  double share_for_list = 0.75;
  /// Multiple of the same effort, about as much as several ticks have: if a list takes more, the
  /// next list is made smaller.
  double affordable_list = 8;
  /// Share of a list's reach that is kept for deviations from the recent course; the rest is for
  /// travel along it. When a list had to be replaced, the probe was off its course by 1 % of its
  /// path on nut-on-bolt and peg-in-hole, and by 10 to 14 % on torus-knots, linked-tori and
  /// spoon-in-cup (medians; 2 to 30 % in three of four). (With 0.25, 0.15, 0.1 and 0.05, 603, 327,
  /// 293 and 551 ticks of nut-on-bolt do not converge with 50 000 units a tick, and 17, 34, 56 and
  /// 153 with 80 000, where the next list is for the device's motion about the centre of mass.)
  double share_beside_course = 0.15;
  /// That share is divided between turning and sliding in the ratio that they have in the course,
  /// but each of the two gets at least this part. (Ticks of the ball in its socket, nut-on-bolt and
  /// the nut jam that did not converge with 80 000 units a tick: 293, 51 and 1766 with 0.2; 269, 14
  /// and 1589 with 0.3; 229, 14 and 1754 with 0.4. With 0.5, a rod that slides in its hole without
  /// turning has no list.)
  double least_share_of_turn = 0.3;
  /// Share of a tick's unused effort that is spent on the next list. That list should remain valid
  /// for `ticks_of_next_list` ticks after its completion, but for no more than `most_ticks_ahead`
  /// ticks in all. The ticks that it takes to build are estimated from the unused effort of recent
  /// ticks. If such a list costs too much, it covers a share of these ticks (`least_of_next_list`).
  /// (On nut-on-bolt with 90 000 units a tick, 120 ticks did not converge. It was 178, 141 and 164
  /// with `ticks_of_next_list` 1, 3 and 6; 129 with `most_ticks_ahead` 12; 162 if estimated from
  /// the last tick alone; 131 with a share of 0.6. A probe that falls behind may stay behind for
  /// hundreds of ticks.)
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
  /// Maximum number of directions. Each is tried with all pairs, at 10 ns a pair. A corner of one
  /// solid in a corner of another gives some 50 directions, a corner of six faces on another such
  /// corner some 400. If there are more, the pose is left to the search.
  std::size_t most_directions = 512;

  // The nearest point (least_distance)
  double solved_to = 0.05;  ///< share of the margin: tolerated violation of a row
  /// Maximum number of rounds, each of which adds the most violated row, and of rows that leave the
  /// active set in one round. Both limits act only if rounding makes the method cycle. After
  /// `most_rounds` the current point is returned. After `most_leaving` the problem is reported as
  /// infeasible; the caller then takes a step with relaxed rows, or a shorter step.
  int most_rounds = 200;
  int most_leaving = 64;
  double dependent = 1e-14;  ///< |rest|²/|n|²: below it, a normal depends on the active ones
  double least_influence = 1e-12;  ///< of an active row on a new normal; less is rounding
  /// Ratio of pivots: start rows that are more nearly dependent than this are not used. The
  /// multipliers lose accuracy with its square.
  double start_dependent = 1e-3;

  // Clusters (contact_clusters)
  /// Distance (in R) and cosine between normals (15°) up to which a user sees and feels two
  /// contacts as one. With them, a smooth contact patch, which lies on a few triangles, stays one
  /// cluster as it slides over other triangles.
  double near_by = 0.25;
  double agreed = 0.966;
  /// Tilt (rad) and height (in R) up to which two faces count as lying on each other. The
  /// clearance, at most 1e-4 R, can tilt and lift them by about that much.
  double flat = 1e-3;
};
inline constexpr ContactTuning contact_tuning;

}  // namespace sonde
