// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace sonde {

/// Constants of the contact rows of the haptic loop: which rows the geometry hands to the servo
/// (ContactFeed), and how the servo uses them until the next ones arrive (separate_locally). The
/// tables are those of resources/docs/understand/haptic-loop.md, "What old rows cost"
/// (`sonde-ages`). Lengths are in parts of R, the probe's radius, unless a line gives another unit.
struct LoopTuning {
  // Rows that are handed over (ContactFeed)
  /// Maximum number of rows, those that hold the probe first. The nearest contact without room
  /// limits the reach of the rows: the separated pose may then move less far until the next answer
  /// of the geometry, and the force lags (`held_back`).
  int most_rows = 64;
  /// Near pairs from which rows are made. If there are more, the reach is smaller.
  std::size_t most_pairs = 192;
  double widest = 0.5;  ///< reach: no probe moves further while the geometry is busy
  /// Share of the reach of the near rows: as long as the probe has moved by less, they are not
  /// gathered again. They move with the probe, and their reach decreases by the motion. Processor
  /// time of the geometry beyond the solver's (median, 90th percentile, µs): on nut-on-bolt 197,
  /// 1314 with 0 and 30, 862 with this value; on peg-in-hole 128, 485 and 14, 341; on spoon-in-cup
  /// 85, 501 and 2, 159. The errors of rows that are 1 to 20 ticks old are the same (`sonde-ages`),
  /// also with 0.25, which gains little.
  double moved_with_rows = 0.1;
  /// Share of the solver's budget that gathering rows may take in addition. If that runs out, the
  /// rows are those of the solver's list of pairs, and the next gather continues its own list and
  /// has a smaller reach.
  double budget_of_rows = 0.5;
  /// After this many queries of the bodies in a row that took more than that, only one of 2⁵
  /// refreshes tries again (ContactFeed::look_around). (A nut on its bolt: no query fits into 0.4
  /// ms, since the boxes of its trees overlap however short the reach. On nut-on-bolt, 17 s, the
  /// geometry took 376 and 422 µs in the median if each refresh tried, 71 and 72 % of the ticks
  /// were in step, and the force faded in 399 and 558; with 3 it was 112 and 119 µs, 90 and 88 %,
  /// 305 and 282 ticks; with 5 112 and 100 µs, 93 and 92 %, none and 203. Two nuts that were not
  /// used to choose it gain nothing: haptic-loop.md.)
  int most_failed_looks = 5;
  /// µs: how far the limit of a refresh grows while answers do not converge (RefreshLimit). With
  /// the rows, whose limit does not grow (budget_of_rows), an answer takes 6.8 ms, and is in use
  /// until the next one, with the rest between them up to an age of 15.4 ms; the force is withheld
  /// after 20 (SafetySettings::stalled_after). Ticks of 20 s whose force faded, and to what share,
  /// with 800 (no growth) and with this value (`sonde-soak`): terrain 198 to 47 %, 124 to 78 %;
  /// crumpled-soup 718, 216 of them to nothing, 468, 36; a ball in its socket 67 to 38 %, none; a
  /// jammed nut 651, 289 to nothing, 440, 144. Only nut-on-bolt, which cannot keep up with either,
  /// fares no better.
  double longest_refresh_us = 6400;
  double flat_within = 4;  ///< margins: nearer pairs give a row for each corner of their overlap
  double margin_of_clearance = 0.5;  ///< share of allowed_clearance: the gap that rows keep
  /// Rows that come first if there is no room for all: those that would hold the probe if the
  /// device continued its motion for this many ticks, or moved by `support_reach` in any of twelve
  /// directions (for a probe of 5 cm, the motion of one tick at 1 m/s). In flat contact, the
  /// nearest 64 rows may all belong to one corner. The largest error of rows five ticks old on
  /// peg-in-hole is 27.8 % of the force with the nearest rows, 3.1 % with these.
  double support_ticks[3] = {3, 8, 20};
  double support_reach = 0.02;

  // Rows at another device pose (separate_locally)
  /// Number of times that the rows are linearised. More changed nothing in `sonde-ages`; an answer
  /// that has not settled by then has the error of the last linearisation.
  int most_rounds = 3;
  double solved_to = 1e-9;       ///< tolerated violation of a row
  double settled_depth = 1e-5;   ///< share of |y|: the last round changes the rows by less
  double settled_radius = 1e-9;  ///< the same, share of R
  double least_part = 1e-3;  ///< share of a step that turns too far: a smaller part is not tried
  /// Distance that the separated pose may move from that of the geometry; if the reach of the rows
  /// is larger, that counts instead. If it would move farther, it lags, and `held_back` is set.
  double trusted = 0.1;

  // Searches outside the loop
  /// Limits of the search for a start in overlap (StaticOptions). The user waits for it, and it
  /// only has to find a separated pose to follow from, not the nearest one to the last per cent.
  int starts_at_begin = 64;
  int agreement_at_begin = 6;
  /// Limits of the background search: its answer should keep up with the hand, and the end of the
  /// program should not wait for it. These limits may make the answer deeper, but everything that
  /// it states remains true.
  double background_us = 300'000;
  int background_starts_pdt = 6;
  /// Share of the followed depth: a pose of the search counts as nearer only if its depth is below
  /// this. Both depths are results of iterations, so a smaller difference does not show a different
  /// separating motion.
  double clearly_nearer = 0.98;
};
inline constexpr LoopTuning loop_tuning;

}  // namespace sonde
