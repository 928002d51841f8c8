// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sonde {

/// A glTF file with nothing in it but nodes, meshes and their data.
struct GltfShape {
  std::string bytes;
  bool binary = false;          ///< GLB
  std::uint64_t triangles = 0;  ///< of all copies
  std::vector<std::string> remarks;
};

/// Checks the whole of what bears on the shape (glTF 2.0, "Concepts" and "GLB File Format
/// Specification"), and leaves the rest out: images, materials, skins, motions. So a library that
/// trusts its file can read it. Throws InputError as asset_readers.hpp has it.
GltfShape gltf_shape(const std::string& file, std::string_view bytes);

}  // namespace sonde
