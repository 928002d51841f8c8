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
  /// Throws InputError if it cannot be loaded, lacks a function, or has an unknown version: known
  /// are 3.3 to below 4; 3.3 is the first with the handle's axes under this name.
  explicit DhdLibrary(const std::filesystem::path& file);

  const dhd::Api& api() const { return api_; }
  const std::string& version() const { return version_; }
  int count() const;  ///< number of connected arms, including those in use

 private:
  dhd::Api api_{};
  std::string version_;
};

/// An open arm of Force Dimension; closes with the object, with its force off and its brakes on.
/// Only one thread may use it: the library keeps its errors per thread.
///
/// The library's frame has x towards the user, y to the right, z up; ours has x to the right, y
/// away from the user, z up. The velocity limit keeps its factory setting. Calibration is left to
/// the maker's program: it moves the arm by itself, which no program should do without being asked.
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
  /// Waits for the next millisecond, and reads the pose.
  ArmReading read();
  /// Returns false if the library refuses the wrench. If `on` is false: no force, but gravity
  /// compensation.
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
  /// Earliest time, after the controller switched the force off.
  DeviceClock::time_point force_again_{};
  bool force_enabled_ = false;
  int until_status_ = 0;  ///< readings
};

}  // namespace sonde
