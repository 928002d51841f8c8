// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/body/body.hpp"
#include "engine/geometry/transform.hpp"

namespace sonde {

/// Winding number of a solid's triangles, but for those that are loose, about x, a point of its
/// mesh frame that is not on a triangle. It counts the crossings of a ray with their sign. If a ray
/// passes too near an edge to be sure, or through a crack, it tries another; if every ray is in
/// doubt, it sums solid angles instead, and rounds.
int winding_number(const Body& body, const Vec3& x);

/// Winding number ≠ 0: the point is in the inside of a solid.
bool winds_around(const Body& solid, const Vec3& x);

/// Given that no triangles meet, returns whether a connected component of A (placed at X_BA) lies
/// inside solid B, or one of B inside solid A. One corner of each component decides.
bool component_inside(const Body& a, const Body& b, const Transform& X_BA);

}  // namespace sonde
