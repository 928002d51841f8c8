// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace sonde {

/// The numbers that the lower bound is made by. They decide how near it comes to the depth and what
/// it costs; it holds whatever they are, and a limit that acts leaves it lower. How much work it
/// may have is BoundOptions::work. Chosen by trial on the 224 poses of `tests/reference/depths.csv`
/// with a solid: the median of bound / reference is 0.85 (`test_reference
/// --gtest_filter='Depths.Full_the_lower*'`), but where a line says otherwise.
struct BoundTuning {
  // Rotations (TurnSearch)
  int work_of_evaluation = 10;  ///< of a point's depth in both bodies; that of a cell is 1
  double first_look = 4000;     ///< units of work: then it is asked whether more is worth while
  double look_growth = 1.5;     ///< from one such look to the next
  /// Between two looks: it ends where the bound rose by less. What more work would add is lost.
  double worth_going_on = 1.02;
  /// Witnesses that a cell keeps, the deepest; those found elsewhere that it takes in at a time,
  /// the last. Without the others a cell's bound may be lower.
  std::size_t most_near = 6;
  std::size_t most_new = 64;
  /// Of what the cell's turns do to a witness: where it lies further away, a nearer one is looked
  /// for.
  double from_afar = 1.4;
  double least_away =
      1e-3;                 ///< of a witness's depth: nearer, the quadratic form is ill-conditioned
  double first_away = 0.3;  ///< of what the cell's turns do: where the form is tangent
  int tangents = 2;         ///< forms tried
  double stride = 0.3;      ///< of the depth here: how far uphill from a cell's middle
  int ascent = 2;           ///< evaluations uphill

  // Points to begin with (deep_points). Each cap leaves points unseen, that may have been deeper.
  std::size_t most_points = 4;
  int most_meetings = 3;   ///< pairs of triangles that meet
  int most_opened = 400;   ///< pairs of boxes on the way to them
  int most_corners = 100;  ///< evaluations at the corners of each body
  int most_boxes = 60;     ///< of the cover of where two solids overlap
  double large_triangle =
      0.1;             ///< half of its box's diagonal, of the body's radius: looked at inside
  double apart = 0.5;  ///< of the depth: points nearer to each other are one
  double meeting_stride = 0.02;  ///< of the smaller radius: uphill from where triangles meet
  int meeting_ascent = 8;        ///< evaluations
  double last_stride = 0.5;      ///< of the depth, uphill at the end
  int last_ascent = 10;          ///< evaluations
  double inwards[3] = {0.75, 0.5, 0.25};  ///< of the way from the centre of mass
  double as_deep = 0.97;  ///< of the depth: further inwards as long as it is no less

  // Uphill (CommonDepth::ascend)
  int more_without_any = 3;    ///< times as many evaluations, until there is any common point
  double level = 0.05;         ///< |gradient|: below it, it leads nowhere
  double stride_at_top = 0.5;  ///< of the stride, on a ridge
  double stride_growth = 1.5;  ///< where it led higher
  double stride_decay = 0.35;  ///< where it did not
  std::size_t bundle = 4;      ///< gradients that count, the last
  int bundle_steps = 12;       ///< of Frank and Wolfe, to the least of their hull
};
inline constexpr BoundTuning bound_tuning;

}  // namespace sonde
