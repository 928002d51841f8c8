// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "engine/base/error.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {

/// One walk through the bytes of a mesh file, which checks and reads at once. Numbers have a '.',
/// whatever the locale. `file` is for messages alone. Each throws InputError with the line (or the
/// byte, in binary data) of the first fault that it finds: counts that the file cannot hold or does
/// not, words that are no numbers, coordinates that are not finite, indices out of range, more data
/// than declared. Each throws Cancelled where progress returns false.
PolygonSoup read_off(const std::string& file, std::string_view bytes, const Progress& progress);
PolygonSoup read_obj(const std::string& file, std::string_view bytes, const Progress& progress);
PolygonSoup read_ply(const std::string& file, std::string_view bytes, const Progress& progress);
/// STL names the corners of each triangle: those at one place become one point.
PolygonSoup read_stl(const std::string& file, std::string_view bytes, const Progress& progress);

}  // namespace sonde
