// SPDX-License-Identifier: GPL-3.0-or-later
// References without trees, lists or charts: every pair of triangles, and mass by its definition.
#pragma once

#include <random>
#include <vector>

#include "engine/body/body.hpp"
#include "engine/geometry/transform.hpp"
#include "engine/proximity/triangles/triangle_pair.hpp"

namespace sonde::test {

/// All triangles of a body, placed; the corners are those that every kernel sees, to the bit.
std::vector<Corners> placed_triangles(const Body& body, const Transform& X);

/// Does any pair of triangles meet or touch, by exact predicates on every pair?
bool any_pair_meets(const Body& a, const Body& b, const Transform& X_BA);

/// Winding number of all triangles about x by the sum of solid angles, not rounded.
double solid_angle_winding(const Body& body, const Vec3& x);

/// Free by the contract's words: no pair of triangles meets, and no vertex of either body lies
/// inside the other where that is a solid (every vertex is asked, not one of a component).
bool is_free(const Body& a, const Body& b, const Transform& X_BA);

/// Least distance over all pairs of triangles, by closest_points.
double least_distance_of_pairs(const Body& a, const Body& b, const Transform& X_BA);

/// Lower and upper bound of the distance of two triangles, in long double, by trying all 7 × 7
/// pairs of corners, edges and faces: the nearest points of the two flats count where they lie in
/// both features. The upper bound is the distance of two points of the triangles, the lower one is
/// the gap along their direction, so what is between them is certain.
struct DistanceBounds {
  double lower, upper;
};
DistanceBounds triangle_distance_bounds(const Corners& a, const Corners& b);

/// Measure, centre of mass and second moments about it in the mesh frame, by integrating over the
/// triangles (surface) or over the signed tetrahedra under them (solid).
struct Moments {
  double measure = 0;
  Vec3 com = Vec3::Zero();
  Mat3 covariance = Mat3::Zero();
};
Moments moments(const Body& body);

/// Mean squared displacement of a body's points between two poses, m²: the definition of σ.
double mean_squared_displacement(const Moments& m, const Pose& O, const Pose& Q);

/// A random pose at which the two bounding balls overlap more or less.
Pose random_pose(std::mt19937_64& random, const Body& a, const Body& b, double spread);

}  // namespace sonde::test
