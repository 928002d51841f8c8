// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/geometry/pose.hpp"

namespace sonde {

using Triangle = std::array<std::uint32_t, 3>;

/// A triangle soup in its mesh frame, metres, with any topology: triangles may cross, repeat, or be
/// disconnected. Indices are in range and coordinates finite (the readers ensure it).
struct Soup {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
};

/// A polygon soup as read from a file, before triangulation.
using Polygon = std::vector<std::size_t>;  ///< its corners, as indices of points
struct PolygonSoup {
  std::vector<Vec3> points;
  std::vector<Polygon> polygons;
  /// Oddities of the file that did not prevent reading, or that were left out: for the user, one
  /// remark for each kind ("line 12: 3 faces of two corners set aside").
  std::vector<std::string> remarks{};
};

/// The triangles of a polygon soup (by ear clipping in the polygon's best-fit plane, so that
/// concave polygons keep their shape), without degenerate ones. A polygon that crosses itself has
/// no correct triangulation: it is only guaranteed that each of its corners is in a triangle.
struct Triangulated {
  Soup soup;
  /// Triangles without an area (a repeated index, or corners that are collinear up to rounding).
  std::size_t degenerate = 0;
};
Triangulated triangulate(const PolygonSoup& polygons);

/// The same including the degenerate triangles, so that no corner is lost: topology is analysed on
/// this, because a closed mesh without its slivers would look open. A polygon of fewer than three
/// different corners gives one triangle with a repeated index.
Soup triangulate_all(const PolygonSoup& polygons, const Progress& progress = {});

/// True if the three corners are collinear up to double precision: twice the area is at most 1e-15
/// of the square of the longest edge.
bool is_degenerate(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace sonde
