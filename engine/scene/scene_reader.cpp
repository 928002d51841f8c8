// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/scene/scene_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>

#include "engine/queries/pose_numbers.hpp"
#include "engine/settings/device_settings_file.hpp"
#include "engine/settings/json_settings.hpp"
#include "engine/settings/settings.hpp"
#include "engine/text/file_unit.hpp"
#include "engine/text/number_text.hpp"

namespace sonde {
namespace {

using Keys = SceneReader::Keys;

constexpr int newest_format = 1;  // of scenes

/// A colour such as "#e97d25", as on web pages.
bool is_colour(const std::string& text) {
  constexpr std::size_t length = 7;
  return text.size() == length && text[0] == '#' &&
         text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
}

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

const Keys& body_keys() {
  static const Keys keys{"mesh", "model", "repair", "scale", "pose", "components"};
  return keys;
}

const Keys& part_keys() {
  static const Keys keys{"name",   "mesh",  "model", "repair",    "scale",     "pose",
                         "colour", "shown", "felt",  "component", "components"};
  return keys;
}

}  // namespace

Scene SceneReader::scene(const std::string& text) const {
  const JsonNode root = parse_json(file.string(), text);
  Scene scene;
  scene.format = format(root);  // first: a newer format may have unknown keys
  expect_object(root, scene_object_keys());
  scene.file = file;
  scene.name = name_of_scene(file);
  if (const JsonNode* given = root.find("$schema")) {
    expect(*given, Kind::string);
    scene.schema = given->text;
  }
  if (const JsonNode* given = root.find("unit")) scene.unit = unit(*given);
  scene.probe = body(need(root, "probe"), scene.unit);
  scene.fixed = body(need(root, "fixed"), scene.unit);
  scene.probe.offset = offset(root, scene.unit);
  if (const JsonNode* given = root.find("trajectory")) {
    scene.trajectory = path(*given);
    scene.trajectory_line = given->line;
  }
  if (const JsonNode* given = root.find("coupling")) scene.coupling = coupling_or_path(*given);
  if (const JsonNode* given = root.find("servo")) scene.servo = servo(*given);
  if (const JsonNode* given = root.find("device")) scene.device = device(*given);
  if (const JsonNode* given = root.find("view")) {
    expect(*given, Kind::object);
    scene.view = text.substr(given->begin, given->end - given->begin);
  }
  return scene;
}

void SceneReader::fail(std::size_t line, const std::string& reason) const {
  fail_at(file, line, reason);
}

std::optional<int> SceneReader::format(const JsonNode& root) const {
  expect(root, Kind::object);
  const JsonNode* format = root.find("format");
  if (!format) return std::nullopt;
  expect(*format, Kind::number);
  if (format->number > newest_format)
    fail(format->line, "\"format\" is " + number_text(format->number) +
                           ": the scene is of a newer format than this Sonde reads, which is " +
                           std::to_string(newest_format));
  if (format->number != newest_format)
    fail(format->line, "\"format\" is " + number_text(format->number) + "; there is only " +
                           std::to_string(newest_format));
  return newest_format;
}

std::filesystem::path SceneReader::path(const JsonNode& node) const {
  expect(node, Kind::string);
  if (node.text.empty()) fail(node.line, in_quotes(node.key) + " is an empty path");
  if (node.text.find('\0') != std::string::npos)
    fail(node.line, in_quotes(node.key) + " is a path with a null character");
  auto whole = (file.parent_path() / node.text).lexically_normal();
  if (within.empty() || lies_within(within, whole)) return whole;
  if (!outside)
    fail(node.line, in_quotes(node.key) + " leads out of the folder " + within.string() + ": " +
                        in_quotes(node.text));
  outside->push_back(whole);
  return whole;
}

Pose SceneReader::pose(const JsonNode& node, double unit) const {
  expect(node, Kind::array);
  if (node.children.size() != 7)
    fail(node.line, "\"pose\" has " + std::to_string(node.children.size()) +
                        " numbers; expected 7: px, py, pz, qw, qx, qy, qz");
  std::array<double, 7> numbers{};
  for (std::size_t i = 0; i < 7; ++i) {
    if (node.children[i].kind != Kind::number)
      fail(node.children[i].line,
           std::string("\"pose\" holds ") + name_of(node.children[i].kind) + "; expected numbers");
    numbers[i] = node.children[i].number * (i < 3 ? unit : 1);
  }
  try {
    return pose_of_numbers(numbers);
  } catch (const std::invalid_argument& error) {
    fail(node.line, error.what());
  }
}

SceneBody SceneReader::body(const JsonNode& node, double unit) const {
  if (node.kind != Kind::array) {
    SceneBody only = mesh(node, unit, body_keys());
    only.scene_file = file;
    return only;
  }
  if (node.children.empty()) fail(node.line, in_quotes(node.key) + " has no parts");
  if (node.children.size() > most_parts)
    fail(node.line, in_quotes(node.key) + " has " + std::to_string(node.children.size()) +
                        " parts; at most " + std::to_string(most_parts) + " are read");
  SceneBody whole;
  std::set<std::string> names;
  for (const JsonNode& part : node.children) {
    whole.parts.push_back(mesh(part, unit, part_keys()));
    read_part(part, whole.parts.back());
    const std::string name = part_name(whole.parts.back());
    if (!names.insert(name).second)
      fail(part.line,
           "two parts are named " + in_quotes(name) + ": give each a \"name\" of its own");
  }
  if (std::ranges::none_of(whole.parts, &SceneBody::felt))
    fail(node.line, "no part of " + in_quotes(node.key) + " is felt");
  whole.mesh = whole.parts.front().mesh;
  whole.mesh_line = whole.parts.front().mesh_line;
  whole.scene_file = file;
  return whole;
}

void SceneReader::read_part(const JsonNode& node, SceneBody& part) const {
  if (const JsonNode* name = node.find("name")) {
    expect(*name, Kind::string);
    if (name->text.empty()) fail(name->line, "\"name\" is empty");
    part.name = name->text;
  }
  if (const JsonNode* colour = node.find("colour")) {
    expect(*colour, Kind::string);
    if (!is_colour(colour->text))
      fail(colour->line, "\"colour\" is " + in_quotes(colour->text) +
                             "; it must be like \"#e97d25\": red, green and blue");
    part.colour = colour->text;
  }
  read_flag(node, "shown", part.shown);
  read_flag(node, "felt", part.felt);
  const JsonNode* component = node.find("component");
  if (!component) return;
  expect(*component, Kind::number);
  if (!(component->number >= 1 && component->number <= static_cast<double>(most_parts) &&
        component->number == std::floor(component->number)))
    fail(component->line, "\"component\" is " + number_text(component->number) +
                              "; it must be a whole number from 1 to " +
                              std::to_string(most_parts));
  if (part.components)
    fail(component->line,
         "\"component\" and \"components\" at once: the one asks for a single "
         "component of the mesh, the other for all of them");
  part.component = static_cast<std::size_t>(component->number);
}

void SceneReader::read_flag(const JsonNode& node, std::string_view key, bool& flag) const {
  const JsonNode* given = node.find(key);
  if (!given) return;
  expect(*given, Kind::boolean);
  flag = given->boolean;
}

SceneBody SceneReader::mesh(const JsonNode& node, double unit, const Keys& known) const {
  expect_object(node, known);
  SceneBody body;
  const JsonNode& from = need(node, "mesh");
  body.mesh = path(from);
  body.mesh_line = from.line;
  if (const JsonNode* model = node.find("model")) {
    expect(*model, Kind::string);
    body.model = choice(*model, model_named(model->text), {"auto", "solid", "surface"});
  }
  if (const JsonNode* repair = node.find("repair")) {
    expect(*repair, Kind::string);
    body.repair = choice(*repair, repair_named(repair->text), {"auto", "none"});
  }
  if (const JsonNode* scale = node.find("scale")) {
    expect(*scale, Kind::number);
    body.scale = scale->number;
    if (!(body.scale > 0))
      fail(scale->line, "\"scale\" is " + number_text(body.scale) + "; it must be above zero");
  }
  if (const JsonNode* given = node.find("pose")) body.pose = pose(*given, unit);
  read_flag(node, "components", body.components);
  return body;
}

double SceneReader::offset(const JsonNode& root, double unit) const {
  const JsonNode* allowance = root.find("allowance");
  const JsonNode* safety = root.find("safety");
  double offset = 0;
  for (const JsonNode* node : {allowance, safety}) {
    if (!node) continue;
    expect(*node, Kind::number);
    if (node->number < 0)
      fail(node->line, in_quotes(node->key) + " is " + number_text(node->number) +
                           "; it must be zero or more (\"allowance\" takes the probe smaller, "
                           "\"safety\" larger)");
    if (offset != 0 && node->number != 0)
      fail(node->line,
           "\"allowance\" and \"safety\" at once: the one takes the probe smaller, "
           "the other larger");
    if (node->number != 0) offset = node->number * (node == allowance ? -unit : unit);
  }
  return offset;
}

double SceneReader::unit(const JsonNode& node) const {
  expect(node, Kind::string);
  Keys known;
  for (const FileUnit& u : file_units()) known.push_back(u.name);
  return choice(node, unit_in_metres(node.text), known);
}

Coupling SceneReader::coupling_or_path(const JsonNode& node) const {
  if (node.kind != Kind::string) return coupling(node);
  const std::filesystem::path gains = path(node);
  if (outside) return {};
  expect_file(file, node.line, node.key, gains);
  return read_coupling(gains);
}

Coupling SceneReader::coupling(const JsonNode& node) const {
  Coupling coupling;
  expect_object(node, coupling_keys());
  if (const JsonNode* mode = node.find("mode"))
    coupling.mode = static_cast<Coupling::Mode>(read_choice(file, *mode, coupling_modes()));
  read_settings(file, node, coupling_settings(), coupling);
  return coupling;
}

ServoSettings SceneReader::servo(const JsonNode& node) const {
  ServoSettings servo;
  expect_object(node, keys_of(servo_settings()));
  read_settings(file, node, servo_settings(), servo);
  return servo;
}

std::string SceneReader::profile(const JsonNode& node) const {
  const std::filesystem::path whole = path(node);
  return node.text.ends_with(".json") ? whole.string() : node.text;
}

SceneDevice SceneReader::device(const JsonNode& node) const {
  if (node.kind == Kind::string) return {.profile = profile(node), .settings = {}};
  expect_object(node, device_keys());
  SceneDevice device;
  if (const JsonNode* given = node.find("profile")) device.profile = profile(*given);
  const bool nothing_else = node.children.size() == (device.profile.empty() ? 0U : 1U);
  if (!nothing_else) device.settings = device_settings_in(file, node);
  return device;
}

Coupling SceneReader::coupling(const std::string& text) const {
  return coupling(parse_json(file.string(), text));
}

std::vector<std::string> SceneReader::keys() {
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

}  // namespace sonde
