// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/base/error.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {

/// A soup with about `triangles` triangles and roughly the shape of the given one. Its vertices are
/// grouped by the cells of a grid, and each group is replaced by the vertex nearest to its mean.
/// Triangles left with fewer than three corners, or repeated, are removed (vertex clustering:
/// Rossignac and Borrel, 1993; it needs no topology). The error has no bound, so use it for
/// estimates only. Empty if nothing remains. Throws Cancelled.
Soup outline(const Soup& soup, std::size_t triangles, const Progress& progress = {});

}  // namespace sonde
