// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/real_meshes.hpp"

#include <algorithm>
#include <stdexcept>

namespace sonde::test {
namespace {
std::runtime_error missing(const std::filesystem::path& path) {
  return std::runtime_error(path.string() +
                            " is missing: install libcgal-demo with its doc folder, then run cmake "
                            "again, which unpacks its meshes");
}
}  // namespace

std::filesystem::path real_mesh(const std::string& name) {
  const std::filesystem::path path = std::filesystem::path(SONDE_REAL_MESHES) / name;
  if (!std::filesystem::is_regular_file(path)) throw missing(path);
  return path;
}

std::shared_ptr<const Body> real_body(const std::string& name) {
  return load_body(real_mesh(name).string(), Model::automatic, 1);
}

std::vector<std::filesystem::path> real_meshes() {
  if (!std::filesystem::is_directory(SONDE_REAL_MESHES)) throw missing(SONDE_REAL_MESHES);
  std::vector<std::filesystem::path> all;
  for (const auto& entry : std::filesystem::directory_iterator(SONDE_REAL_MESHES))
    all.push_back(entry.path());
  if (all.empty()) throw missing(SONDE_REAL_MESHES);
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace sonde::test
