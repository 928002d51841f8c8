// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/scene/scene.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "engine/scene/scene_reader.hpp"
#include "engine/settings/device_settings_file.hpp"
#include "engine/settings/json_settings.hpp"
#include "engine/settings/settings.hpp"
#include "engine/text/file_unit.hpp"
#include "engine/text/json_checks.hpp"
#include "engine/text/located_json.hpp"
#include "engine/text/nearest.hpp"
#include "engine/text/number_text.hpp"
#include "engine/text/text_file.hpp"

namespace sonde {
namespace {

using Kind = JsonNode::Kind;
using Keys = std::vector<std::string_view>;

// For most_parts, in the form that the window writes.
constexpr std::size_t most_scene_bytes = 1 << 22;

// The keys of each object of a scene; "$schema" is for editors with completion and validation.
const Keys& scene_object_keys() {
  static const Keys keys{"$schema", "format",     "unit",     "probe",  "fixed", "allowance",
                         "safety",  "trajectory", "coupling", "device", "servo", "view"};
  return keys;
}
Keys coupling_keys() {
  Keys keys = keys_of(coupling_settings());
  keys.insert(keys.begin(), "mode");
  return keys;
}
/// A scene's `device` has the device settings, and may name a profile.
Keys device_keys() {
  Keys keys = device_settings_keys();
  keys.insert(keys.begin(), "profile");
  return keys;
}

void require_file(const std::filesystem::path& scene, std::size_t line, const std::string& key,
                  const std::filesystem::path& named) {
  std::error_code ignored;
  if (!std::filesystem::exists(named, ignored))
    fail_at(scene, line, in_quotes(key) + " names " + named.string() + ": no such file");
}

/// Reads the values of one scene.
struct Reader : SceneReader {
  double unit(const JsonNode& node) const {
    expect(node, Kind::string);
    Keys known;
    for (const FileUnit& u : file_units()) known.push_back(u.name);
    return choice(node, unit_in_metres(node.text), known);
  }

  /// The gains, or the path of a file that contains them.
  Coupling coupling_or_path(const JsonNode& node) const {
    if (node.kind != Kind::string) return coupling(node);
    const std::filesystem::path gains = path(node);
    if (outside) return {};
    require_file(file, node.line, node.key, gains);
    return read_coupling(gains);
  }
  Coupling coupling(const JsonNode& node) const {
    Coupling coupling;
    expect_object(node, coupling_keys());
    if (const JsonNode* mode = node.find("mode"))
      coupling.mode = static_cast<Coupling::Mode>(read_choice(file, *mode, coupling_modes()));
    read_settings(file, node, coupling_settings(), coupling);
    return coupling;
  }

  ServoSettings servo(const JsonNode& node) const {
    ServoSettings servo;
    expect_object(node, keys_of(servo_settings()));
    read_settings(file, node, servo_settings(), servo);
    return servo;
  }

  /// An id is kept unchanged; a text that ends in ".json" is a path like the others.
  std::string profile(const JsonNode& node) const {
    const std::filesystem::path whole = path(node);
    return node.text.ends_with(".json") ? whole.string() : node.text;
  }

  SceneDevice device(const JsonNode& node) const {
    if (node.kind == Kind::string) return {.profile = profile(node), .settings = {}};
    expect_object(node, device_keys());
    SceneDevice device;
    if (const JsonNode* given = node.find("profile")) device.profile = profile(*given);
    const bool nothing_else = node.children.size() == (device.profile.empty() ? 0U : 1U);
    if (!nothing_else) device.settings = device_settings_in(file, node);
    return device;
  }
};

Scene read(const Reader& reader, const std::string& text) {
  const JsonNode root = parse_json(reader.file.string(), text);
  Scene scene;
  scene.format = reader.format(root);  // first: a newer format may have unknown keys
  reader.expect_object(root, scene_object_keys());
  scene.file = reader.file;
  scene.name = name_of_scene(reader.file);
  if (const JsonNode* schema = root.find("$schema")) {
    reader.expect(*schema, Kind::string);
    scene.schema = schema->text;
  }
  if (const JsonNode* unit = root.find("unit")) scene.unit = reader.unit(*unit);
  scene.probe = reader.body(reader.need(root, "probe"), scene.unit);
  scene.fixed = reader.body(reader.need(root, "fixed"), scene.unit);
  scene.probe.offset = reader.offset(root, scene.unit);
  if (const JsonNode* path = root.find("trajectory")) {
    scene.trajectory = reader.path(*path);
    scene.trajectory_line = path->line;
  }
  if (const JsonNode* coupling = root.find("coupling"))
    scene.coupling = reader.coupling_or_path(*coupling);
  if (const JsonNode* servo = root.find("servo")) scene.servo = reader.servo(*servo);
  if (const JsonNode* device = root.find("device")) scene.device = reader.device(*device);
  if (const JsonNode* view = root.find("view")) {
    reader.expect(*view, Kind::object);
    scene.view = text.substr(view->begin, view->end - view->begin);
  }
  return scene;
}

}  // namespace

std::string name_of_scene(const std::filesystem::path& file) {
  std::string name = file.filename().string();
  for (const std::string_view ending : {".json", ".sonde"})
    if (name.ends_with(ending) && name.size() > ending.size())
      name.resize(name.size() - ending.size());
  return name;
}

Coupling read_coupling(const std::filesystem::path& file) {
  return Reader{{file}}.coupling(parse_json(file.string(), read_text(file, most_scene_bytes)));
}

Scene read_scene(const std::filesystem::path& file) {
  return scene_in(read_text(file, most_scene_bytes), file);
}

Scene read_scene_within(const std::filesystem::path& folder, const std::filesystem::path& file) {
  return read(Reader{{file, folder}}, read_text(file, most_scene_bytes));
}

std::vector<std::filesystem::path> paths_out_of(const std::filesystem::path& folder,
                                                const std::filesystem::path& file) {
  return paths_out_of(folder, read_text(file, most_scene_bytes), file);
}

std::vector<std::filesystem::path> paths_out_of(const std::filesystem::path& folder,
                                                const std::string& text,
                                                const std::filesystem::path& file) {
  std::vector<std::filesystem::path> out;
  read(Reader{{file, folder, &out}}, text);
  return out;
}

bool lies_within(const std::filesystem::path& folder, const std::filesystem::path& file) {
  std::error_code error;
  const auto whole = std::filesystem::weakly_canonical(file, error);
  if (error) return false;
  const auto below = whole.lexically_relative(std::filesystem::canonical(folder, error));
  return !error && !below.empty() && *below.begin() != "..";
}

Scene scene_in(const std::string& text, const std::filesystem::path& file) {
  return read(Reader{{file}}, text);
}

std::vector<std::string> scene_keys() {
  std::vector<std::string> all;
  const auto add = [&](std::string_view prefix, const Keys& keys) {
    for (const std::string_view key : keys) all.push_back(std::string(prefix) + std::string(key));
  };
  add("", scene_object_keys());
  add("probe.", body_keys());
  add("fixed.", body_keys());
  add("coupling.", coupling_keys());
  add("device.", device_keys());
  for (const Choice& axis : device_axes()) {
    const std::string name = std::string("device.axes.") + axis.key;
    all.push_back(name);
    add(name + '.', device_axis_keys());
  }
  add("servo.", keys_of(servo_settings()));
  return all;
}

void require_meshes(const Scene& scene) {
  for (const SceneBody* whole : {&scene.probe, &scene.fixed})
    for (const SceneBody& body : meshes_of(*whole))
      require_file(scene.file, body.mesh_line, "mesh", body.mesh);
}

void require_trajectory(const Scene& scene) {
  if (scene.trajectory && scene.trajectory_line > 0)
    require_file(scene.file, scene.trajectory_line, "trajectory", *scene.trajectory);
}

Pose relative_pose(const Scene& scene) { return inverse(scene.fixed.pose) * scene.probe.pose; }

}  // namespace sonde
