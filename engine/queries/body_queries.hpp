// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "engine/base/error.hpp"
#include "engine/geometry/pose.hpp"

namespace sonde {

struct Body;

/// A point on a body's surface, in its mesh frame.
struct SurfacePoint {
  Vec3 point = Vec3::Zero();    ///< m
  Vec3 normal = Vec3::UnitZ();  ///< unit, of the triangle; outwards if that bounds an inside
  double distance = 0;          ///< from the query point, m
};

/// Whether the point x (mesh frame, m) is inside the body, by the winding number of the surface
/// that bounds its inside (repaired as facts() says); never in a body that is a surface. Within
/// rounding of the surface the result may be either. 0.05 µs in the median, some µs within the
/// bounds. Does not allocate; any number of threads may call it.
/// @throws InputError if x is not finite.
bool inside(const Body& body, const Vec3& x);

/// The nearest point of the body's surface to x (mesh frame, m), at a distance that is exact to
/// about 1e-15 of the largest coordinate. Of parts that overlap it is that of what they fill
/// together: walls within the material do not count. 3 to 5 µs in the median, without allocation;
/// if the nearest triangle lies within the material, it allocates, the distance is exact to 1e-10
/// of the largest coordinate, and it takes some µs for each triangle there that is nearer. Any
/// number of threads may call it.
/// @throws InputError if x is not finite, or beyond 1e30 m.
SurfacePoint nearest_point(const Body& body, const Vec3& x);

/// The first point at which a ray from a point along a direction (mesh frame; of any length but 0)
/// meets the body's surface, from either side; no value if it meets none. It passes through walls
/// within the material, as of parts that overlap: from inside it meets where it leaves. A ray does
/// not slip through between triangles that share an edge; one that runs in a triangle's plane
/// misses that triangle. Some µs. Does not allocate; any number of threads may call it.
/// @throws InputError if a number is not finite or beyond 1e30, or the direction has no length.
std::optional<SurfacePoint> ray(const Body& body, const Vec3& from, const Vec3& direction);

/// The name of the part of a body that is nearest to the point x (mesh frame, m), if the body is
/// joined of several parts (in a scene); otherwise the body's own name. The body owns the text.
/// Some µs a part. Does not allocate; any number of threads may call it.
/// @throws InputError if x is not finite, or beyond 1e30 m.
std::string_view part_at(const Body& body, const Vec3& x);

}  // namespace sonde
