// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/body/body.hpp"
#include "engine/proximity/boxes/box_lanes.hpp"

namespace sonde {

/// A point in the frame and unit in which it is compared with the boxes of a body's tree.
struct PointFrame {
  PointFrame(const Body& body, const Vec3& x);
  PlacedPoint point;
  double per_unit;  ///< units per metre
  float scale;      ///< the same in single precision
  float guard;      ///< rounding error of a distance, in units
};

/// Distance of the point x from the triangles of a body, m; both in its mesh frame. Returns early,
/// with any value below `enough`, as soon as the distance is certainly below it. Never allocates.
double point_distance(const Body& body, const Vec3& x, double enough = 0);

/// The same, with the nearest point of the triangles.
struct NearestPoint {
  double distance;             ///< m
  Vec3 point;                  ///< mesh frame
  std::uint32_t triangle = 0;  ///< index in surface(body)
};
NearestPoint nearest_point(const Body& body, const Vec3& x, double enough);

/// Writes the triangles of surface(body) within `radius` (m) of x to `out`, and returns their
/// number. If `out` is full, there may be more. Never allocates.
std::size_t triangles_within(const Body& body, const Vec3& x, double radius,
                             std::span<std::uint32_t> out);

}  // namespace sonde
