// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "engine/base/error.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {

/// The pieces of a soup that a person would take for things of their own, in the order of their
/// first polygons: what hangs together by corners at the same places, and with it its cavities. A
/// cavity is closed, lies in a closed piece with none between the two, and is turned the other way.
/// The soup's remarks go with the first piece. Throws Cancelled.
std::vector<PolygonSoup> components_of(const PolygonSoup& soup, const Progress& progress = {});

}  // namespace sonde
