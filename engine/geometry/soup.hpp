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

/// A triangle soup in its mesh frame, metres, with any topology: triangles may cross, repeat, or
/// hang loose. Indices are in range and coordinates finite (the readers ensure it).
struct Soup {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
};

/// A polygon soup as a file holds it, before triangulation.
using Polygon = std::vector<std::size_t>;  ///< its corners, as indices of points
struct PolygonSoup {
  std::vector<Vec3> points;
  std::vector<Polygon> polygons;
  /// What is odd about the file and was read all the same, or left out: for the user, one remark
  /// for each kind ("line 12: 3 faces of two corners set aside").
  std::vector<std::string> remarks{};
};

/// The triangles of a polygon soup (by ear clipping in the polygon's best-fit plane, so that
/// concave polygons keep their shape), with degenerate ones set aside. A polygon that crosses
/// itself has no correct triangulation: the only promise is that each of its corners is in a
/// triangle.
struct Triangulated {
  Soup soup;
  /// Triangles with no area (an index twice, or corners that cannot be told from collinear).
  std::size_t degenerate = 0;
};
Triangulated triangulate(const PolygonSoup& polygons);

/// The same with the degenerate triangles left in, none of the corners lost: topology is analysed
/// on this, because a closed mesh without its slivers would look open. Polygons of fewer than three
/// different corners give one triangle with a repeated index.
Soup triangulate_all(const PolygonSoup& polygons, const Progress& progress = {});

/// True where the three corners cannot be told from collinear in double precision:
/// twice the area is at most 1e-15 of the square of the longest edge.
bool is_degenerate(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace sonde
