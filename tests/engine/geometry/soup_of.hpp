// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/soup.hpp"
#include "engine/geometry/topology.hpp"

namespace sonde::test {

/// The triangles of polygons.
inline Soup soup_of(const PolygonSoup& polygons) { return triangulate(polygons).soup; }

/// The same with one vertex for each place.
inline Soup welded(const PolygonSoup& polygons) { return compacted(soup_of(polygons)); }

}  // namespace sonde::test
