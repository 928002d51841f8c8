// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace sonde {

/// Constants of the lower bound of the depth. They decide how tight the bound is and what it costs.
/// The bound is valid whatever they are; a limit that acts only makes it lower. BoundOptions::work
/// limits the total work. Unless a line says otherwise, they were chosen by trial on the 224 poses
/// of `tests/reference/depths.csv` with a solid, where the median of bound / reference is 0.85
/// (`test_reference --gtest_filter='Depths.Full_the_lower*'`).
struct BoundTuning {
  // Rotations (TurnSearch)
  int work_of_evaluation = 10;  ///< units of work: a point's depth in both bodies; a cell: 1
  double first_look = 4000;     ///< units of work after which the gain is first checked
  double look_growth = 1.5;     ///< factor on the work from one check to the next
  /// The search ends if the bound rose by less than this factor between two checks.
  double worth_going_on = 1.02;
  /// Witnesses that a cell keeps (the deepest), and witnesses found in other cells that one update
  /// considers (the latest). With smaller numbers a cell's bound may be lower.
  std::size_t most_near = 6;
  std::size_t most_new = 64;
  /// A new witness is searched for if |R r − p| at the cell's middle exceeds this many times the
  /// displacement of r by the turns of the cell.
  double from_afar = 1.4;
  double least_away =
      1e-3;  ///< times the witness's depth: least tangent point a₀ (below: ill-conditioned)
  double first_away = 0.3;  ///< times the displacement of r by the cell's turns: first a₀
  int tangents = 2;         ///< tangent points tried
  double stride = 0.3;      ///< times the depth: first step of an ascent at a cell's middle
  int ascent = 2;           ///< evaluations of that ascent

  // Start points (deep_points). Each cap may leave out points that would have been deeper.
  std::size_t most_points = 4;
  int most_meetings = 3;            ///< intersecting pairs of triangles
  int most_opened = 2000;           ///< pairs of boxes opened to find them, for crossings too
  double share_for_corners = 0.05;  ///< of the work: evaluations at the corners of each body
  int most_boxes = 60;              ///< boxes of the cover of the overlap of two solids
  double large_triangle =
      0.1;  ///< half box diagonal / body radius: a larger triangle is also sampled inside
  double apart = 0.5;            ///< times the depth: points closer than this count as one
  double meeting_stride = 0.02;  ///< times the smaller radius: first step of an ascent from there
  int meeting_ascent = 8;        ///< evaluations of that ascent
  double last_stride = 0.5;      ///< times the depth: first step of the final ascent
  int last_ascent = 10;          ///< evaluations of the final ascent
  double inwards[3] = {0.75, 0.5, 0.25};  ///< factors on the distance from the centre of mass
  double as_deep = 0.97;  ///< times the depth: the search inwards ends at a shallower point

  // Crossings (best_crossing). Each limit leaves out curves that might have proved more.
  double worth_crossings =
      0.5;           ///< times the known depth: with a larger bound, no crossings are searched for
  double reach = 4;  ///< times the known depth: radius of the region examined about a place
  double comparisons_of_work = 300;  ///< comparisons that take the time of one unit of work
  std::size_t most_meets = 256;      ///< intersecting pairs of triangles, to choose places from
  double off_the_ends = 0.999;       ///< central share of a shared segment in which places lie
  std::size_t most_crossings = 8;    ///< places
  /// Of each body about a place, the nearest; also the limit of the steps of a curve over them.
  std::size_t most_local_triangles = 1024;
  double pieces_of_reach = 24;         ///< pieces of a curve per length of the reach
  double most_pieces = 128;            ///< of a curve
  double least_cosine_of_patch = 0.2;  ///< of the angle between the normals of a patch and its seed
  /// Curves are cut by planes through the place. These are the tangents of the planes' angles to
  /// the plane perpendicular to the line in which the two triangles intersect.
  double slopes_of_cuts[3] = {0, 0.7, -0.7};

  // Ascent to deeper points (CommonDepth::ascend)
  int more_without_any = 3;    ///< factor on the evaluations while there is no common point
  double level = 0.05;         ///< |gradient|: below it, the point counts as a maximum
  double stride_at_top = 0.5;  ///< factor on the stride at the top of a ridge
  double stride_growth = 1.5;  ///< factor after a step that led deeper
  double stride_decay = 0.35;  ///< factor after a step that did not
  std::size_t bundle = 4;      ///< gradients kept, the latest
  int bundle_steps = 12;       ///< Frank-Wolfe steps to the least vector of their hull
};
inline constexpr BoundTuning bound_tuning;

}  // namespace sonde
