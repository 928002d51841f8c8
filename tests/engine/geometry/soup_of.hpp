// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/soup.hpp"

namespace sonde::test {

/// The triangles of polygons.
inline Soup soup_of(const PolygonSoup& polygons) { return triangulate(polygons).soup; }

}  // namespace sonde::test
