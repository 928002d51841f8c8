// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/devices/device_settings.hpp"
#include "engine/text/located_json.hpp"

namespace sonde {

/// The settings of a device as a JSON object, in a file of its own and in a scene's `device`:
///
///     {"control": "rate", "frame": "view", "scaling": 1, ...,
///      "axes": {"x": {"from": "y", "inverted": true, "gain": 1, "dead_zone": 0.05}, ...}}
///
/// What is left out has its default. A file of its own may hold "servo" beside, with "rate_hz" and
/// "passivity_control": a scene says those for itself.

/// The keys of that object.
std::vector<std::string_view> device_settings_keys();
/// The keys of each axis.
std::vector<std::string_view> device_axis_keys();

/// Reads the object; its keys may be more than these, and the caller has checked them. Throws
/// InputError naming the file, the line and the reason.
DeviceSettings device_settings_in(const std::filesystem::path& file, const JsonNode& object);

/// Reads a file that holds such an object alone. Errors as above, an unknown key with the nearest.
DeviceSettings read_device_settings(const std::filesystem::path& file);

/// The object as text; reads back as the same settings, to the bit.
std::string device_settings_text(const DeviceSettings& settings);

/// The file name for a device's settings: "256f-c635-SERIAL.json", without the serial number where
/// it has none; for a simulated device "ID.json". Letters that a file name should not have become
/// '_'.
std::string device_settings_name(std::uint16_t vendor, std::uint16_t product,
                                 std::string_view serial);
std::string device_settings_name(std::string_view profile_id);

}  // namespace sonde
