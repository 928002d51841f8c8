// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>

#include "engine/geometry/pose.hpp"

namespace sonde {

/// The corners of one triangle, in whatever frame the caller works in; metres.
using Corners = std::array<Vec3, 3>;

/// Closest points of two triangles, and the direction that separates them.
struct ClosestPoints {
  Vec3 a;
  Vec3 b;           ///< the same where they meet
  double distance;  ///< 0 where they meet
  /// Unit, from B to A: that of the closest points, which is the best there is; but where these are
  /// so close that rounding turns it, whichever of the separating-axis theorem's directions leaves
  /// the largest gap. Zero where they meet.
  Vec3 normal;
  double gap;  ///< gap_along the normal; 0 where they meet
};

/// Closest points of two triangles, degenerate ones included (needles, points). Plain floating
/// point: distance and gap are right to about 1e-15 of the size of the coordinates. Triangles seen
/// to be further apart than `limit` get the distance infinity and nothing else. The same bits as by
/// eights (triangle_lanes.hpp). Never allocates.
ClosestPoints closest_points(const Corners& a, const Corners& b,
                             double limit = std::numeric_limits<double>::infinity());

/// min over A of n·a − max over B of n·b: where positive, A and B are separated along n by that
/// much, whatever n is. This, not the distance, is what freedom is certified with.
double gap_along(const Vec3& n, const Corners& a, const Corners& b);

enum class Meeting { apart, meeting, doubtful };

/// Do two triangles meet or touch? Certain answers only: `apart` where a separating axis leaves
/// more than the rounding error, `meeting` where an edge pierces the other face by more than the
/// rounding error, else `doubtful` (touching, coplanar, nearly so). Never allocates.
Meeting classify(const Corners& a, const Corners& b);

/// Exact answer, by CGAL's exact predicates on the coordinates as given. May allocate.
bool meet_exactly(const Corners& a, const Corners& b);

}  // namespace sonde
