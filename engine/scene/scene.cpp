// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/scene/scene.hpp"

#include <string_view>
#include <system_error>

#include "engine/scene/scene_reader.hpp"
#include "engine/text/json_checks.hpp"
#include "engine/text/text_file.hpp"

namespace sonde {
namespace {

// For most_parts, in the form that the window writes.
constexpr std::size_t most_scene_bytes = 1 << 22;

}  // namespace

std::string name_of_scene(const std::filesystem::path& file) {
  std::string name = file.filename().string();
  for (const std::string_view ending : {".json", ".sonde"})
    if (name.ends_with(ending) && name.size() > ending.size())
      name.resize(name.size() - ending.size());
  return name;
}

Coupling read_coupling(const std::filesystem::path& file) {
  return SceneReader{file}.coupling(read_text(file, most_scene_bytes));
}

Scene read_scene(const std::filesystem::path& file) {
  return scene_in(read_text(file, most_scene_bytes), file);
}

Scene read_scene_within(const std::filesystem::path& folder, const std::filesystem::path& file) {
  return SceneReader{file, folder}.scene(read_text(file, most_scene_bytes));
}

std::vector<std::filesystem::path> paths_out_of(const std::filesystem::path& folder,
                                                const std::filesystem::path& file) {
  return paths_out_of(folder, read_text(file, most_scene_bytes), file);
}

std::vector<std::filesystem::path> paths_out_of(const std::filesystem::path& folder,
                                                const std::string& text,
                                                const std::filesystem::path& file) {
  std::vector<std::filesystem::path> out;
  SceneReader{file, folder, &out}.scene(text);
  return out;
}

bool lies_within(const std::filesystem::path& folder, const std::filesystem::path& file) {
  std::error_code error;
  const auto whole = std::filesystem::weakly_canonical(file, error);
  if (error) return false;
  const auto below = whole.lexically_relative(std::filesystem::canonical(folder, error));
  return !error && !below.empty() && *below.begin() != "..";
}

Scene scene_in(const std::string& text, const std::filesystem::path& file) {
  return SceneReader{file}.scene(text);
}

std::vector<std::string> scene_keys() { return SceneReader::keys(); }

void require_meshes(const Scene& scene) {
  for (const SceneBody* whole : {&scene.probe, &scene.fixed})
    for (const SceneBody& body : meshes_of(*whole))
      expect_file(scene.file, body.mesh_line, "mesh", body.mesh);
}

void require_trajectory(const Scene& scene) {
  if (scene.trajectory && scene.trajectory_line > 0)
    expect_file(scene.file, scene.trajectory_line, "trajectory", *scene.trajectory);
}

Pose relative_pose(const Scene& scene) { return inverse(scene.fixed.pose) * scene.probe.pose; }

}  // namespace sonde
