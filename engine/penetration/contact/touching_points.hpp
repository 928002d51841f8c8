// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "engine/penetration/contact/separation.hpp"
#include "engine/proximity/triangles/triangle_pair.hpp"

namespace sonde {

/// Where two triangles touch, as the corners of that part: a point, the two ends of a line, or the
/// corners of an area.
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
/// lowest feature of A (a corner, an edge or the face: what is within `slack`, m, of its lowest
/// point) and the highest of B overlap in a convex part. Gives its corners: corners of either
/// feature on the other one, to `slack`, and where edges cross. Points and gaps are exact to
/// rounding, where contacts of triangles that are apart by no more than that have no direction of
/// their own. Where the features do not overlap, the lowest corner of A above the highest of B: to
/// keep their gap along the normal keeps the triangles apart, too.
TouchingPoints touching_points(const Corners& a, const Corners& b, const Vec3& normal,
                               double slack);

}  // namespace sonde
