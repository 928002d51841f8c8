// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "engine/devices/connection.hpp"
#include "engine/devices/hid_device.hpp"
#include "engine/text/number_text.hpp"
#include "engine/text/printable.hpp"

namespace sonde::app {
namespace {

using Json = nlohmann::ordered_json;

std::string id_text(const HidInfo& info) {
  constexpr char digits[] = "0123456789abcdef";
  std::string text;
  for (const std::uint16_t id : {info.vendor, info.product})
    for (int shift = 12; shift >= 0; shift -= 4) text += digits[(id >> shift) & 15];
  return text.insert(4, ":");
}

std::string capabilities_text(const DeviceCapabilities& can) {
  const auto number = [](double value) { return number_text(value, 4); };
  std::string text = can.position ? "position" : "deflection";
  const std::string torque =
      can.max_torque > 0 ? " and " + number(can.max_torque) + " N·m" : ", no torque";
  if (can.force) text += ", force to " + number(can.max_force) + " N" + torque;
  if (can.max_stiffness > 0) text += ", stiff to " + number(can.max_stiffness) + " N/m";
  if (can.max_damping > 0) text += ", damped to " + number(can.max_damping) + " N·s/m";
  if (can.rate_hz > 0) text += ", " + number(can.rate_hz) + " Hz";
  if (can.buttons > 0) text += ", " + std::to_string(can.buttons) + " buttons";
  return text + (can.led ? ", light" : "");
}

const char* json_name_of(DeviceKind kind) {
  switch (kind) {
    case DeviceKind::space_mouse:
      return "space_mouse";
    case DeviceKind::force_device:
      return "force_device";
    case DeviceKind::arm:
      return "force_arm";
    case DeviceKind::controller:
      return "game_controller";
  }
  return "";
}

std::string library_text(const VendorLibraryListing& library) {
  const std::string head = library.name + " (" + library.maker + "): ";
  if (!library.usable) return head + printable(library.reason) + '\n';
  const std::string version = library.version.empty() ? "" : library.version + ", ";
  return head + printable(version + library.path) + '\n';
}

std::string devices_text(const std::vector<DeviceListing>& devices,
                         const std::vector<VendorLibraryListing>& libraries) {
  std::string text = devices.empty() ? "no 6-DoF device is connected\n" : "";
  text += without_hid();
  for (const DeviceListing& device : devices) {
    text += printable(device.info.path) + "  " + id_text(device.info) + "  " +
            printable(device.name) + " (" + name_of(device.kind) + ")\n";
    text += device.opens ? "  opens: " + capabilities_text(device.capabilities) + '\n'
                         : "  does not open: " + printable(device.reason) + '\n';
    if (!device.note.empty()) text += "  note: " + printable(device.note) + '\n';
  }
  text += "\nmakers' libraries and services for force arms\n";
  for (const VendorLibraryListing& library : libraries) text += "  " + library_text(library);
  return text;
}

Json json_of(const DeviceCapabilities& can) {
  Json json;
  json["position"] = can.position;
  json["force"] = can.force;
  json["max_force"] = can.max_force;
  json["max_torque"] = can.max_torque;
  json["max_stiffness"] = can.max_stiffness;
  json["max_damping"] = can.max_damping;
  json["reach"] = {can.reach.x(), can.reach.y(), can.reach.z()};
  json["rate_hz"] = can.rate_hz;
  json["buttons"] = can.buttons;
  json["led"] = can.led;
  return json;
}

Json text_or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json json_of(const VendorLibraryListing& library) {
  return {{"name", library.name},
          {"maker", library.maker},
          {"usable", library.usable},
          {"path", text_or_null(library.path)},
          {"version", text_or_null(library.version)},
          {"reason", text_or_null(library.reason)}};
}

std::string devices_json(const std::vector<DeviceListing>& devices,
                         const std::vector<VendorLibraryListing>& libraries) {
  Json json;
  json["format"] = 1;
  json["units"] = {{"max_force", "N"},       {"max_torque", "N*m"}, {"max_stiffness", "N/m"},
                   {"max_damping", "N*s/m"}, {"reach", "m"},        {"rate_hz", "Hz"}};
  json["devices"] = Json::array();
  for (const DeviceListing& device : devices) {
    Json one;
    one["path"] = device.info.path;
    one["id"] = id_text(device.info);
    one["name"] = device.name;
    one["serial"] = text_or_null(device.info.serial);
    one["kind"] = json_name_of(device.kind);
    one["opens"] = device.opens;
    one["reason"] = text_or_null(device.reason);
    one["note"] = text_or_null(device.note);
    one["capabilities"] = device.opens ? json_of(device.capabilities) : Json();
    json["devices"].push_back(one);
  }
  json["libraries"] = Json::array();
  for (const VendorLibraryListing& library : libraries)
    json["libraries"].push_back(json_of(library));
  // What a device says of itself may be no UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

void run(const OutputOptions& options) {
  check_output(options, {});
  const std::vector<DeviceListing> devices = list_devices();
  const std::vector<VendorLibraryListing> libraries = list_vendor_libraries();
  write_result(options,
               options.json ? devices_json(devices, libraries) : devices_text(devices, libraries));
}

}  // namespace

Command add_devices_command(CLI::App& program) {
  const auto options = std::make_shared<OutputOptions>();
  CLI::App* parser = program.add_subcommand(
      "devices", "6-DoF devices: what is connected, and whether it can be opened");
  add_flags(*parser, *options);
  parser->get_option("--json")->description("write JSON instead of text");
  return {parser, [options] { run(*options); }};
}

}  // namespace sonde::app
