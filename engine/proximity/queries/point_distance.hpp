// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/body/body.hpp"
#include "engine/proximity/boxes/box_lanes.hpp"

namespace sonde {

/// A point in the frame and the unit in which the boxes of a body's tree are compared with it.
struct PointFrame {
  PointFrame(const Body& body, const Vec3& x);
  PlacedPoint point;
  double per_unit;  ///< units per metre
  float scale;      ///< the same
  float guard;      ///< rounding error of a distance, in units
};

/// Distance of the point x from the triangles of a body, m; both in its mesh frame. Stops early,
/// with any value below `enough`, once it is certainly below. Never allocates.
double point_distance(const Body& body, const Vec3& x, double enough = 0);

/// The same, with the nearest point of the triangles.
struct NearestPoint {
  double distance;             ///< m
  Vec3 point;                  ///< mesh frame
  std::uint32_t triangle = 0;  ///< of surface(body)
};
NearestPoint nearest_point(const Body& body, const Vec3& x, double enough);

/// Writes the triangles of surface(body) that come within `radius` (m) of x to `out`, and returns
/// how many there are, but no more than find room: where that is all the room, there may be others.
/// Never allocates.
std::size_t triangles_within(const Body& body, const Vec3& x, double radius,
                             std::span<std::uint32_t> out);

}  // namespace sonde
