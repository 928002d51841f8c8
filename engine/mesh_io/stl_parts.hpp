// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {

/// The corners of triangles as points, one for each place, in the order of their first use.
PolygonSoup join_corners(const std::vector<Vec3>& corners, const Progress& progress);

/// A text file of STL: several solids may stand in it, one after the other.
PolygonSoup read_text_stl(const std::string& file, std::string_view text, const Progress& progress);

}  // namespace sonde
