// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/geometry/soup.hpp"

namespace sonde {

/// The kind of a repair, in display order: first those that add contact surface which was not in
/// the file.
enum class RepairKind : std::uint8_t {
  cap,         ///< an opening, closed
  turned,      ///< triangles that were turned to agree with their neighbours
  inside_out,  ///< a whole part that was inverted
  hidden,      ///< triangles inside, left out
  repeated,    ///< triangles that occur several times, counted once
  seam         ///< corners joined, or found on edges of others
};

/// One place of repair: adjacent triangles with the same kind of repair.
struct RepairPlace {
  RepairKind kind = RepairKind::cap;
  Vec3 at = Vec3::Zero();       ///< its centre, m, mesh frame
  double size = 0;              ///< radius of a ball about `at` that contains it, m
  Vec3 outward = Vec3::Zero();  ///< unit, away from the triangles; zero if they face all ways
};

/// The places of repair of a mesh.
struct RepairPlaces {
  static constexpr std::size_t most = 1000;
  /// After sort_and_cap(): by kind, large ones first, at most `most`.
  std::vector<RepairPlace> places;
  std::size_t all = 0;  ///< total number, including those left out
};

/// Adds one place for all these triangles; none if there are no triangles.
void add_place(RepairPlaces& to, RepairKind kind, const std::vector<Vec3>& vertices,
               const std::vector<Triangle>& triangles);

/// Adds a place for each set of triangles that are connected by their corners.
void add_places(RepairPlaces& to, RepairKind kind, const std::vector<Vec3>& vertices,
                const std::vector<Triangle>& triangles);

/// The same with only the `marked` corners (by vertex): a place contains these, and triangles
/// connected by them form one place. Triangles without a marked corner are ignored.
void add_corner_places(RepairPlaces& to, RepairKind kind, const std::vector<Vec3>& vertices,
                       const std::vector<Triangle>& triangles, const std::vector<bool>& marked);

/// Sorts and counts the places, and drops those beyond the maximum.
void sort_and_cap(RepairPlaces& places);

}  // namespace sonde
