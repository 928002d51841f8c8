// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "engine/base/error.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {

/// Reads OFF, OBJ, PLY (text and binary), STL (text and binary), GLB, glTF, 3MF and DAE (these four
/// where Sonde is built with assimp), told apart by extension. Coordinates are multiplied by
/// `scale` (unit of the file to metres, times the scene's scale); where a file states its unit,
/// they are in metres before that. Throws InputError naming the file, the line or byte offset, and
/// the reason, for a missing, empty, truncated or lying file, an index out of range, or a
/// coordinate that is not finite; throws Cancelled where progress returns false.
PolygonSoup read_mesh(const std::filesystem::path& file, double scale = 1.0,
                      const Progress& progress = {});

/// Whether files of this format, told by their extension, state their unit: GLB, glTF, 3MF, DAE.
bool has_own_unit(const std::filesystem::path& file);

/// Whether the extension is one of those that are read.
bool is_mesh_name(const std::filesystem::path& file);

}  // namespace sonde
