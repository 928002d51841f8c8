// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "engine/geometry/soup.hpp"
#include "engine/mesh_io/binary_scan.hpp"
#include "engine/mesh_io/mesh_scan.hpp"

namespace sonde {

struct OffCounts {
  std::uint64_t vertices, faces;
};

/// "" where the counts can be; else why not. `room`: the bytes that follow, of which a vertex and a
/// face take so many at least.
std::string fault_of(const OffCounts& counts, std::uint64_t room, std::uint64_t least_vertex,
                     std::uint64_t least_face);

/// The rest of a text file. `first` is the word of the number of vertices, which the scanner has
/// passed; `extras` how many numbers the keyword announces for a vertex beside its coordinates. A
/// line holds a vertex or a face; where the file has too few lines for that, they may be anywhere,
/// one after the other. Files that have more numbers with their vertices than announced are read.
PolygonSoup read_text_off(MeshScanner& scan, std::string_view first, std::size_t extras);

/// The same of a file as Geomview writes it: whole numbers of four bytes and floats, the most
/// significant byte first.
PolygonSoup read_binary_off(BinaryScanner scan, std::size_t extras);

}  // namespace sonde
