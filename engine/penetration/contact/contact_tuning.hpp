// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace sonde {

/// The numbers that contact rows, the problem of the nearest point that satisfies them, and their
/// clusters are made by. What a step may do is decided by sweeps and by tests of overlap: too few
/// rows, or bad ones, make it shorter, and never wrong. Chosen by trial on the paths of the bundled
/// scenes (`sonde-ticks`), but where a line says otherwise.
struct ContactTuning {
  // Caps on rows and pairs (ContactRows)
  /// Rows, of which six at most are active. Beyond, a contact adds none, steps that it is in the
  /// way of are cut short, and the answer is not converged where that is what ends it.
  std::size_t most_rows = 256;
  /// Pairs that a gather of the coherent solver makes rows of, the nearest. A first guess: cut()
  /// finds the rest.
  std::size_t most_pairs = 48;
  /// Pairs, the deepest, that one look may find; the next look finds what is left. Where faces lie
  /// on each other many of them keep their gaps, and are not in the way.
  std::size_t most_cut = 48;
  /// Pairs that are looked at again wherever the probe has come to. Six hold it at a time; those of
  /// the last few ticks' looks find room. One that is forgotten cuts a step again.
  std::size_t most_kept = 32;

  // What makes a row
  /// Of its gap, or of the margin, a step may take so little from a pair that it need not be
  /// thought over: what is lost tick by tick is not to be had back while the probe is pressed.
  double kept_share = 0.95;
  /// A gather turns the probe by so much more than its reach by the radius, about: rows that would
  /// come in then are not dropped (rotation by a step of the size of the reach, about the thinnest
  /// axis; with 2, steps of torus-knots went to and fro between two sets of rows).
  double turn_per_reach = 8;
  /// Of a row's gap: a pair that the row's direction separates by so much takes that direction, not
  /// its own. (Where faces lie on each other, the own one of a pair beside the contact may lie in
  /// the faces: a wall where there is none. With 1 - 1e-9, rounding decided, and old rows of a
  /// block that rocks on a slab erred by 2 % of the torque instead of 0.0004 %.)
  double same_gap = 0.99;
  /// Of a row's gap, or of the margin: a pair further away is held by its own direction, not by
  /// the row's. (With 100 a bore's wall held a rod that was 0.3 µm clear of it, free to leave.)
  double far_from_row = 2;
  double same_normal = 1 - 1e-12;  ///< cosine: rows of one direction, of which the nearer may do
  /// Cosine between a face and the normal: seen more edge on, two triangles have no overlap.
  double edge_on = 0.05;
  /// Of the largest |v|: beyond it the rim of the chart is a row too.
  double rim_from = 0.9;

  // Where pairs are looked for
  /// Of the reach asked of a gather: what the list at hand holds will do, cut() finds what is
  /// missing.
  double least_share_of_reach = 0.1;
  /// Of a step's length: what a list that is made for the step has left at the end of it, for the
  /// gather there. (p99 of a tick with nothing left: nut-on-bolt 1678 µs, with 0.05, 0.1, 0.2 of it
  /// 1417, 1324, 1462; with a budget of 800 µs 187 of its ticks did not converge, and 200, 131,
  /// 171. The others within 5 %.)
  double reach_after_step = 0.1;
  double least_reach_of_flat =
      4;                        ///< of the gap up to which a pair is flat: any gather looks so far
  double crowded_to = 0.5;      ///< of the last reach: the next, after one that was too much work
  double crowded_growth = 1.5;  ///< from gather to gather, after that
  double path_kept = 0.9;       ///< of a path of late, from tick to tick, and where it is replaced
  double path_without_room = 0.5;  ///< of it, where there was no room for its list

  // Lists of pairs
  /// Of the effort that is left to a tick: a list that takes more goes on in the next ones.
  double share_for_list = 0.75;
  /// Of the same: one that takes more, as much as some ticks have, is made smaller the next time.
  double affordable_list = 8;
  /// Of a list's reach: what lies beside the course of late, the rest is for the way along it. When
  /// lists were due the probe was off their course by 1 % of its way on nut-on-bolt and
  /// peg-in-hole, 10 to 14 % on torus-knots, linked-tori and spoon-in-cup (medians; 2 to 30 % in
  /// three of four).
  double share_beside_course = 0.25;
  /// Of that: for turning, and for sliding, at least; the rest as the course has it. (With 80 000
  /// units a tick, ticks of the ball in its socket, nut-on-bolt and the nut jam that did not
  /// converge: with 0.2 293, 51 and 1766, with 0.3 269, 14 and 1589, with 0.4 229, 14 and 1754.
  /// With 0.5 a rod that slides in its hole without a turn has no list.)
  double least_share_of_turn = 0.3;
  /// Of the effort that a tick leaves over: for the next list. It is to serve for so many ticks
  /// beyond those that it takes to make, which are reckoned from what was left of late, but for no
  /// more than `most_ticks_ahead` in all; where that is too dear, for a part of them. (nut-on-bolt
  /// with 90 000 units a tick, ticks that did not converge: 120; with 1, 3 and 6 ticks 178, 141 and
  /// 164, with 12 at most 129, by what the last tick alone left 162, with a part of 0.6 131. Once
  /// the probe falls behind it may stay so for hundreds of ticks.)
  double share_for_next_list = 0.8;
  double left_over_learned = 0.1;
  double ticks_of_next_list = 4;
  double most_ticks_ahead = 8;
  double least_of_next_list = 0.4;
  double room_for_path = 1.5;  ///< of the path ahead: a list serves at least for so much

  // Work, in units of Effort
  int work_of_pair = 16;

  // Triangles that touch (separating_directions, touching_points)
  /// Sine: edges more nearly parallel give no direction of their own, and cross nowhere. Such edges
  /// touch along a line, whose ends are corners.
  double parallel_edges = 1e-6;
  /// rad: directions that differ by less are one, to a thousandth of what the probe may be moved.
  double same_direction = 1e-12;
  /// Directions tried, each with all pairs: 10 ns each. A corner in a corner of solids has some 50,
  /// a corner of six faces on another some 400. Beyond, the pose is left to the search.
  std::size_t most_directions = 512;

  // The nearest point (least_distance)
  double solved_to = 0.05;  ///< of the margin: violations of rows that are let stand
  /// Rounds, each of which takes in the row most violated, and rows that may leave in one. They are
  /// never needed but where rounding goes in a circle. At the first the answer is as it stands, at
  /// the second "infeasible", and the step is made by open rows, or shorter.
  int most_rounds = 200;
  int most_leaving = 64;
  double dependent = 1e-14;        ///< |rest|²/|n|²: a normal that the active ones make up
  double least_influence = 1e-12;  ///< of an active row on a new normal: less is rounding
  /// Of pivots: rows to begin with that are nearly dependent are not; its square is what the
  /// multipliers would suffer from.
  double start_dependent = 1e-3;

  // Clusters (contact_clusters)
  /// Contacts so near each other, of R, and so well agreed (15°) are one to the eye and to the
  /// hand; a smooth patch of contact, which lies on a few triangles, stays one as it slides over
  /// others.
  double near_by = 0.25;
  double agreed = 0.966;
  /// Faces that lie on each other: to the tilt, rad, and the height, R, that the clearance leaves
  /// them, which is 1e-4 R at most.
  double flat = 1e-3;
};
inline constexpr ContactTuning contact_tuning;

}  // namespace sonde
