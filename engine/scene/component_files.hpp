// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <utility>
#include <vector>

#include "engine/mending/components.hpp"

namespace sonde {

/// Maximum number of components of a body: a file with more has loose triangles, not parts.
inline constexpr std::size_t most_parts = 10'000;

/// Mesh files split into components (components_of), each file once, for any number of its parts.
/// Keep it only while parts are loaded, since it holds the files' polygons.
class ComponentFiles {
 public:
  /// The components of a file, with its coordinates multiplied by `scale`. Throws as read_mesh
  /// does, and InputError if there are too many.
  const std::vector<PolygonSoup>& of(const std::filesystem::path& mesh, double scale,
                                     const Progress& progress = {});

 private:
  std::map<std::pair<std::filesystem::path, double>, std::vector<PolygonSoup>> read_;
};

}  // namespace sonde
