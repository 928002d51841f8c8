// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/settings/device_profile.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>

#include "engine/base/error.hpp"
#include "engine/text/json_checks.hpp"
#include "engine/text/nearest.hpp"
#include "engine/text/number_text.hpp"
#include "engine/text/text_file.hpp"

namespace sonde {
namespace {

using Kind = JsonNode::Kind;
using Path = std::filesystem::path;
using Profile = DeviceProfile;

constexpr std::size_t most_profile_bytes = 1 << 20;
constexpr std::string_view ending = ".json";

// The least mass and inertia keep the simulated device to numbers that make sense.
constexpr std::array<ProfileKey, 15> table{{
    {"max_force", "N", 0.01, 1000, "Largest force of the device.", &Profile::max_force},
    {"max_torque", "N·m", 0, 100, "Largest torque of the device; 0: it has no motors for torque.",
     &Profile::max_torque},
    {"max_stiffness", "N/m", 1, 1e6, "Largest stiffness its driver allows.",
     &Profile::max_stiffness},
    {"max_rotational_stiffness", "N·m/rad", 0, 1e4,
     "Largest rotational stiffness its driver allows.", &Profile::max_rotational_stiffness},
    {"max_damping", "N·s/m", 0, 1e4, "Largest virtual damping its driver allows.",
     &Profile::max_damping},
    {"max_rotational_damping", "N·m·s/rad", 0, 100,
     "Largest virtual rotational damping its driver allows.", &Profile::max_rotational_damping},
    {"mass", "kg", 1e-3, 100, "Apparent mass at the handle.", &Profile::mass},
    {"inertia", "kg·m²", 1e-8, 10, "Apparent inertia about the handle.", &Profile::inertia},
    {"damping", "N·s/m", 0, 1000, "Damping of the mechanism, at the handle.", &Profile::damping},
    {"rotational_damping", "N·m·s/rad", 0, 10,
     "Rotational damping of the mechanism, at the handle.", &Profile::rotational_damping},
    {"friction", "N", 0, 100, "Force that it takes to move the handle.", &Profile::friction},
    {"rotational_friction", "N·m", 0, 10, "Torque that it takes to turn the handle.",
     &Profile::rotational_friction},
    {"resolution", "m", 0, 0.01, "One step of the encoders, at the handle; 0: exact.",
     &Profile::resolution},
    {"rotational_resolution", "rad", 0, 0.1,
     "One step of the encoders of the handle's rotation; 0: exact.",
     &Profile::rotational_resolution},
    {"delay", "s", 0, 0.05, "Time from a sample of the pose to the motors.", &Profile::delay},
}};

// "$schema" is there for editors that complete and check.
std::vector<std::string_view> file_keys() {
  std::vector<std::string_view> keys{"$schema", "name"};
  for (const ProfileKey& key : table) keys.emplace_back(key.key);
  return keys;
}

std::string text_of(const Path& file, const JsonNode& node) {
  expect_kind(file, node, Kind::string);
  if (node.text.empty()) fail_at(file, node.line, in_quotes(node.key) + " is empty");
  return node.text;
}

/// Empty where the value is in its range.
std::string out_of_range(double value, const ProfileKey& key) {
  if (value >= key.minimum && value <= key.maximum) return "";
  return in_quotes(key.key) + " is " + number_text(value) + "; it must be between " +
         number_text(key.minimum) + " and " + number_text(key.maximum) + ' ' + key.unit;
}

/// Of a value or an end of its interval, the same.
void check_range(const Path& file, const JsonNode& number, const ProfileKey& key) {
  expect_kind(file, number, Kind::number);
  if (const std::string reason = out_of_range(number.number, key); !reason.empty())
    fail_at(file, number.line, reason);
}

std::optional<ProfileInterval> read_interval(const Path& file, const JsonNode& node,
                                             const ProfileKey& key, double value) {
  if (!node.find("low") && !node.find("high")) return {};
  const JsonNode& low = need_key(file, node, "low", "");
  const JsonNode& high = need_key(file, node, "high", "");
  check_range(file, low, key);
  check_range(file, high, key);
  if (!(low.number <= value && value <= high.number))
    fail_at(file, low.line, in_quotes(node.key) + " is not between its \"low\" and its \"high\"");
  return ProfileInterval{low.number, high.number};
}

ProfileValue read_value(const Path& file, const JsonNode& node, const ProfileKey& key) {
  static constexpr std::array<std::string_view, 5> known{"value", "low", "high", "source",
                                                         "assumed"};
  expect_keys(file, node, known);
  const JsonNode& number = need_key(file, node, "value", "");
  check_range(file, number, key);
  const JsonNode* source = node.find("source");
  const JsonNode* assumed = node.find("assumed");
  if (!source == !assumed)
    fail_at(file, node.line,
            in_quotes(key.key) +
                (source ? " has both a \"source\" and \"assumed\""
                        : " has neither a \"source\" nor \"assumed\"") +
                "; it needs one of them");
  return {number.number, text_of(file, source ? *source : *assumed), !source,
          read_interval(file, node, key, number.number)};
}

/// A file's name in an origin may be no UTF-8.
std::string json_text(const std::string& text) {
  using Json = nlohmann::json;
  return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::span<const ProfileKey> profile_keys() { return table; }

DeviceProfile read_device_profile(const Path& file) {
  const JsonNode root = parse_json(file.string(), read_text(file, most_profile_bytes));
  expect_keys(file, root, file_keys());
  if (const JsonNode* schema = root.find("$schema")) expect_kind(file, *schema, Kind::string);
  DeviceProfile profile;
  profile.id = file.stem().string();
  profile.name = text_of(file, need_key(file, root, "name", "the profile"));
  for (const ProfileKey& key : table)
    profile.*key.value = read_value(file, need_key(file, root, key.key, "the profile"), key);
  return profile;
}

std::string device_profile_text(const DeviceProfile& profile) {
  std::string text = "{\n  \"name\": " + json_text(profile.name);
  for (const ProfileKey& key : table) {
    const ProfileValue& value = profile.*key.value;
    const ProfileInterval interval =
        value.interval.value_or(ProfileInterval{value.value, value.value});
    for (const double each : {value.value, interval.low, interval.high})
      if (const std::string reason = out_of_range(each, key); !reason.empty())
        throw InputError(reason);
    text += ",\n  " + in_quotes(key.key) + ": {\"value\": " + number_text(value.value);
    if (value.interval)
      text += ", \"low\": " + number_text(value.interval->low) +
              ", \"high\": " + number_text(value.interval->high);
    text += value.assumed ? ", \"assumed\": " : ", \"source\": ";
    text += json_text(value.origin) + '}';
  }
  return text + "\n}\n";
}

std::vector<std::string> device_profile_ids(std::span<const Path> folders) {
  std::set<std::string> ids;
  for (const Path& folder : folders) {
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(folder, none))
      if (entry.path().extension() == ending) ids.insert(entry.path().stem().string());
  }
  return {ids.begin(), ids.end()};
}

DeviceProfile find_device_profile(std::string_view id_or_file, std::span<const Path> folders) {
  if (id_or_file.ends_with(ending)) return read_device_profile(id_or_file);
  // Of the ids there are, never a path made of what was typed.
  const std::vector<std::string> ids = device_profile_ids(folders);
  if (!std::ranges::binary_search(ids, id_or_file)) {
    const std::string none = "no device profile " + in_quotes(id_or_file);
    if (id_or_file.find('/') != std::string_view::npos)
      throw InputError(none + "; the name of a profile's file ends in \".json\"");
    if (ids.empty()) throw UnknownProfile(none + "; none was found at all");
    const std::vector<std::string_view> known(ids.begin(), ids.end());
    throw UnknownProfile(none + "; the nearest known one is " +
                         in_quotes(nearest(id_or_file, known)));
  }
  const std::string name = std::string(id_or_file).append(ending);
  const auto folder = std::ranges::find_if(
      folders, [&](const Path& each) { return std::filesystem::exists(each / name); });
  return read_device_profile((folder == folders.end() ? folders.front() : *folder) / name);
}

std::vector<std::string> assumed_keys(const DeviceProfile& profile) {
  std::vector<std::string> keys;
  for (const ProfileKey& key : table)
    if ((profile.*key.value).assumed) keys.emplace_back(key.key);
  return keys;
}

SimulatedDeviceParameters simulated(const DeviceProfile& profile) {
  SimulatedDeviceParameters p;
  p.translation.inertia = profile.mass.value;
  p.translation.damping = profile.damping.value;
  p.translation.friction = profile.friction.value;
  p.translation.resolution = profile.resolution.value;
  p.translation.limit = profile.max_force.value;
  p.rotation.inertia = profile.inertia.value;
  p.rotation.damping = profile.rotational_damping.value;
  p.rotation.friction = profile.rotational_friction.value;
  p.rotation.resolution = profile.rotational_resolution.value;
  p.rotation.limit = profile.max_torque.value;
  p.translation.most_virtual_damping = profile.max_damping.value;
  p.rotation.most_virtual_damping = profile.max_rotational_damping.value;
  p.translation.most_stiffness = profile.max_stiffness.value;
  p.rotation.most_stiffness = profile.max_rotational_stiffness.value;
  p.delay = profile.delay.value;
  return p;
}

}  // namespace sonde
