// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/connection.hpp"

#include <algorithm>

#include "engine/base/error.hpp"
#include "engine/devices/device_owner.hpp"

namespace sonde {
namespace {

ForceDevice force_device_on(HidDevice& hid, const std::string& path) {
  if (const std::string fault = force_protocol::fault_of(hid.descriptor()); !fault.empty())
    throw InputError::in(path, fault);
  std::array<std::uint8_t, 256> buffer{force_protocol::limits_id};
  const auto report = hid.feature(buffer);
  if (!report) throw InputError::in(path, "it does not answer when asked for its limits");
  const auto limits = force_protocol::decode_limits(*report);
  if (!limits) throw InputError::in(path, "its limits report is not that of a force device");
  if (const std::string fault = force_protocol::fault_of(*limits); !fault.empty())
    throw InputError::in(path, fault);
  return ForceDevice(*limits);
}

SpaceMouse space_mouse_on(const HidDevice& hid, const HidInfo& info) {
  const bool known = space_mouse_name(info.vendor, info.product) != nullptr;
  if (!known && !space_mouse_layout(hid.descriptor()).axes)
    throw InputError::in(info.path, "its report descriptor does not name six axes");
  return SpaceMouse(hid.descriptor());
}

StickController controller_on(const HidDevice& hid, const HidInfo& info) {
  if (stick_layout(hid.descriptor()).empty())
    throw InputError::in(info.path,
                         "its report descriptor names neither six axes that spring back nor two "
                         "sticks");
  return StickController(hid.descriptor());
}

DeviceListing listing_of(const HidInfo& info, DeviceKind kind) {
  DeviceListing listing{.info = info, .kind = kind, .name = name_of(info)};
  try {
    const Connection connection = connect(info);
    listing.capabilities = connection.capabilities();
    listing.opens = true;
    if (const auto* arm = std::get_if<ForceArm>(&connection.driver))
      listing.name = arm->identity().name;
    listing.note = other_owner(info.path);
  } catch (const InputError& error) {
    listing.reason = error.what();
  }
  return listing;
}

}  // namespace

const char* name_of(DeviceKind kind) {
  switch (kind) {
    case DeviceKind::space_mouse:
      return "six-axis puck";
    case DeviceKind::force_device:
      return "force device";
    case DeviceKind::arm:
      return "force arm";
    case DeviceKind::controller:
      return "game controller";
  }
  return "";
}

DeviceSettings usual_settings(DeviceKind kind) {
  DeviceSettings settings;
  // The dead zone that Linux gives the axes of joysticks (hid-input.c): 1/16 of the whole range.
  constexpr double flat = 2. / 16;
  if (kind == DeviceKind::controller)
    for (AxisSetting& axis : settings.axes.axes) axis.dead_zone = flat;
  return settings;
}

std::optional<DeviceKind> kind_of(const HidInfo& info) {
  if (is_arm_path(info.path)) return DeviceKind::arm;
  if (info.has(force_protocol::usage)) return DeviceKind::force_device;
  if (is_plain_3dconnexion(info.vendor, info.product)) return {};
  if (info.has(multi_axis_controller)) return DeviceKind::space_mouse;
  if (info.has(joystick) || info.has(game_pad)) return DeviceKind::controller;
  // The descriptor of this interface could not be read; opening it will report the reason.
  const bool no_usage =
      std::ranges::all_of(info.usages, [](HidUsage usage) { return usage == HidUsage{}; });
  if (no_usage && space_mouse_name(info.vendor, info.product)) return DeviceKind::space_mouse;
  return {};
}

std::string name_of(const HidInfo& info) {
  if (const char* name = space_mouse_name(info.vendor, info.product)) return name;
  return info.name.empty() ? "unnamed device" : info.name;
}

const DeviceCapabilities& Connection::capabilities() const {
  return std::visit([](const auto& one) -> const DeviceCapabilities& { return one.capabilities(); },
                    driver);
}

Connection connect(const HidInfo& info) {
  if (is_arm_path(info.path)) return {.hid = {}, .driver = ForceArm(info.path)};
  try {
    HidDevice hid(info.path);
    if (kind_of(info) == DeviceKind::force_device) {
      ForceDevice device = force_device_on(hid, info.path);
      return {std::move(hid), std::move(device)};
    }
    if (kind_of(info) == DeviceKind::controller) {
      StickController controller = controller_on(hid, info);
      return {std::move(hid), std::move(controller)};
    }
    SpaceMouse mouse = space_mouse_on(hid, info);
    return {std::move(hid), std::move(mouse)};
  } catch (const InputError& error) {
    const std::string holder = other_owner(info.path);
    if (holder.empty()) throw;
    throw InputError(std::string(error.what()) + "; " + holder);
  }
}

std::vector<ConnectedDevice> connected_devices() {
  std::vector<ConnectedDevice> connected;
  std::vector<HidInfo> all = list_hid();
  for (HidInfo& arm : list_arms()) all.push_back(std::move(arm));
  for (const HidInfo& info : all)
    if (const auto kind = kind_of(info)) connected.push_back({info, *kind});
  std::stable_partition(  // not that of ranges, which clang 14 cannot compile
      connected.begin(), connected.end(),
      [](const ConnectedDevice& device) { return device.kind != DeviceKind::controller; });
  return connected;
}

std::vector<DeviceListing> list_devices() {
  std::vector<DeviceListing> listings;
  for (const ConnectedDevice& device : connected_devices())
    listings.push_back(listing_of(device.info, device.kind));
  return listings;
}

}  // namespace sonde
