// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/devices/hid_report_descriptor.hpp"

struct hid_device_;  // hidapi's

namespace sonde {

/// One interface of a connected HID device, found without opening it.
struct HidInfo {
  std::string path;  ///< its device node, such as /dev/hidraw3
  std::uint16_t vendor = 0, product = 0;
  std::string maker, name, serial;  ///< UTF-8; empty if the device reports none
  int interface = -1;
  std::vector<HidUsage> usages;  ///< of its top-level collections
  /// The place where it is plugged in, which does not change: "usb-0000:00:14.0-2/input0"; empty if
  /// the system reports none.
  std::string port{};
  bool has(HidUsage usage) const;
};

/// False where Sonde was built without hidapi: then no device is listed, and none opens.
bool speaks_hid() noexcept;
/// A line that says so to who looks for devices; empty if it does.
std::string without_hid(bool speaks = speaks_hid());

/// All connected interfaces, each path once, ordered by path.
std::vector<HidInfo> list_hid();

/// The file that permits the logged-in user to open the devices; messages name it if permission is
/// missing.
inline constexpr const char* udev_rule_file = "70-sonde-devices.rules";

/// The meaning of a failed open with this errno, and the remedy.
std::string open_failure(int error);

/// An open HID device; closes with the object. One thread uses it.
class HidDevice {
 public:
  /// Throws InputError "PATH: reason".
  explicit HidDevice(const std::string& path);

  const HidReportDescriptor& descriptor() const { return descriptor_; }

  /// Waits for a report and returns its part of `buffer`, beginning with its id if the device
  /// numbers its reports; empty after the timeout; no value if the device is gone. No allocation.
  std::optional<std::span<const std::uint8_t>> read(std::span<std::uint8_t> buffer,
                                                    std::chrono::milliseconds timeout) noexcept;
  /// Writes a report that begins with its id (0 without ids). Returns false if the device did not
  /// accept it.
  bool write(std::span<const std::uint8_t> report) noexcept;
  /// Reads the feature report whose id is in buffer[0]. Returns its part of `buffer`, the id first;
  /// no value if that fails.
  std::optional<std::span<const std::uint8_t>> feature(std::span<std::uint8_t> buffer) noexcept;

 private:
  struct Close {
    void operator()(hid_device_* device) const noexcept;
  };
  HidReportDescriptor descriptor_;
  std::unique_ptr<hid_device_, Close> device_;
};

}  // namespace sonde
