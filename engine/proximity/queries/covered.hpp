// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "engine/body/body.hpp"
#include "engine/proximity/queries/point_distance.hpp"

namespace sonde {

/// Share of a body's extent: how near to a point of a triangle the inside is looked for on either
/// side of it. Well above the rounding of winding numbers, and below what a user can tell from
/// contact: gaps that are narrower count as closed.
inline constexpr double beside_a_wall = 1e-12;
/// Share of the extent: how far from its end a part of a wall is told to be covered or not.
inline constexpr double within_a_wall = 1e-10;

/// Whether a triangle of surface(body) is a wall within the material at x, a point of it: the
/// inside lies on both sides, as where parts overlap. Never of a surface, or of a sheet beside a
/// solid. Never allocates.
bool is_covered(const Body& body, std::uint32_t triangle, const Vec3& x);

/// The nearest point that is not covered: of the outside of parts that overlap, as if they were
/// one. Exact to `within_a_wall`, and to rounding where the nearest point of all triangles is not
/// covered. Otherwise, walls are taken by their distance, and cut where other triangles meet them,
/// until the nearest piece is not covered. That allocates, and takes some µs for each wall that is
/// nearer.
NearestPoint nearest_outside(const Body& body, const Vec3& x);

}  // namespace sonde
