// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "engine/base/error.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {

/// Files of models that place meshes, copied, moved and mirrored: all copies, as one soup, in
/// metres by the file's own unit, in the file's own axes (nothing is turned to another "up"). What
/// a mirrored copy shows outside stays outside. The coordinates have single precision. `file` is
/// for messages alone. Each throws InputError for a file that is cut off or lies, that names other
/// files, that places objects inside themselves, that unpacks to more than most_corners or
/// most_unpacked, or that needs what is not read; and where Sonde was built without assimp. Each
/// throws Cancelled where progress returns false.
/// glTF 2.0, text with its data inside, or GLB.
PolygonSoup read_gltf(const std::string& file, std::string_view bytes, const Progress& progress);
PolygonSoup read_3mf(const std::string& file, std::string_view bytes, const Progress& progress);
PolygonSoup read_dae(const std::string& file, std::string_view bytes, const Progress& progress);

/// The corners of all polygons of all copies, ten million triangles: some 2 GiB once read. A file
/// of a few bytes may ask for any number.
constexpr double most_corners = 3e7;
/// Bytes of a compressed part.
constexpr std::size_t most_unpacked = std::size_t{1} << 30;

}  // namespace sonde
