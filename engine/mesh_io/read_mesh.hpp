// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "engine/base/error.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {

/// Reads OFF, OBJ, PLY (text and binary) and STL (text and binary), told apart by extension.
/// Coordinates are multiplied by `scale` (unit of the file to metres, times the scene's scale).
/// Throws InputError naming the file, the line or byte offset, and the reason, for a missing,
/// empty, truncated or lying file, an index out of range, or a coordinate that is not finite;
/// throws Cancelled where progress returns false.
PolygonSoup read_mesh(const std::filesystem::path& file, double scale = 1.0,
                      const Progress& progress = {});

}  // namespace sonde
