// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace sonde {

/// A part of the plane by its outline: segments between points (indices), in any order, that may
/// meet only at their ends. A place that an odd number of them surrounds is inside.
struct PlanarRegion {
  std::vector<std::array<double, 2>> points;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> outline;
};

/// Triangles, anticlockwise, that fill a region and have no corner but its points: a constrained
/// Delaunay triangulation (CGAL, exact predicates). None where segments cross or overlap.
std::optional<std::vector<std::array<std::uint32_t, 3>>> triangulate(const PlanarRegion& region);

}  // namespace sonde
