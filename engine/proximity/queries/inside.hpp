// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/body/body.hpp"
#include "engine/geometry/transform.hpp"

namespace sonde {

/// Winding number of a solid's triangles, without the loose ones, about x, a point of its mesh
/// frame that is not on a triangle. It counts the signed crossings of a ray. If a ray passes too
/// near an edge or through a crack, it tries another; if all rays are undecided, it sums solid
/// angles instead, and rounds.
int winding_number(const Body& body, const Vec3& x);

/// Winding number ≠ 0: the point is inside the solid.
bool winds_around(const Body& solid, const Vec3& x);

/// Given that no triangles meet, returns whether a connected component of A (placed at X_BA) lies
/// inside solid B, or one of B inside solid A. One corner of each component decides.
bool component_inside(const Body& a, const Body& b, const Transform& X_BA);

}  // namespace sonde
