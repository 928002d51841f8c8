// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "engine/geometry/soup.hpp"

namespace sonde {

/// True where the first line says "OFF BINARY", with any of the prefixes ST, C and N.
bool is_binary_off(std::string_view bytes);

/// Reads binary OFF as Geomview defines it: after the first line the numbers of vertices, faces and
/// edges, each vertex, and each face as its number of corners, their indices, and a number of
/// colour values and those; whole numbers and floats of 32 bits, big-endian. Normals, colours and
/// texture coordinates are passed over. Throws InputError with the byte of the first fault: counts
/// that the file cannot hold, an index out of range, a coordinate that is not finite, a face of
/// fewer than three corners, an end too early or too late.
PolygonSoup read_binary_off(const std::string& file, std::string_view bytes,
                            const Progress& progress);

}  // namespace sonde
