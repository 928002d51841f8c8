// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "engine/penetration/contact/separation.hpp"
#include "engine/proximity/triangles/triangle_pair.hpp"

namespace sonde {

/// The corners of the overlap of two triangles, seen along a direction.
struct FaceOverlap {
  std::array<Contact, 9> corners;
  int size = 0;
  const Contact* begin() const { return corners.data(); }
  const Contact* end() const { return corners.data() + size; }
};

/// If two triangles lie nearly flat on each other, many pairs of points are about equally close,
/// and after a small turn another pair is the closest. The gap along `normal` (from B to A) is
/// linear over the overlap, so the corners of the overlap describe all of it. Empty where B is seen
/// edge on, or where nothing overlaps.
FaceOverlap face_overlap(const Corners& a, const Corners& b, const Vec3& normal);

}  // namespace sonde
