// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "engine/devices/device_settings.hpp"
#include "engine/geometry/model.hpp"
#include "engine/haptics/coupling/coupling.hpp"
#include "engine/haptics/loop/servo.hpp"

namespace sonde {

/// One setting. The slider, the flag, the scene key, the saved setting and the tooltip all come
/// from this one declaration, in the table of settings.cpp.
struct Setting {
  const char* key;    ///< scene key; the flag is the same with '-' for '_'
  const char* label;  ///< name for the user, in sentence case
  const char* unit;   ///< SI, "" where there is none
  double minimum;     ///< allowed values, both ends included
  double maximum;
  double fallback;   ///< the value where nothing sets it; that of the struct's own initialiser
  bool logarithmic;  ///< the scale of a slider; its minimum is then above zero
  const char* doc;   ///< one line: tooltip and help
  bool integer = false;
  const char* coupling_modes = "";  ///< those that use it, with spaces between; "": all
};

/// One value of a setting that is a choice.
struct Choice {
  const char* key;
  const char* label;
  const char* doc;
};

/// The gains: k, k_t, k_r, b_t, b_r, max_force, max_torque. (The mode is a choice: coupling_modes.)
std::span<const Setting> coupling_settings();
/// The values of the coupling's "mode", in the order of Coupling::Mode.
std::span<const Choice> coupling_modes();
/// The servo's: rate_hz, budget_us, budget_steps, accuracy, ramp_time, force_slew, torque_slew,
/// force_error, passivity_control.
std::span<const Setting> servo_settings();

/// A device's: scaling, reach, turn, smoothing, clutch_button.
std::span<const Setting> device_settings();
/// The settings of each axis: gain, dead_zone, expo.
std::span<const Setting> axis_settings();
/// The values of the device's "control" and "frame", in the order of the enumerations.
std::span<const Choice> device_controls();
std::span<const Choice> device_frames();
/// The six axes, in the order of SixAxes: x, y, z, rx, ry, rz.
std::span<const Choice> device_axes();

/// Whether a coupling of that mode uses the setting.
bool is_used(const Setting& setting, Coupling::Mode mode);
/// The setting of that key; null where there is none.
const Setting* find_setting(std::span<const Setting> settings, std::string_view key);

/// True where the value is finite, within the range, and whole where the setting is an integer.
bool allowed(const Setting& setting, double value);
/// The range in words for messages: "between 1 and 100000 N/m".
std::string range_text(const Setting& setting);

/// Reads and writes a setting by its key. set() brings the value into the range. Both throw
/// std::invalid_argument for an unknown key, set() for a value that is not finite.
double get(const Coupling& coupling, std::string_view key);
void set(Coupling& coupling, std::string_view key, double value);
double get(const ServoSettings& servo, std::string_view key);
void set(ServoSettings& servo, std::string_view key, double value);
double get(const DeviceSettings& device, std::string_view key);
void set(DeviceSettings& device, std::string_view key, double value);
double get(const AxisSetting& axis, std::string_view key);
void set(AxisSetting& axis, std::string_view key, double value);

/// The place of a name in a table of choices; none where it is not there.
std::optional<std::size_t> place_of(std::span<const Choice> choices, std::string_view name);

const char* name_of(Coupling::Mode mode);
std::optional<Coupling::Mode> coupling_mode(std::string_view name);
const char* name_of(Model model);
std::optional<Model> model_named(std::string_view name);  ///< "auto" | "solid" | "surface"
const char* name_of(Repair repair);
std::optional<Repair> repair_named(std::string_view name);  ///< "auto" | "none"

}  // namespace sonde
