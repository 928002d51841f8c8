// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/settings/device_settings_file.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "engine/settings/json_settings.hpp"
#include "engine/text/json_checks.hpp"
#include "engine/text/text_file.hpp"

namespace sonde {
namespace {

using Kind = JsonNode::Kind;
using Path = std::filesystem::path;

constexpr std::size_t most_settings_bytes = 1 << 16;

AxisSetting read_axis(const Path& file, const JsonNode& node, AxisSetting axis) {
  expect_keys(file, node, device_axis_keys());
  if (const JsonNode* from = node.find("from"))
    axis.source = static_cast<int>(read_choice(file, *from, device_axes()));
  if (const JsonNode* inverted = node.find("inverted")) {
    expect_kind(file, *inverted, Kind::boolean);
    axis.inverted = inverted->boolean;
  }
  read_settings(file, node, axis_settings(), axis);
  return axis;
}

constexpr std::array<std::string_view, 2> servo_keys{"rate_hz", "passivity_control"};

/// What the device wants of the loop.
void read_servo(const Path& file, const JsonNode& node, DeviceSettings& settings) {
  expect_keys(file, node, {servo_keys.begin(), servo_keys.end()});
  ServoSettings servo;
  read_settings(file, node, servo_settings(), servo);
  if (node.find("rate_hz")) settings.rate_hz = servo.rate_hz;
  if (node.find("passivity_control")) settings.passivity_control = servo.passivity.control;
}

std::string hex(std::uint16_t id) {
  constexpr char digits[] = "0123456789abcdef";
  std::string text;
  for (int shift = 12; shift >= 0; shift -= 4) text += digits[(id >> shift) & 15];
  return text;
}

std::string as_file_name(std::string text) {
  std::ranges::replace_if(
      text,
      [](char c) {
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        return !letter && !(c >= '0' && c <= '9') && c != '-' && c != '.';
      },
      '_');
  return text + ".json";
}

}  // namespace

std::vector<std::string_view> device_settings_keys() {
  std::vector<std::string_view> keys = keys_of(device_settings());
  keys.insert(keys.end(), {"control", "frame", "axes"});
  return keys;
}

std::vector<std::string_view> device_axis_keys() {
  std::vector<std::string_view> keys = keys_of(axis_settings());
  keys.insert(keys.end(), {"from", "inverted"});
  return keys;
}

DeviceSettings device_settings_in(const Path& file, const JsonNode& object) {
  DeviceSettings settings;
  if (const JsonNode* control = object.find("control"))
    settings.control =
        static_cast<DeviceSettings::Control>(read_choice(file, *control, device_controls()));
  if (const JsonNode* frame = object.find("frame"))
    settings.frame = static_cast<DeviceSettings::Frame>(read_choice(file, *frame, device_frames()));
  read_settings(file, object, device_settings(), settings);
  if (const JsonNode* axes = object.find("axes")) {
    expect_keys(file, *axes, keys_of(device_axes()));
    for (std::size_t i = 0; i < settings.axes.axes.size(); ++i)
      if (const JsonNode* axis = axes->find(device_axes()[i].key))
        settings.axes.axes[i] = read_axis(file, *axis, settings.axes.axes[i]);
  }
  return settings;
}

DeviceSettings read_device_settings(const Path& file) {
  const JsonNode root = parse_json(file.string(), read_text(file, most_settings_bytes));
  std::vector<std::string_view> keys = device_settings_keys();
  keys.emplace_back("servo");
  expect_keys(file, root, keys);
  DeviceSettings settings = device_settings_in(file, root);
  if (const JsonNode* servo = root.find("servo")) read_servo(file, *servo, settings);
  return settings;
}

std::string device_settings_text(const DeviceSettings& settings) {
  nlohmann::ordered_json json;
  json["control"] = device_controls()[static_cast<std::size_t>(settings.control)].key;
  json["frame"] = device_frames()[static_cast<std::size_t>(settings.frame)].key;
  const auto add = [](nlohmann::ordered_json& to, const auto& from, const Setting& setting) {
    if (setting.integer)
      to[setting.key] = static_cast<int>(get(from, setting.key));
    else
      to[setting.key] = get(from, setting.key);
  };
  for (const Setting& setting : device_settings()) add(json, settings, setting);
  if (settings.rate_hz) json["servo"]["rate_hz"] = *settings.rate_hz;
  if (settings.passivity_control)
    json["servo"]["passivity_control"] = static_cast<int>(*settings.passivity_control);
  for (std::size_t i = 0; i < settings.axes.axes.size(); ++i) {
    const AxisSetting& axis = settings.axes.axes[i];
    nlohmann::ordered_json& one = json["axes"][device_axes()[i].key];
    one["from"] = device_axes()[static_cast<std::size_t>(std::clamp(axis.source, 0, 5))].key;
    one["inverted"] = axis.inverted;
    for (const Setting& setting : axis_settings()) add(one, axis, setting);
  }
  return json.dump(2) + '\n';
}

std::string device_settings_name(std::uint16_t vendor, std::uint16_t product,
                                 std::string_view serial) {
  std::string name = hex(vendor) + '-' + hex(product);
  if (!serial.empty()) name.append("-").append(serial);
  return as_file_name(name);
}

std::string device_settings_name(std::string_view profile_id) {
  return as_file_name(std::string(profile_id));
}

}  // namespace sonde
