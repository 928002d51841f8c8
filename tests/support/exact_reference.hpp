// SPDX-License-Identifier: GPL-3.0-or-later
// References in exact arithmetic, over every pair of triangles. The coordinates are doubles as the
// engine places them (`Transform * x`, the definition that all queries share); from there on
// nothing rounds but the last conversion of an exact number to double.
#pragma once

#include <vector>

#include "engine/body/body.hpp"
#include "engine/geometry/transform.hpp"
#include "engine/proximity/triangles/triangle_pair.hpp"
#include "tests/support/brute_force.hpp"

namespace sonde::test {

/// Do two triangles meet or touch? An edge of one that meets the other, or the other way round, by
/// CGAL's exact predicates for a segment and a triangle. To be trusted everywhere, triangles that
/// are a segment or a point included. (The engine asks CGAL for two triangles; this is another
/// routine.)
bool meet_by_edges(const Corners& a, const Corners& b);

/// Distance of two triangles: 0 where meet_by_edges, else the least of nine pairs of edges and six
/// of corner and face, each squared distance an exact rational number (CGAL's
/// Exact_predicates_exact_constructions_kernel) known to one part in 1e12 or better when converted.
/// To be trusted everywhere to that relative error: there is no absolute one.
double exact_distance(const Corners& a, const Corners& b);

/// min over A of n·a − max over B of n·b, over |n|: exact up to the division.
double exact_gap_along(const Vec3& n, const Corners& a, const Corners& b);

/// All triangles of a body at one pose, each with its box (comparisons of doubles: exact).
struct Placed {
  std::vector<Corners> triangles;
  std::vector<Vec3> low, high;
  Placed(const Body& body, const Transform& X);
};

/// Does any pair meet? By meet_by_edges on all pairs whose boxes do.
bool any_meet(const Placed& a, const Placed& b);

/// Distance of the boxes of two triangles, less 1e-9 of it for its own rounding.
double below_distance_of_boxes(const Placed& a, std::size_t i, const Placed& b, std::size_t j);

/// Least exact_distance of all pairs; those whose boxes, or heights along some direction, are
/// further apart than another pair's distance are not looked at.
double least_exact_distance(const Placed& a, const Placed& b);

/// Is every pair at least `distance` apart? Where boxes and directions do not say so, exactly.
bool apart_by(const Placed& a, const Placed& b, double distance);

}  // namespace sonde::test
