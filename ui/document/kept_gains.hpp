// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "engine/haptics/coupling/coupling.hpp"
#include "engine/scene/scene.hpp"

namespace sonde::ui {

/// The two sets of gains that a person had for one scene on one device.
struct KeptGains {
  std::array<Coupling, 2> sets;
  std::size_t active = 0;  ///< 0 or 1
  Coupling of_scene;       ///< what the scene said then
};

/// True where mode and every gain are the same.
bool same(const Coupling& a, const Coupling& b);

/// The file for a scene and a device, in the user's folder for Sonde's settings. A scene is told
/// apart by its file's place, or those of its meshes where it has none; the device by its name in
/// `device`.
std::filesystem::path kept_gains_file(const Scene& scene, const std::string& device);

/// None where there is no file, or the scene's own gains were changed since by somebody else: then
/// the scene counts. Throws InputError where the file is no such thing.
std::optional<KeptGains> read_kept_gains(const std::filesystem::path& file,
                                         const Coupling& of_scene);
/// Whole or not at all; makes the folder. Throws InputError.
void write_kept_gains(const std::filesystem::path& file, const KeptGains& gains);

}  // namespace sonde::ui
