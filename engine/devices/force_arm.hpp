// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/devices/dhd_arm.hpp"
#include "engine/devices/force_device.hpp"
#include "engine/devices/hd_arm.hpp"
#include "engine/devices/hid_device.hpp"
#include "engine/devices/latency.hpp"

namespace sonde {

/// An arm that its maker's library drives. Its data is trusted no more than that of a force device:
/// see ForceDevice.
class ForceArm {
 public:
  /// "libdhd/0" (by the order of the system), "libHD/Default Device" (by its name in the maker's
  /// set-up). Throws InputError "PATH: reason", also where the library is missing or cannot be
  /// used.
  explicit ForceArm(const std::string& path);

  const ArmIdentity& identity() const { return identity_; }
  const DeviceCapabilities& capabilities() const { return identity_.capabilities; }
  /// Waits some milliseconds for a pose; none where the arm is gone: complaint() says why.
  std::optional<Heard> hear(DeviceSample& sample);
  const std::string& complaint() const { return complaint_; }
  /// Not `on`: no force. False where the library does not take it.
  bool write(const DeviceWrench& wrench, bool on);
  const Latency& latency() const { return latency_; }

 private:
  using Port = std::variant<std::unique_ptr<DhdArm>, std::unique_ptr<HdArm>>;
  Port port_;
  ArmIdentity identity_;
  ForceDevice check_;
  std::uint16_t sequence_ = 0;
  DeviceClock::time_point begin_ = DeviceClock::now();
  std::string complaint_;
  Latency latency_;
};

/// Returns whether a device's path is that of an arm, not of a node.
bool is_arm_path(const std::string& path);

/// Every arm that its maker's library reports; none where no library is installed. The arms of
/// Force Dimension are opened once for their names and serial numbers, whenever their number has
/// changed and none is in use. OpenHaptics knows arms only by name: those in the environment
/// variable SONDE_HD_DEVICES, separated by commas, else the default device alone. Each is listed
/// whether or not it is there.
std::vector<HidInfo> list_arms();

/// The makers' libraries, found or not.
std::vector<VendorLibraryListing> list_vendor_libraries();

}  // namespace sonde
