// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "engine/base/progress.hpp"
#include "engine/mending/same_triangles.hpp"

namespace sonde {

/// Closed shells each of whose triangles stands against another one. One that lies inside of a
/// closed part, as a body that fills a cavity to its walls or is walled in by others all around,
/// bounds nothing: the inside is on both its sides, and none of it stays. Any other is a body that
/// is there in both orientations, and stays once, also where it shares a face with another body.
/// `all`: the triangles of a soup, by their corners among `x` (m). Throws Cancelled.
void settle_opposed_shells(const std::vector<Vec3>& x, std::vector<SameTriangles>& all,
                           const Progress& progress = {});

}  // namespace sonde
