// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "engine/geometry/soup.hpp"
#include "resources/generate/path.hpp"

namespace sonde::generate {

/// What a scene file says, beside its two meshes and its path.
struct SceneText {
  std::string name;
  std::string probe;                  ///< file in models/
  std::string fixed;                  ///< file in models/
  std::string model;                  ///< "solid", "surface" or "auto", of the fixed body
  double k = 500;                     ///< N/m
  Vec3 view = Vec3(-0.45, -1, 0.55);  ///< from what is looked at towards the eye
};

/// Writes models, scenes and device paths under one folder, always the same bytes.
class Output {
 public:
  /// `root` gets the folders models and scenes.
  explicit Output(std::filesystem::path root);

  /// Binary little-endian PLY, coordinates in metres as floats.
  void mesh(const std::string& file, const Soup& soup) const;
  /// NAME.sonde.json and NAME.path.csv, sampled at 1 kHz.
  void scene(const SceneText& text, const Path& path) const;

 private:
  std::filesystem::path root_;
};

/// One function for each family of models, each in its own source.
void write_spoon_in_cup(const Output& out);
void write_torus_knots(const Output& out);
void write_linked_tori(const Output& out);
void write_peg_in_hole(const Output& out);
void write_nut_on_bolt(const Output& out);
void write_crumpled_soup(const Output& out);
void write_terrain(const Output& out);

}  // namespace sonde::generate
