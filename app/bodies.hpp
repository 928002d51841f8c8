// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/progress_line.hpp"
#include "engine/penetration/search/pair.hpp"
#include "engine/scene/scene.hpp"

namespace sonde::app {

/// The source of the two bodies: a scene, or two meshes.
struct BodyOptions {
  std::string scene;
  std::string within;                    ///< the folder that the scene's paths stay in, or empty
  std::string probe, fixed;              ///< mesh files, instead of a scene
  std::string probe_model, fixed_model;  ///< empty: the scene's, or auto
  std::string repair;                    ///< of both; empty: the scene's, or auto
  double probe_scale = 1, fixed_scale = 1;
  std::string unit = "m";
  std::optional<double> allowance, safety;  ///< m; none: the scene's
};
void add_scene_or_meshes(CLI::App& parser, BodyOptions& options);
void add_scene(CLI::App& parser, BodyOptions& options);

/// The scene from its file, or a scene made of the two meshes, with the models of the command line.
Scene scene_of(const BodyOptions& options);

/// The flags that take a body smaller or larger, and what they say: m, outwards; none where neither
/// is given. `whose`: "the probe".
void add_offsets(CLI::App& parser, const std::string& whose, std::optional<double>& allowance,
                 std::optional<double>& safety);
std::optional<double> offset_of(const std::optional<double>& allowance,
                                const std::optional<double>& safety);

/// The flag that keeps a scene's paths in a folder.
void add_within(CLI::App& parser, std::string& folder);
/// Reads a scene whose paths stay in the folder (anywhere, where that is empty), and looks whether
/// its meshes are there.
Scene scene_at(const std::string& file, const std::string& within);

/// A trajectory that is given stands for the scene's.
void take_trajectory(Scene& scene, const std::string& given);

/// The files of a scene.
std::vector<std::filesystem::path> inputs_of(const Scene& scene);

/// The flag that says what is done to meshes that are not closed.
void add_repair(CLI::App& parser, std::string& repair);

/// What a reader of results must know of a body beside its numbers, a sentence each: what was
/// mended or set aside, and what keeps an inside from counting.
std::vector<std::string> remarks_on(const Body& body);
/// Writes those on a body to stderr, a line each, after the name of what is meant.
void say_remarks_on(const Body& body, const std::string& name);
/// Those on both bodies: "the probe spoon.ply: 1 opening closed by ...".
std::vector<std::string> remarks_on(const Pair& pair);

/// Loads the two bodies, and reports changes to them on stderr, unless quiet.
Pair load_bodies(const Scene& scene, bool quiet, ProgressLine& progress);
Pair load_bodies(const Scene& scene, bool quiet);

}  // namespace sonde::app
