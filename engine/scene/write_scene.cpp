// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/scene/write_scene.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "engine/base/error.hpp"
#include "engine/queries/pose_numbers.hpp"
#include "engine/settings/device_settings_file.hpp"
#include "engine/settings/settings.hpp"
#include "engine/text/file_unit.hpp"
#include "engine/text/number_text.hpp"
#include "engine/text/output_file.hpp"

namespace sonde {
namespace {

namespace fs = std::filesystem;

constexpr double step = std::numeric_limits<double>::epsilon();

/// The shortest number whose product with the unit is exactly that length; there may be none.
double in_unit(double length, double unit) {
  const double nearest = length / unit;
  if (nearest == 0) return nearest;  // with its sign
  double best = nearest;
  std::size_t shortest = std::numeric_limits<std::size_t>::max();
  for (int i = -2; i <= 2; ++i) {
    const double number = nearest + i * step * std::abs(nearest);
    const std::size_t digits = number_text(number).size();
    if (number * unit != length || digits >= shortest) continue;
    best = number;
    shortest = digits;
  }
  return best;
}

/// Readers of JSON take "-0" as an integer, whose zero has no sign.
std::string json_number(double value) {
  const std::string text = number_text(value);
  return text == "-0" ? "-0.0" : text;
}

/// Numbers that the reader's normalisation converts to that unit quaternion, to the bit.
/// Normalisation is not idempotent: a quaternion that was read may differ in the last bit from the
/// normalisation of its own numbers, and of all numbers near these. So these are tried first, then
/// multiples far from them.
std::array<double, 4> before_normalisation(const Quat& q) {
  constexpr int near = 64, most = 4000;
  constexpr double furthest = 1e-4, golden = 0.6180339887498949;
  for (int i = 0; i < most; ++i) {
    const double steps = i % 2 == 0 ? -(i / 2) : i / 2 + 1;
    const double spread = 2 * (golden * i - std::floor(golden * i)) - 1;
    const double factor = 1 + (i < near ? step * steps : furthest * spread);
    const std::array<double, 7> n{
        0, 0, 0, q.w() * factor, q.x() * factor, q.y() * factor, q.z() * factor};
    if (pose_of_numbers(n).q.coeffs() == q.coeffs()) return {n[3], n[4], n[5], n[6]};
  }
  return {q.w(), q.x(), q.y(), q.z()};
}

std::string pose_text(const Pose& pose, double unit) {
  std::string text = "[";
  for (const double length : pose.p) text += json_number(in_unit(length, unit)) + ", ";
  const std::array<double, 4> q = before_normalisation(pose.q);
  for (std::size_t i = 0; i < q.size(); ++i)
    text += json_number(q.at(i)) + (i + 1 < q.size() ? ", " : "]");
  return text;
}

std::string quoted(const std::string& text) {
  try {
    return nlohmann::json(text).dump();
  } catch (const nlohmann::json::type_error&) {
    throw InputError::in(text, "the name is no UTF-8, so that no scene can hold it");
  }
}

/// Uses only the names, as the reader does to restore the path.
std::string path_text(const fs::path& file, const fs::path& folder) {
  const fs::path whole = fs::absolute(file).lexically_normal();
  const fs::path relative = whole.lexically_relative(fs::absolute(folder).lexically_normal());
  return quoted(relative.empty() ? whole.string() : relative.string());
}

std::string mesh_text(const SceneBody& body, double unit, const fs::path& folder) {
  std::string text = "{\n    ";
  if (!body.name.empty()) text += "\"name\": " + quoted(body.name) + ",\n    ";
  text += "\"mesh\": " + path_text(body.mesh, folder) +
          ",\n    \"model\": " + quoted(name_of(body.model));
  if (body.component != 0) text += ",\n    \"component\": " + std::to_string(body.component);
  if (body.components) text += ",\n    \"components\": true";
  if (body.repair != Repair::automatic)
    text += ",\n    \"repair\": " + quoted(name_of(body.repair));
  if (body.scale != 1) text += ",\n    \"scale\": " + number_text(body.scale);
  text += ",\n    \"pose\": " + pose_text(body.pose, unit);
  if (!body.colour.empty()) text += ",\n    \"colour\": " + quoted(body.colour);
  if (!body.shown) text += ",\n    \"shown\": false";
  if (!body.felt) text += ",\n    \"felt\": false";
  return text + "\n  }";
}

/// The text of a list of parts includes the scale, the pose and the repair of the whole.
std::string body_text(const SceneBody& body, double unit, const fs::path& folder) {
  if (body.parts.empty()) return mesh_text(body, unit, folder);
  std::string text;
  for (SceneBody part : body.parts) {
    part.scale *= body.scale;
    part.pose.p *= body.scale;
    part.pose = body.pose * part.pose;
    if (body.repair != Repair::automatic) part.repair = body.repair;
    text += (text.empty() ? "[" : ", ") + mesh_text(part, unit, folder);
  }
  return text + "]";
}

std::string coupling_text(const Coupling& coupling) {
  std::string text = "{\n    \"mode\": " + quoted(name_of(coupling.mode));
  for (const Setting& setting : coupling_settings())
    text += ",\n    " + quoted(setting.key) + ": " + json_number(get(coupling, setting.key));
  return text + "\n  }";
}

/// The settings that differ from the defaults of a scene; empty if there are none.
std::string servo_text(const ServoSettings& servo) {
  std::string text;
  const ServoSettings defaults;
  for (const Setting& setting : servo_settings()) {
    const double value = get(servo, setting.key);
    if (value == get(defaults, setting.key)) continue;
    text += (text.empty() ? "{\n    " : ",\n    ") + quoted(setting.key) + ": " +
            (setting.integer ? std::to_string(std::lround(value)) : json_number(value));
  }
  return text.empty() ? text : text + "\n  }";
}

std::string indented(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '\n' ? std::string("\n  ") : std::string(1, c);
  return out;
}

std::string device_text(const SceneDevice& device, const fs::path& folder) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  if (!device.profile.empty()) {
    const bool is_path = device.profile.ends_with(".json");
    json["profile"] =
        nlohmann::json::parse(is_path ? path_text(device.profile, folder) : quoted(device.profile));
  }
  if (device.settings) {
    auto settings = nlohmann::ordered_json::parse(device_settings_text(*device.settings));
    settings.erase("servo");  // a scene has its own servo settings
    json.update(settings);
  }
  return json.empty() ? std::string() : indented(json.dump(2));
}

}  // namespace

std::string scene_text(const Scene& scene, const fs::path& folder) {
  const std::optional<std::string> unit = unit_name(scene.unit);
  if (!unit) throw std::invalid_argument("no unit of a scene is " + number_text(scene.unit) + " m");
  std::string text = "{\n";
  const auto add = [&text](const char* key, const std::string& value) {
    if (value.empty()) return;
    if (text.size() > 2) text += ",\n";
    text.append("  \"").append(key).append("\": ").append(value);
  };
  if (!scene.schema.empty()) add("$schema", quoted(scene.schema));
  if (scene.format) add("format", std::to_string(*scene.format));
  add("unit", quoted(*unit));
  add("probe", body_text(scene.probe, scene.unit, folder));
  add("fixed", body_text(scene.fixed, scene.unit, folder));
  if (const double offset = scene.probe.offset; offset != 0)
    add(offset < 0 ? "allowance" : "safety", number_text(in_unit(std::abs(offset), scene.unit)));
  if (scene.trajectory) add("trajectory", path_text(*scene.trajectory, folder));
  add("coupling", coupling_text(scene.coupling));
  add("servo", servo_text(scene.servo));
  add("device", device_text(scene.device, folder));
  if (scene.view != "{}") add("view", scene.view);
  return text + "\n}\n";
}

void write_scene(const Scene& scene, const fs::path& file) {
  write_whole(file, scene_text(scene, fs::absolute(file).parent_path()));
}

Pose storable(const Pose& pose, double unit) {
  constexpr int digits = 12;
  Pose stored = pose;
  for (double& length : stored.p)
    length = parse_number(number_text(length / unit, digits)).value_or(0) * unit;
  stored.q.normalize();
  return stored;
}

}  // namespace sonde
