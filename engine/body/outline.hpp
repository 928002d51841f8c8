// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/base/error.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {

/// A soup with about as many triangles as asked for and the shape of the one given, roughly: its
/// vertices are gathered in cells of a grid, each cell stands where the vertex nearest to their
/// mean is, and triangles that are left with fewer than three corners, or twice, go (vertex
/// clustering: Rossignac and Borrel, 1993; it asks nothing of topology). No bound of the error: for
/// guesses alone. Empty where nothing was left. Throws Cancelled.
Soup outline(const Soup& soup, std::size_t triangles, const Progress& progress = {});

}  // namespace sonde
