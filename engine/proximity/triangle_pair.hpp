// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>

#include "engine/geometry/pose.hpp"

namespace sonde {

/// The corners of one triangle, in whatever frame the caller works in; metres.
using Corners = std::array<Vec3, 3>;

/// Closest points of two triangles. `distance` is 0 where they meet (then a = b, a point of both).
struct ClosestPoints {
  Vec3 a;
  Vec3 b;
  double distance;
};

/// Closest points of two triangles, degenerate ones included (needles, points). Plain floating
/// point: the distance is right to about 1e-15 of the size of the coordinates. Twelve vertex-face
/// and nine edge-edge candidates, after C. Ericson, Real-Time Collision Detection, 2005,
/// chapter 5.1. Triangles seen to be further apart than `limit` get the distance infinity and no
/// points.
ClosestPoints closest_points(const Corners& a, const Corners& b,
                             double limit = std::numeric_limits<double>::infinity());

/// min over A of n·a − max over B of n·b: where positive, A and B are separated along n by that
/// much, whatever n is. This, not the distance, is what freedom is certified with.
double gap_along(const Vec3& n, const Corners& a, const Corners& b);

/// A direction that separates two triangles, and by how much. Gap ≤ 0: none was found.
struct Separator {
  Vec3 normal;  ///< unit, from B to A
  double gap;   ///< gap_along the normal
};
/// The direction of the closest points, which is the best there is; but where they are so close, or
/// so nearly of parallel edges, that rounding turns it, whichever of the separating-axis theorem's
/// directions leaves the largest gap.
Separator separator(const ClosestPoints& closest, const Corners& a, const Corners& b);

enum class Meeting { apart, meeting, doubtful };

/// Do two triangles meet or touch? Certain answers only: `apart` where a separating axis leaves
/// more than the rounding error, `meeting` where an edge pierces the other face by more than the
/// rounding error, else `doubtful` (touching, coplanar, nearly so). Never allocates.
Meeting classify(const Corners& a, const Corners& b);

/// Exact answer, by CGAL's exact predicates on the coordinates as given. May allocate.
bool meet_exactly(const Corners& a, const Corners& b);

}  // namespace sonde
