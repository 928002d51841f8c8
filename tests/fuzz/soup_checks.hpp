// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/soup.hpp"
#include "tests/fuzz/fuzz.hpp"

namespace sonde::fuzz {

/// What every reader of meshes promises of what it has read. Returns its corners.
inline std::size_t require_sound(const PolygonSoup& soup) {
  std::size_t corners = 0;
  for (const Polygon& polygon : soup.polygons) {
    for (const std::size_t i : polygon) require(i < soup.points.size(), "an index is in range");
    corners += polygon.size();
  }
  for (const Vec3& x : soup.points) require(x.allFinite(), "a coordinate is finite");
  require(!soup.polygons.empty(), "a mesh that is read has polygons");
  return corners;
}

}  // namespace sonde::fuzz
