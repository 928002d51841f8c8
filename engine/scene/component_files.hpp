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

/// A body of more is refused: so many components of a file are no parts but loose triangles.
inline constexpr std::size_t most_parts = 10'000;

/// Mesh files taken apart (components_of), each once, however many parts are of it. Kept while
/// parts are loaded, not longer: it holds the files' polygons.
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
