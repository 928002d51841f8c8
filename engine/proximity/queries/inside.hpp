// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/body/body.hpp"

namespace sonde {

/// Winding number of a closed body's triangles about x, a point of its mesh frame that is not on a
/// triangle: crossings of a ray counted with their sign. A ray that comes too near an edge to be
/// sure is given up for another; where every one is in doubt the solid angles are summed instead.
int winding_number(const Body& body, const Vec3& x);

/// Winding number ≠ 0.
bool inside(const Body& solid, const Vec3& x);

/// Given that no triangles meet: does a connected component of A (placed at X_BA) lie inside solid
/// B, or one of B inside solid A? One corner of each component decides.
bool component_inside(const Body& a, const Body& b, const Transform& X_BA);

}  // namespace sonde
