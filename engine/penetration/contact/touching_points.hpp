// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "engine/penetration/contact/separation.hpp"
#include "engine/proximity/triangles/triangle_pair.hpp"

namespace sonde {

/// Where two triangles touch, given by the corners of the common part: a point, the two ends of a
/// line, or the corners of an area.
struct TouchingPoints {
  std::array<Contact, 15> items;
  int size = 0;
  const Contact* begin() const { return items.data(); }
  const Contact* end() const { return items.data() + size; }
  void push(const Vec3& on_a, const Vec3& on_b, const Vec3& normal) {
    items[static_cast<std::size_t>(size++)] = {on_a, on_b, normal, normal.dot(on_a - on_b), 0};
  }
};

/// Triangles A and B have a gap of about 0 along `normal` (unit, from B to A). Seen along it, the
/// lowest feature of A (a corner, an edge or the face: all within `slack`, m, of its lowest point)
/// and the highest feature of B overlap in a convex part. Returns its corners: corners of either
/// feature on the other one, to `slack`, and crossings of edges. Points and gaps are exact to
/// rounding, whereas the closest points of triangles this near to each other define no direction.
/// If the features do not overlap, returns the lowest corner of A and the highest of B: keeping
/// their gap along the normal also keeps the triangles apart.
TouchingPoints touching_points(const Corners& a, const Corners& b, const Vec3& normal,
                               double slack);

}  // namespace sonde
