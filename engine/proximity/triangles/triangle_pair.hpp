// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "engine/geometry/pose.hpp"

namespace sonde {

/// The corners of one triangle, in the caller's frame; metres.
using Corners = std::array<Vec3, 3>;

/// From corner i to the next.
inline Vec3 edge_of(const Corners& t, std::size_t i) { return t[(i + 1) % 3] - t[i]; }
/// Across the triangle, outwards for a solid's; twice its area long.
inline Vec3 area_normal(const Corners& t) { return (t[1] - t[0]).cross(t[2] - t[0]); }

/// Closest points of two triangles, and the direction that separates them.
struct ClosestPoints {
  Vec3 a;
  Vec3 b;           ///< equal to a if they meet
  double distance;  ///< 0 if they meet
  /// Unit, from B to A: the direction of the closest points, which separates best. If these are so
  /// close that rounding turns it, the direction of the separating-axis theorem with the largest
  /// gap. Zero if they meet.
  Vec3 normal;
  double gap;  ///< gap_along the normal; 0 if they meet
};

/// Closest points of two triangles, including degenerate ones (needles, points). Plain floating
/// point: distance and gap are accurate to about 1e-15 of the size of the coordinates. Triangles
/// that are further apart than `limit` get the distance infinity and nothing else. Gives the same
/// bits as the version for eight pairs (triangle_lanes.hpp). Never allocates.
ClosestPoints closest_points(const Corners& a, const Corners& b,
                             double limit = std::numeric_limits<double>::infinity());

/// min over A of n·a − max over B of n·b. If it is positive, A and B are separated along n by that
/// much, for any n. Sonde certifies free poses with this gap, not with the distance.
double gap_along(const Vec3& n, const Corners& a, const Corners& b);

enum class Meeting { apart, meeting, doubtful };

/// Classifies two triangles, with certain answers only: `apart` if a separating axis leaves more
/// than the rounding error, `meeting` if an edge pierces the other face by more than the rounding
/// error, otherwise `doubtful` (touching, coplanar, or nearly so). Never allocates.
Meeting classify(const Corners& a, const Corners& b);

/// Whether they meet, by CGAL's exact predicates on the given coordinates. May allocate.
bool meet_exactly(const Corners& a, const Corners& b);

}  // namespace sonde
