// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "engine/devices/arm_reading.hpp"
#include "engine/devices/dhd_api.hpp"
#include "engine/devices/vendor_library.hpp"

namespace sonde {

/// Force Dimension's library, loaded.
class DhdLibrary {
 public:
  static const VendorLibraryName& name();
  /// Throws InputError where it cannot be loaded, lacks a function, or is of a version that is not
  /// known: 3.3 to below 4 is, the first with the handle's axes under this name.
  explicit DhdLibrary(const std::filesystem::path& file);

  const dhd::Api& api() const { return api_; }
  const std::string& version() const { return version_; }
  int count() const;  ///< arms that are connected, those in use included

 private:
  dhd::Api api_{};
  std::string version_;
};

/// An open arm of Force Dimension's; closes with the object, its force off and its brakes on. One
/// thread uses it: the library keeps its errors by the thread.
///
/// The library's frame has x towards the user, y to the right, z up; ours x to the right, y away
/// from the user, z up. The velocity limit is left as the factory set it. Calibration is left to
/// the maker's program: it moves the arm by itself, which no program should do unasked.
class DhdArm {
 public:
  /// Opens an arm by its index in the order of the system, from 0. Throws InputError "libdhd/INDEX:
  /// reason".
  DhdArm(std::shared_ptr<const DhdLibrary> library, int index);
  ~DhdArm();
  DhdArm(const DhdArm&) = delete;
  DhdArm& operator=(const DhdArm&) = delete;

  /// The number of arms that this program has open.
  static int open();
  const ArmIdentity& identity() const { return identity_; }
  /// Waits for the next millisecond, and asks for the pose.
  ArmReading read();
  /// False where the library refuses it. Not `on`: no force, but gravity compensation.
  bool write(const DeviceWrench& wrench, bool on);

 private:
  ArmReading pose() const;
  ArmReading failure() const;
  ArmReading checked_status();

  std::shared_ptr<const DhdLibrary> library_;
  char id_ = -1;
  bool wrist_ = false;
  ArmIdentity identity_;
  DeviceClock::time_point next_{};
  DeviceClock::time_point force_again_{};  ///< not before, after the controller switched it off
  bool force_enabled_ = false;
  int until_status_ = 0;  ///< readings
};

}  // namespace sonde
