// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <mutex>
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
  /// The components of a file, its coordinates multiplied by that. Throws as read_mesh. May be
  /// called by several threads at once.
  const std::vector<PolygonSoup>& of(const std::filesystem::path& mesh, double scale,
                                     const Progress& progress = {});

 private:
  std::mutex reading_;
  std::map<std::pair<std::filesystem::path, double>, std::vector<PolygonSoup>> read_;
};

}  // namespace sonde
