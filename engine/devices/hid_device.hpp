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

/// One interface of a connected HID device, as found without opening it.
struct HidInfo {
  std::string path;  ///< what it is opened by: /dev/hidraw3
  std::uint16_t vendor = 0, product = 0;
  std::string maker, name, serial;  ///< UTF-8; empty where the device tells none
  int interface = -1;
  std::vector<HidUsage> usages;  ///< of its top-level collections
  /// The place where it is plugged in, which stays the same: "usb-0000:00:14.0-2/input0"; empty
  /// where the system tells none.
  std::string port{};
  bool has(HidUsage usage) const;
};

/// All connected interfaces, each path once, in the order of the paths.
std::vector<HidInfo> list_hid();

/// The file that lets the user at the screen open the devices; messages name it where permission is
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

  /// Waits for a report and returns its part of `buffer`, its id first where the device numbers its
  /// reports; empty after the timeout; none where the device is gone. No allocation.
  std::optional<std::span<const std::uint8_t>> read(std::span<std::uint8_t> buffer,
                                                    std::chrono::milliseconds timeout) noexcept;
  /// Writes a report; the id (0 without ids) first. False where the device did not accept it.
  bool write(std::span<const std::uint8_t> report) noexcept;
  /// The id in buffer[0]; its part of `buffer`, the id first; none where that fails.
  std::optional<std::span<const std::uint8_t>> feature(std::span<std::uint8_t> buffer) noexcept;

 private:
  struct Close {
    void operator()(hid_device_* device) const noexcept;
  };
  HidReportDescriptor descriptor_;
  std::unique_ptr<hid_device_, Close> device_;
};

}  // namespace sonde
