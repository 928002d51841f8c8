// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {

/// Where closed parts cross each other or themselves.
struct Crossings {
  /// Boxes along the axes that hold all that two parts have in common whose surfaces cross, however
  /// little of the whole that is: of beams, their joints. Of a part that crosses itself, boxes of
  /// the curves along which it does: what is there twice may reach further. Boxes may overlap. Of
  /// parts that lie inside others without crossing them there is none.
  std::vector<Eigen::AlignedBox3d> boxes;
  bool complete = true;  ///< false: looking would take too long, and there are no boxes
};

/// `part`: of each triangle. Looks at up to `most_pairs` pairs of triangles. Throws Cancelled.
Crossings find_crossings(const Soup& soup, const std::vector<std::uint32_t>& part,
                         const Progress& progress = {}, std::size_t most_pairs = 100'000'000);

}  // namespace sonde
