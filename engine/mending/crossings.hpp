// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {

/// Boxes along the axes that hold all that closed parts have in common with parts whose surface
/// they cross, however little of the whole that is: of beams, their joints. No two of the boxes
/// overlap. Of parts that lie inside others without crossing them there is no box. `part`: of each
/// triangle. Empty where looking would take more than `most_pairs` pairs of triangles. Throws
/// Cancelled.
std::vector<Eigen::AlignedBox3d> crossings_of_parts(const Soup& soup,
                                                    const std::vector<std::uint32_t>& part,
                                                    const Progress& progress = {},
                                                    std::size_t most_pairs = 100'000'000);

}  // namespace sonde
