// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "engine/base/error.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {

/// The pieces of a soup that a person would regard as separate objects, in the order of their first
/// polygons: polygons connected by corners at the same places, together with their cavities. A
/// cavity is a closed piece that lies directly inside another closed piece and has the opposite
/// orientation. Pieces with a common hole, one shell through all of them, are one, and say so. A
/// piece all of whose polygons are there several times, the same way round, is as many pieces in
/// one place. The soup's remarks go with the first piece; each has those on its cavities. Throws
/// Cancelled.
std::vector<PolygonSoup> components_of(const PolygonSoup& soup, const Progress& progress = {});

}  // namespace sonde
