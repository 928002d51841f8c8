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
  /// (absolute, or relative to the working directory). Empty if the scene names none.
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
  std::size_t trajectory_line = 0;  ///< where the file, as it was read, names it; 0: it does not
  Coupling coupling;
  ServoSettings servo;
  SceneDevice device;
  /// The `view` object as JSON text, for the desktop program; "{}" if absent.
  std::string view = "{}";
  std::string schema = {};         ///< "$schema", for editors; kept unchanged
  std::optional<int> format = {};  ///< the version, if the file states one
};

/// Reads a scene. Throws InputError that names the file, the line and the reason: JSON that does
/// not parse, a missing key, an unknown one (with the nearest known), a value out of range, or a
/// quaternion far from unit length. For a file that is missing, empty or unreadable, it names only
/// the file and the reason.
Scene read_scene(const std::filesystem::path& file);
/// The same, but refuses a path in the scene (mesh, trajectory, gains, profile) that leads out of
/// that folder, after resolving links.
Scene read_scene_within(const std::filesystem::path& folder, const std::filesystem::path& file);
/// The files that a scene names (mesh, trajectory, gains, profile) outside a folder, after
/// resolving links; none of them is read. Throws as read_scene does.
std::vector<std::filesystem::path> paths_out_of(const std::filesystem::path& folder,
                                                const std::filesystem::path& file);
/// The same for a scene's text from any source, read as if it were in that file.
std::vector<std::filesystem::path> paths_out_of(const std::filesystem::path& folder,
                                                const std::string& text,
                                                const std::filesystem::path& file);
/// Whether a file, existing or not, lies below a folder, after resolving links.
bool lies_within(const std::filesystem::path& folder, const std::filesystem::path& file);
/// As read_scene, from a text of any source, read as if it were in that file.
Scene scene_in(const std::string& text, const std::filesystem::path& file);

/// The name of a scene in that file: the file's name without folder and ".sonde.json".
std::string name_of_scene(const std::filesystem::path& file);

/// Reads a file that contains only a scene's `coupling` object. Errors as for read_scene.
Coupling read_coupling(const std::filesystem::path& file);

/// Every key that read_scene accepts, with its parents: "unit", "probe", "probe.mesh", ...
std::vector<std::string> scene_keys();

/// The pose of the probe's mesh frame in the fixed body's mesh frame, from the two poses of a
/// scene.
Pose relative_pose(const Scene& scene);

/// Throws InputError with the scene's line if one of its meshes does not exist. For a scene that
/// was just read.
void require_meshes(const Scene& scene);
/// The same of its trajectory, for what needs that.
void require_trajectory(const Scene& scene);

}  // namespace sonde
