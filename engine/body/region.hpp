// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace sonde {

/// A part of the plane given by its outline: segments between points (indices), in any order, that
/// may meet only at their ends. A place is inside by the even-odd rule.
struct PlanarRegion {
  std::vector<std::array<double, 2>> points;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> outline;
};

/// Anticlockwise triangles that fill a region, with only its points as corners: a constrained
/// Delaunay triangulation (CGAL, exact predicates). No value if segments cross or overlap, or if
/// all points lie on a line.
std::optional<std::vector<std::array<std::uint32_t, 3>>> triangulate(const PlanarRegion& region);

}  // namespace sonde
