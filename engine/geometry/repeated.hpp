// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "engine/base/error.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {

/// The triangles of a soup that may be left out, because others have the same corners. One of each
/// orientation stays, as the two sides of a sheet. With `solid`, as many stay in one orientation as
/// keeps the ratios of all winding numbers; triangles that occur equally often in both orientations
/// stay once in each. Throws Cancelled.
std::vector<bool> repeated_triangles(const Soup& soup, bool solid, const Progress& progress = {});

}  // namespace sonde
