// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "engine/scene/scene.hpp"

namespace sonde {

/// The scene as the text of a file in that folder, with paths relative to it. Reading it from there
/// restores every field to the bit, for poses from read_scene and storable(), and any other
/// position within one rounding. Throws InputError if the name of a file is not UTF-8, and
/// std::invalid_argument if `unit` has no name in a scene.
std::string scene_text(const Scene& scene, const std::filesystem::path& folder);

/// Writes it whole or not at all. Throws InputError naming the file and the reason.
void write_scene(const Scene& scene, const std::filesystem::path& file);

/// The pose with its position rounded to 12 digits of the unit, so that a scene in that unit can
/// store it exactly.
Pose storable(const Pose& pose, double unit);

}  // namespace sonde
