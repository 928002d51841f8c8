// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/devices/device_settings.hpp"
#include "engine/haptics/coupling/coupling.hpp"
#include "engine/haptics/loop/servo.hpp"
#include "engine/scene/scene_body.hpp"

namespace sonde {

/// The device settings of a scene.
struct SceneDevice {
  /// The profile to simulate unless another device is chosen: an id, or a path that ends in ".json"
  /// (absolute, or relative to the working directory). Empty where the scene names none.
  std::string profile;
  /// None: the settings stored for the device, or the defaults.
  std::optional<DeviceSettings> settings;
};

/// A scene file, read and checked (NAME.sonde.json). Meshes are not loaded yet.
struct Scene {
  std::filesystem::path file;
  std::string name;
  double unit = 1;  ///< metres per unit of the mesh files and of the scene's lengths
  SceneBody probe;
  SceneBody fixed;
  std::optional<std::filesystem::path> trajectory;
  Coupling coupling;
  ServoSettings servo;
  SceneDevice device;
  /// The `view` object as JSON text, for the desktop program; "{}" where absent.
  std::string view = "{}";
  std::string schema = {};         ///< "$schema", for editors; kept as it stands
  std::optional<int> format = {};  ///< its version, where the file says one
};

/// Reads a scene. Throws InputError that names the file, the line and the reason: JSON that does
/// not parse, a missing key, an unknown one (with the nearest known), a value out of range or a
/// quaternion far from unit. For a file that is missing, empty or cannot be read, it names the file
/// and the reason alone.
Scene read_scene(const std::filesystem::path& file);
/// The same, and refuses a path in the scene (mesh, trajectory, gains, profile) that leads out of
/// that folder, links followed.
Scene read_scene_within(const std::filesystem::path& folder, const std::filesystem::path& file);
/// The files that a scene names (mesh, trajectory, gains, profile) outside of a folder, links
/// followed; none of them is read. Throws as read_scene does.
std::vector<std::filesystem::path> paths_out_of(const std::filesystem::path& folder,
                                                const std::filesystem::path& file);
/// The same of a scene's text, wherever it comes from, that is read as if it were in that file.
std::vector<std::filesystem::path> paths_out_of(const std::filesystem::path& folder,
                                                const std::string& text,
                                                const std::filesystem::path& file);
/// Whether a file, there or not, lies below a folder, when links are followed.
bool lies_within(const std::filesystem::path& folder, const std::filesystem::path& file);
/// As read_scene, from the text of a file, wherever it comes from.
Scene scene_in(const std::string& text, const std::filesystem::path& file);

/// The name of a scene in that file: the file's name, without folder and ".sonde.json".
std::string name_of_scene(const std::filesystem::path& file);

/// Reads a file that holds a scene's `coupling` object alone. Errors as read_scene.
Coupling read_coupling(const std::filesystem::path& file);

/// Every key that read_scene accepts, with its parents: "unit", "probe", "probe.mesh", ...
std::vector<std::string> scene_keys();

/// Metres per unit, "m" | "cm" | "mm" | "um" | "in" | "ft"; no value for anything else.
std::optional<double> unit_in_metres(const std::string& unit);
/// The name of a unit, exactly.
std::optional<std::string> unit_name(double metres);

/// The pose of the probe's mesh frame in the fixed body's mesh frame, from the two poses of a
/// scene.
Pose relative_pose(const Scene& scene);

/// Throws InputError with the scene's line where one of its meshes is not there. For a scene just
/// read.
void require_meshes(const Scene& scene);

}  // namespace sonde
