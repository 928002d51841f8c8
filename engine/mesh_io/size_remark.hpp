// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/soup.hpp"

namespace sonde {

/// Adds a remark where the largest side of the bounding box is over 50 m or under 100 µm, which is
/// hardly meant: with the unit that would make it sensible, where there is one. `scale`: what the
/// numbers of the file were multiplied by; 0 where the file says its unit itself.
void remark_on_size(PolygonSoup& soup, double scale);

}  // namespace sonde
