// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/haply_protocol.hpp"

#include <nlohmann/json.hpp>

namespace sonde::haply {
namespace {

using Json = nlohmann::json;

/// Reads a message; remembers whether something had the wrong type.
class Reader {
 public:
  bool wrong() const { return wrong_; }

  /// Null where it is missing; a null of JSON counts as missing.
  static const Json* part(const Json* json, const char* key) {
    if (!json || !json->is_object()) return nullptr;
    const auto found = json->find(key);
    return found == json->end() || found->is_null() ? nullptr : &*found;
  }

  double number(const Json* json) {
    if (json && json->is_number()) return json->get<double>();
    wrong_ = true;
    return 0;
  }
  std::string text(const Json* json) {
    if (json && json->is_string()) return json->get<std::string>();
    wrong_ = true;
    return "";
  }
  std::optional<bool> flag(const Json* json) {
    if (!json) return {};
    if (json->is_boolean()) return json->get<bool>();
    wrong_ = true;
    return {};
  }
  std::optional<Vec3> vector(const Json* json) {
    if (!json) return {};
    const double x = number(part(json, "x")), y = number(part(json, "y"));
    return Vec3(x, y, number(part(json, "z")));
  }
  std::optional<Quat> quaternion(const Json* json) {
    if (!json) return {};
    const double w = number(part(json, "w")), x = number(part(json, "x"));
    const double y = number(part(json, "y")), z = number(part(json, "z"));
    return Quat(w, x, y, z);
  }
  /// Whether the transform has a scale other than 1.
  std::optional<bool> scaled(const Json* transform) {
    constexpr double rounding = 1e-6;
    const std::optional<Vec3> scale = vector(part(transform, "scale"));
    if (!scale) return {};
    return !((*scale - Vec3::Ones()).cwiseAbs().maxCoeff() <= rounding);
  }

  template <class Device>
  void read_all(const Json& message, const char* key, std::vector<Device>& devices) {
    const Json* const list = part(&message, key);
    if (!list) return;
    if (!list->is_array()) wrong_ = true;
    if (!wrong_)
      for (const Json& one : *list) devices.push_back(read(one, Device{}));
  }

 private:
  Arm read(const Json& json, Arm arm) {
    const Json* const config = part(&json, "config");
    const Json* const state = part(&json, "state");
    const Json* const status = part(&json, "status");
    arm.id = text(part(&json, "device_id"));
    if (const Json* type = part(config, "type")) arm.model = text(type);
    if (const Json* basis = part(part(config, "basis"), "permutation")) arm.basis = text(basis);
    arm.position = vector(part(state, "cursor_position"));
    arm.calibrated = flag(part(status, "calibrated"));
    arm.powered = flag(part(status, "power_supply"));
    const Json* const mount = part(config, "mount");
    arm.mount_scaled = scaled(mount);
    if (!arm.mount_scaled) arm.mount_scaled = scaled(part(mount, "transform"));
    arm.place_scaled = scaled(part(state, "transform"));
    return arm;
  }

  Grip read(const Json& json, Grip grip) {
    const Json* const state = part(&json, "state");
    const Json* const status = part(&json, "status");
    grip.id = text(part(&json, "device_id"));
    grip.orientation = quaternion(part(state, "orientation"));
    for (const char* key : {"connected", "awake"})
      if (const std::optional<bool> there = flag(part(status, key)))
        grip.ready = grip.ready.value_or(true) && *there;
    grip.buttons = buttons(part(state, "buttons"));
    // One with a cable has a single one.
    if (flag(part(state, "button")).value_or(false)) grip.buttons |= 1;
    return grip;
  }

  /// In the order of their names: "a", "b", "c" and "button_0", "button_1" are numbered as printed.
  static std::uint32_t buttons(const Json* json) {
    std::uint32_t bits = 0;
    if (!json || !json->is_object()) return bits;
    unsigned bit = 0;
    for (const Json& pressed : *json) {
      if (bit == 16) break;
      if (pressed.is_boolean() && pressed.get<bool>()) bits |= 1U << bit;
      ++bit;
    }
    return bits;
  }

  bool wrong_ = false;
};

}  // namespace

std::optional<Message> decode(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return {};
  Reader reader;
  Message message;
  reader.read_all(json, "inverse3", message.arms);
  // The grip in the hand is the first; one without a cable is what the makers sell with the arm.
  for (const char* kind : {"wireless_verse_grip", "verse_grip", "custom_verse_grip"})
    reader.read_all(json, kind, message.grips);
  if (reader.wrong()) return {};
  return message;
}

std::string encode(const std::string& arm, const Command& command) {
  Json json;
  json["inverse3"] = Json::array();
  Json& device = json["inverse3"].emplace_back();
  device["device_id"] = arm;
  device["commands"]["set_cursor_force"]["values"] = {
      {"x", command.force.x()}, {"y", command.force.y()}, {"z", command.force.z()}};
  if (command.ask_everything) json["session"]["force_render_full_state"] = Json::object();
  if (command.set_basis) json["session"]["configure"]["basis"]["permutation"] = "XYZ";
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace sonde::haply
