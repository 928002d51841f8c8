// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/base/error.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {

/// A soup with about `triangles` triangles and roughly the shape of the given one. Its vertices are
/// gathered in cells of a grid, and each cell is replaced by the vertex nearest to their mean.
/// Triangles that are left with fewer than three corners, or twice, are removed (vertex clustering:
/// Rossignac and Borrel, 1993; it needs no topology). The error has no bound, so it is for guesses
/// only. Empty where nothing remains. Throws Cancelled.
Soup outline(const Soup& soup, std::size_t triangles, const Progress& progress = {});

}  // namespace sonde
