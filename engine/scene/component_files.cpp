// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/scene/component_files.hpp"

#include "engine/base/progress.hpp"
#include "engine/mesh_io/read_mesh.hpp"

namespace sonde {

const std::vector<PolygonSoup>& ComponentFiles::of(const std::filesystem::path& mesh, double scale,
                                                   const Progress& progress) {
  const std::pair key{mesh, scale};
  const std::lock_guard lock(reading_);
  if (const auto known = read_.find(key); known != read_.end()) return known->second;
  std::vector<PolygonSoup> components =
      components_of(read_mesh(mesh, scale, part_of(progress, 0, 0.5)), part_of(progress, 0.5, 1));
  return read_.emplace(key, std::move(components)).first->second;
}

}  // namespace sonde
