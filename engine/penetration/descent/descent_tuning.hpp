// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sonde {

/// The numbers that the steps of the two descents on contacts are made by (Descent, which sweeps
/// its path free, and LeapDescent, which does not). They decide how soon a descent ends and, for
/// the search, where; what it ends with is verified whatever they are. Chosen by trial on the poses
/// of `tests/reference` and the paths of the bundled scenes, but where a line says otherwise.
/// Lengths are in m of y unless a line gives another unit; R is the probe's radius.
struct DescentTuning {
  // Each step
  /// |Δv|, about half the angle, rad: a linearised turn is of little use beyond. A longer step is
  /// shortened: more steps are lost, not the way.
  double largest_turn = 0.3;
  /// Of a step that leads out of the chart: with less than that up to its rim, it goes along it.
  /// (On crumpled-soup one tick did not converge with 0.001 to 0.1, 189 with 0.5, and 178 where all
  /// went along.)
  double least_way_to_rim = 0.1;
  /// Times that a step is made again round what its path would meet. After these it goes as far as
  /// its sweep is free, or a leap is not taken; counted in Outcome::limited.
  int most_cuts = 6;
  /// 1/R: how much contacts are thought to bend into the path at first (κ).
  double first_bending = 0.5;
  double most_bending = 1e6;   ///< 1/R: beyond it the room asked for is the whole step anyway
  double least_bending = 0.1;  ///< 1/R
  double bending_growth = 4;   ///< after a path that was cut short by a contact in its first half
  double bending_decay = 0.5;  ///< after any other

  // Room above the contacts, that a straight step has to leave as they bend into it
  /// Of |step|²/|y|: more room would cost more depth than the step gains.
  double most_room = 0.8;
  /// Of the step's gain, in |y|·m: a step with room that gains less is made without.
  double least_gain = 0.1;
  /// Margins: contacts that have come nearer are moved away from, to one margin, for |y| that may
  /// rise by so many margins. What gaps lose tick by tick would block every straight path at last.
  double crowded_gap = 0.5;
  double most_lift = 1;
  double less_room = 0.25;     ///< of the room tried before, where that is not to be had
  double rise_per_loss = 1.2;  ///< of what a path was found to lose to contacts that bend into it

  // Length of steps
  double first_scale = 0.05;    ///< R: of the first step, where nothing is known
  double first_longest = 0.02;  ///< R: longer paths cost much where surfaces slide along each other
  double longest_per_expected = 8;  ///< of the step that is expected
  double longest_growth = 1.5;      ///< from step to step
  /// Of a path whose sweep took all of the effort: the next may be so long.
  double longest_after_giving_up = 0.25;
  /// Steps that turn back by more than this cosine undo each other across a sharp edge.
  double turns_back = -0.25;
  /// Of such in a row, made by the secant method: beyond, what is wanted is not about linear.
  int most_secants = 3;

  // Where rows are looked for
  double widest_reach = 0.03;  ///< R: further costs more than it tells
  double reach_at_first = 2;   ///< of the step to be expected
  double reach_later = 0.5;    ///< of the last step: the rows before it still tell of the rest
  double least_reach = 16;     ///< margins
  double flat_within = 4;      ///< margins: triangles nearer than that give their overlap

  // The end
  double settled_gap = 1.9;  ///< margins: the probe touches; contacts are aimed at with one margin
  double touching_gap = 2;   ///< margins: beyond it the probe is brought up to its contacts
  double off_in_margins = 0.2;  ///< margins: a shorter step changes nothing that can be felt
  /// Steps in a row that lead nowhere, after which a descent ends; counted in Outcome::limited.
  int most_stalled = 4;
  double nowhere = 1e-3;  ///< of a margin, or of 1e-3 of the step that was wanted
};
inline constexpr DescentTuning descent_tuning;

}  // namespace sonde
