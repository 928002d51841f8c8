// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/soup.hpp"

namespace sonde {

/// m: a mesh that is as long is taken to be in millimetres where nobody says its unit.
constexpr double hardly_metres = 20;

/// Adds a remark where the largest side of the bounding box is 20 m or more, or under 100 µm, which
/// is hardly meant: with the unit that would make it sensible, where there is one. `scale`: what
/// the numbers of the file were multiplied by; 0 where the file says its unit itself.
void remark_on_size(PolygonSoup& soup, double scale);

}  // namespace sonde
