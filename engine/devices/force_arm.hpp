// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/devices/dhd_arm.hpp"
#include "engine/devices/force_device.hpp"
#include "engine/devices/haply_arm.hpp"
#include "engine/devices/hd_arm.hpp"
#include "engine/devices/hid_device.hpp"
#include "engine/devices/latency.hpp"

namespace sonde {

/// An arm that its maker's library or service drives. Its data is trusted no more than that of a
/// force device: see ForceDevice.
class ForceArm {
 public:
  /// Opens "libdhd/0" (the index in the order of the system), "libHD/Default Device" (the name in
  /// the maker's set-up) or "haply/049D" (the id that the service gives). Throws InputError "PATH:
  /// reason", also if the library is missing or cannot be used, or the service does not run.
  explicit ForceArm(const std::string& path);

  const ArmIdentity& identity() const { return identity_; }
  const DeviceCapabilities& capabilities() const { return identity_.capabilities; }
  /// Waits some milliseconds for a pose; no value if the arm is gone: complaint() gives the reason.
  std::optional<Heard> hear(DeviceSample& sample);
  const std::string& complaint() const { return complaint_; }
  /// Waits until the arm may be told the next wrench: what is taken after this is the newest.
  void pace() const;
  /// If `on` is false: no force. Returns false if the library does not accept the wrench.
  bool write(const DeviceWrench& wrench, bool on);
  const Latency& latency() const { return latency_; }

 private:
  using Port =
      std::variant<std::unique_ptr<DhdArm>, std::unique_ptr<HdArm>, std::unique_ptr<HaplyArm>>;
  static Port opened(const std::string& path);

  Port port_;
  ArmIdentity identity_;
  ForceDevice check_;
  std::uint16_t sequence_ = 0;
  DeviceClock::time_point begin_ = DeviceClock::now();
  std::string complaint_;
  Latency latency_;
};

/// Whether a device's path is that of an arm, not of a device node.
bool is_arm_path(const std::string& path);

/// All arms that the makers' libraries and services report. Arms of Force
/// Dimension are opened once for their names and serial numbers, whenever their number has changed
/// and none is in use. OpenHaptics knows arms only by name: those in the environment variable
/// SONDE_HD_DEVICES, separated by commas, otherwise only the default device. Each is listed whether
/// it is connected or not. Haply's service is asked, unless one of its arms is in use.
std::vector<HidInfo> list_arms();

/// The makers' libraries and services, whether found or not.
std::vector<VendorLibraryListing> list_vendor_libraries();

}  // namespace sonde
