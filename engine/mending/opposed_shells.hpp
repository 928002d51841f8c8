// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "engine/base/progress.hpp"
#include "engine/mending/same_triangles.hpp"

namespace sonde {

/// Decides on closed shells in which each triangle has an opposite one. A shell that lies inside a
/// closed part, as a body that fills a cavity completely or is enclosed by others, bounds nothing:
/// the inside is on both its sides, and none of it stays. Any other shell is a body that occurs in
/// both orientations, and stays once, also if it shares a face with another body. `all`: the
/// triangles of a soup, by their corners among `x` (m). Throws Cancelled.
void decide_opposed_shells(const std::vector<Vec3>& x, std::vector<SameTriangles>& all,
                           const Progress& progress = {});

}  // namespace sonde
