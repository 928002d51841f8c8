// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/geometry/soup.hpp"

namespace sonde {

/// What was done at a place, in the order in which places are shown: what collides and was not in
/// the file first.
enum class RepairKind : std::uint8_t {
  cap,         ///< an opening, closed
  turned,      ///< triangles that were turned to agree with their neighbours
  inside_out,  ///< a whole part that was turned
  hidden,      ///< triangles inside, left out
  repeated,    ///< triangles there several times, counted once
  seam         ///< corners joined, or found on edges of others
};

/// One place where a mesh was mended: what is adjacent and of one kind.
struct RepairPlace {
  RepairKind kind = RepairKind::cap;
  Vec3 at = Vec3::Zero();       ///< its middle, m, mesh frame
  double size = 0;              ///< of a ball about `at` that holds it, the radius, m
  Vec3 outward = Vec3::Zero();  ///< unit, off the triangles there; zero where they face all ways
};

/// The places where a mesh was mended.
struct RepairPlaces {
  static constexpr std::size_t most = 1000;
  std::vector<RepairPlace> places;  ///< once settled: by kind, large ones first, `most` at most
  std::size_t all = 0;              ///< how many there are, also of those left out
};

/// Adds a place for all that these triangles cover; none where there are none.
void add_place(RepairPlaces& to, RepairKind kind, const std::vector<Vec3>& vertices,
               const std::vector<Triangle>& triangles);

/// Adds a place for each set of triangles that hang together by their corners.
void add_places(RepairPlaces& to, RepairKind kind, const std::vector<Vec3>& vertices,
                const std::vector<Triangle>& triangles);

/// The same by some corners alone (`marked`, by vertex): a place holds these, and what hangs
/// together by them is one. Triangles without one do not count.
void add_corner_places(RepairPlaces& to, RepairKind kind, const std::vector<Vec3>& vertices,
                       const std::vector<Triangle>& triangles, const std::vector<bool>& marked);

/// Puts the places in order, counts them, and leaves out the last.
void settle(RepairPlaces& places);

}  // namespace sonde
