// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/mesh_io/mesh_scan.hpp"

namespace sonde {

enum class PlyFormat { text, little_endian, big_endian };
enum class PlyKind { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

struct PlyType {
  std::string name;
  std::string other_name;
  PlyKind kind;
  std::size_t size;
  bool is_integer() const { return kind < PlyKind::float32; }
};

enum class PlyRole { other, x, y, z, corners };

struct PlyProperty {
  const PlyType* type = nullptr;        ///< of the number, or of the list's entries
  const PlyType* count_type = nullptr;  ///< of a list's length
  bool is_list = false;
  PlyRole role = PlyRole::other;
};

/// Strips: each triangle is the last two corners and the next; -1 begins another strip.
enum class PlyElementRole { other, vertices, faces, strips };

struct PlyElement {
  std::string name;
  PlyElementRole role = PlyElementRole::other;
  std::uint64_t count = 0;
  std::size_t line = 0;  ///< where it is declared
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::text;
  std::string format_name;
  std::vector<PlyElement> elements;
  std::uint64_t vertices = 0;
  std::uint64_t faces = 0;
  Remarks remarks;
};

/// Reads the header of a PLY file and checks that it declares a mesh, of no more elements than the
/// file can hold. Leaves the scanner at the line after the header.
PlyHeader read_ply_header(MeshScanner& scan);

}  // namespace sonde
