// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "engine/base/progress.hpp"
#include "engine/mending/same_triangles.hpp"

namespace sonde {

/// Decides on triangles that occur more often than the rest of their component. They are either
/// walls and shells of their own (between two bodies, or of a part within another), and the rest
/// closes along their rim without them; or they are repeated by accident, and the rest is open
/// along their rim, and closes with one of each. Each patch of such triangles is one or the other.
/// Their rims and the open edges of the rest are compared as find_seams() joins and cuts them:
/// where a corner lies on a side, the two have no edge in common. `all`: the triangles of a soup,
/// by their corners among `x` (m). Throws Cancelled.
void decide_doubtful_patches(const std::vector<Vec3>& x, std::vector<SameTriangles>& all,
                             const Progress& progress = {});

}  // namespace sonde
