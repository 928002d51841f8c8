// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace sonde {

/// The numbers of the haptic loop's contact rows: which of them the geometry hands to the servo
/// (ContactFeed), and what the servo makes of them until it gets the next (separate_locally). The
/// tables are those of resources/docs/understand/haptic-loop.md, "What old rows cost"
/// (`sonde-ages`). Lengths are in parts of R, the probe's radius, unless a line gives another unit.
struct LoopTuning {
  // Rows that are handed over (ContactFeed)
  /// Rows, those that hold the probe first. What finds no room ends the reach of the rows: the
  /// separated pose may go less far until the next answer of the geometry, and the force lags
  /// (`held_back`).
  int most_rows = 64;
  /// Near pairs, whose rows are chosen from. Where there are more, the reach is less.
  std::size_t most_pairs = 192;
  double widest = 0.5;  ///< farther no probe goes while the geometry is busy
  /// Of the reach of the rows near by: so far the probe may move before they are gathered anew.
  /// They move with it until then, and reach less far by as much. Processor time of the geometry
  /// beyond the solver's, median and 90th percentile in us, with 0 and with this: nut-on-bolt 197,
  /// 1314 and 30, 862; peg-in-hole 128, 485 and 14, 341; spoon-in-cup 85, 501 and 2, 159. The
  /// errors of rows that are 1 to 20 ticks old are the same (`sonde-ages`), also with 0.25, which
  /// gains little.
  double moved_with_rows = 0.1;
  /// Of the budget of the solver, beside it: what gathering rows may take. Where that runs out, the
  /// last rows move with the probe, and the next gather goes on with the list of pairs and looks
  /// less far.
  double budget_of_rows = 0.5;
  double flat_within = 4;            ///< margins: pairs nearer than that give a row for each corner
  double margin_of_clearance = 0.5;  ///< the gap that rows are to keep, of allowed_clearance
  /// Which rows come first where there is no room for all: those that would hold the probe if the
  /// device went on as it does for so many ticks, or by so much any of twelve ways (at 1 m/s a tick
  /// of a probe of 5 cm). In flat contact the nearest 64 may be one corner. Largest error of rows
  /// five ticks old on peg-in-hole: 27.8 % of the force with the nearest, 3.1 % with these.
  double support_ticks[3] = {3, 8, 20};
  double support_reach = 0.02;

  // Rows at another device pose (separate_locally)
  /// Times that the rows are linearised again. Further ones changed nothing in `sonde-ages`; an
  /// answer that has not settled by then is off by what bends.
  int most_rounds = 3;
  double solved_to = 1e-9;       ///< violations of rows that are let stand
  double settled_depth = 1e-5;   ///< of |y|: a round that bends rows by less is the last
  double settled_radius = 1e-9;  ///< the same, of R
  double least_part = 1e-3;      ///< of a step that turns too far: a smaller part is not looked for
  /// The separated pose may go so far, or as far as the rows reach, from where the geometry left
  /// it, and no farther: it lags, and says `held_back`.
  double trusted = 0.1;

  // Searches beside the loop
  /// For a start in overlap, which somebody waits for: a place to follow from, not the last per
  /// cent (StaticOptions).
  int starts_at_begin = 64;
  int agreement_at_begin = 6;
  /// The background search: its answer should follow the hand, and closing should not wait. It may
  /// be deeper for that, and says nothing that is not so.
  double background_us = 300'000;
  int background_starts_pdt = 6;
  /// Of the followed depth: both are iterated, and what differs by less is no other way.
  double clearly_nearer = 0.98;
};
inline constexpr LoopTuning loop_tuning;

}  // namespace sonde
