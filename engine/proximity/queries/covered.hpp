// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "engine/body/body.hpp"
#include "engine/proximity/queries/point_distance.hpp"

namespace sonde {

/// Share of a body's extent: distance from a triangle at which is_covered() tests for the inside,
/// on both sides. Well above the rounding error of winding numbers, and well below the widths that
/// matter to a user: narrower gaps count as closed.
inline constexpr double beside_a_wall = 1e-12;
/// Share of the extent: the distance from its nearest point, into a piece of a wall, at which the
/// piece is tested for being covered.
inline constexpr double within_a_wall = 1e-10;

/// Whether a triangle of surface(body) lies within the material at its point x: the inside is on
/// both sides of it, as where parts of a solid overlap. Such triangles are called walls. False for
/// a surface, and for loose triangles of a solid. Never allocates.
bool is_covered(const Body& body, std::uint32_t triangle, const Vec3& x);

/// The nearest point of the body that is not covered: that of the union of overlapping parts. Exact
/// to rounding if the nearest point of all triangles is not covered, otherwise to `within_a_wall`.
/// In that case it examines walls in the order of their distances, and cuts them where other
/// triangles meet them, until the nearest piece is not covered. That allocates, and takes some µs
/// for each nearer wall.
NearestPoint nearest_outside(const Body& body, const Vec3& x);

}  // namespace sonde
