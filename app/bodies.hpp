// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/progress_line.hpp"
#include "engine/penetration/search/pair.hpp"
#include "engine/scene/scene.hpp"

namespace sonde::app {

/// Where the two bodies come from: a scene, or two loose meshes.
struct BodyOptions {
  std::string scene;
  std::string probe, fixed;              ///< mesh files, instead of a scene
  std::string probe_model, fixed_model;  ///< empty: the scene's, or auto
  double probe_scale = 1, fixed_scale = 1;
  std::string unit = "m";
};
void add_scene_or_meshes(CLI::App& parser, BodyOptions& options);
void add_scene(CLI::App& parser, BodyOptions& options);

/// The scene read, or one made of the two loose meshes, with the models asked for on the command
/// line.
Scene scene_of(const BodyOptions& options);

/// The files a scene is made of.
std::vector<std::filesystem::path> inputs_of(const Scene& scene);

/// Loads the two bodies, and notes on stderr what was changed in them, unless quiet.
Pair load_bodies(const Scene& scene, bool quiet, ProgressLine& progress);
Pair load_bodies(const Scene& scene, bool quiet);

}  // namespace sonde::app
