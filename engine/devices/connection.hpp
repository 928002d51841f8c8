// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/devices/device_settings.hpp"
#include "engine/devices/force_arm.hpp"
#include "engine/devices/force_device.hpp"
#include "engine/devices/hid_device.hpp"
#include "engine/devices/space_mouse.hpp"
#include "engine/devices/stick_controller.hpp"

namespace sonde {

enum class DeviceKind { space_mouse, force_device, arm, controller };
const char* name_of(DeviceKind kind);

/// The initial settings of a device of this kind. Sticks return to rest less exactly than pucks.
DeviceSettings usual_settings(DeviceKind kind);

/// The kind of the interface, by its ids and usages; none if it is not a 6-DoF device, or is
/// another interface of one.
std::optional<DeviceKind> kind_of(const HidInfo& info);

/// The device's name: by its ids, otherwise its own.
std::string name_of(const HidInfo& info);

/// An open device and its driver.
struct Connection {
  std::optional<HidDevice> hid;  ///< none for an arm
  std::variant<SpaceMouse, ForceDevice, ForceArm, StickController> driver;

  const DeviceCapabilities& capabilities() const;
};

/// Opens a device and verifies its kind. Throws InputError "PATH: reason", which names the program
/// that holds the device, if there is one.
Connection connect(const HidInfo& info);

/// A 6-DoF device, found without opening it.
struct ConnectedDevice {
  HidInfo info;
  DeviceKind kind = DeviceKind::space_mouse;
};
/// All connected devices; game controllers last, for use if there is nothing better.
std::vector<ConnectedDevice> connected_devices();

/// One connected device, and whether it can be used.
struct DeviceListing {
  HidInfo info;
  DeviceKind kind = DeviceKind::space_mouse;
  bool opens = false;
  std::string name{};                 ///< its own name, which an arm may report only when open
  std::string reason{};               ///< why it does not open
  std::string note{};                 ///< another program that may hold it
  DeviceCapabilities capabilities{};  ///< if it opens
};

/// All 6-DoF devices; each is opened and closed again.
std::vector<DeviceListing> list_devices();

}  // namespace sonde
