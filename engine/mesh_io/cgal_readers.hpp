// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "engine/base/error.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {

enum class MeshFormat { off, obj, ply, stl };

/// Parses the text (or binary PLY) of a mesh with CGAL; false where CGAL refuses it. The caller has
/// checked it: CGAL trusts declared counts, and takes some faults for data. Numbers are read with
/// '.', whatever the locale. Throws Cancelled where progress returns false.
bool parse_with_cgal(MeshFormat format, const std::string& text, PolygonSoup& soup,
                     const Progress& progress);

}  // namespace sonde
