// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/geometry/soup.hpp"
#include "engine/mending/line_sums.hpp"

namespace sonde {

/// What is inside several times where closed parts cross each other or themselves, by lines of its
/// own through each such place.
struct Joints {
  LineSums sums[2];  ///< (winding number ≠ 0) − (winding number), by coarser and finer lines
  bool any = false;  ///< there was something to look at
  bool complete = true;  ///< false: more than can be looked at, so the sums lack some
};

/// `volume`: of the whole, m³; what is too little of it is left out. `rounding`: overlap over less
/// of a line is none. Throws Cancelled.
Joints find_joints(const Soup& soup, const std::vector<std::uint32_t>& part, double volume,
                   double rounding, const Progress& progress = {});

}  // namespace sonde
