// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "engine/devices/connection.hpp"
#include "engine/devices/input_device.hpp"
#include "engine/scene/poses.hpp"
#include "engine/settings/device_profile.hpp"

namespace sonde::ui {

/// The mouse itself, without a device.
struct MouseSource {};
/// A recorded path: that of a file, or the scene's where the file is empty.
struct PathSource {
  std::filesystem::path file{};
  /// Of the file. Shared: a source is copied, a path of minutes is long.
  std::shared_ptr<const std::vector<TimedPose>> path{};
};
/// A simulated device, which the mouse drives.
struct SimulatedSource {
  DeviceProfile profile;
};
/// A device that is, or was, connected.
struct ConnectedSource {
  DeviceChoice choice;
  std::string name;
  DeviceKind kind = DeviceKind::space_mouse;
};

/// What holds the probe.
using InputSource = std::variant<MouseSource, PathSource, SimulatedSource, ConnectedSource>;

/// Name for the user: "Mouse", "sigma.7 (simulated)", "SpaceMouse Compact".
std::string name_of(const InputSource& source);
/// The same for a list to choose from. Two devices of the same name are distinguished by their
/// nodes, which change when they are plugged in again.
std::vector<std::string> labels_of(std::span<const InputSource> sources);
/// The file of its settings; empty where it has none. A device without a serial number has one for
/// the port that it is plugged into.
std::string settings_name_of(const InputSource& source);
/// The file that such devices of one model share; empty for everything else.
std::string model_settings_name_of(const InputSource& source);
/// The settings it has before any are made.
DeviceSettings usual_settings(const InputSource& source);
/// Returns whether it is the same device, by its ids and its serial number; without one, by its
/// port, or its node where the system tells no port.
bool same(const InputSource& a, const InputSource& b);

ConnectedSource source_of(const HidInfo& info);

/// The path recorded in a CSV file. Throws InputError with the file, the line and the reason.
PathSource path_source(const std::filesystem::path& file);

/// A name that matches nothing: wrong usage.
class UnknownDevice : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What `--device` asks for:
/// - `auto`: the first connected device that opens, else the mouse; `mouse` and `path`: those;
/// - a path: a profile (it ends in ".json"), a recorded path (".csv"), or the node of a device
///   (/dev/hidraw3);
/// - a name: the id of a profile, or the name of a connected device, in large or small letters, or
///   its ids (256f:c635).
/// Throws UnknownDevice, naming the nearest known name, or InputError where the file cannot be
/// read, or none of the devices of that name be opened, with the reason.
InputSource find_source(const std::string& asked,
                        std::span<const std::filesystem::path> profile_folders);

}  // namespace sonde::ui
