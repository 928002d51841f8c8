// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <semaphore>
#include <string>

#include "engine/base/triple_buffer.hpp"
#include "engine/devices/arm_reading.hpp"
#include "engine/devices/hd_api.hpp"
#include "engine/devices/vendor_library.hpp"

namespace sonde {

/// OpenHaptics' HD library, loaded.
class HdLibrary {
 public:
  static const VendorLibraryName& name();
  /// Throws InputError where it cannot be loaded or lacks a function.
  explicit HdLibrary(const std::filesystem::path& file);

  const hd::Api& api() const { return api_; }
  /// Its version, which some report only with a device; empty where it reports none.
  const std::string& version() const { return version_; }

 private:
  hd::Api api_{};
  std::string version_;
};

/// An open arm of 3D Systems'; closes with the object, its force off. One at a time in a program:
/// the scheduler is one for all.
///
/// The library calls back at 1 kHz, in a thread of its own, which alone touches the device: it
/// reads the pose, writes the newest wrench, and never allocates, locks or waits. A wrench that is
/// older than 50 ms counts as none there too.
///
/// The library's frame has x to the right, y up, z to the user; ours x to the right, y away from
/// the user, z up. Velocity limit, largest force and ramps of the library stay as they are.
class HdArm {
 public:
  /// Opens an arm by its name in the maker's configuration; "Default Device" is the default. Throws
  /// InputError "libHD/NAME: reason".
  HdArm(std::shared_ptr<const HdLibrary> library, const std::string& name);
  ~HdArm();
  HdArm(const HdArm&) = delete;
  HdArm& operator=(const HdArm&) = delete;

  const ArmIdentity& identity() const { return identity_; }
  /// Waits for the next pose, not longer than 5 ms.
  ArmReading read();
  bool write(const DeviceWrench& wrench, bool on);

 private:
  struct Raw {
    std::array<double, 16> transform{};
    int buttons = 0;
    unsigned calibration = hd::calibration_ok;
    std::uint64_t count = 0;
    DeviceClock::time_point time{};                 ///< of the frame
    DeviceClock::time_point answered{}, answers{};  ///< as in ArmReading
  };
  struct Wanted {
    std::array<double, 3> force{}, torque{};
    bool on = false;
    DeviceClock::time_point time{}, sampled{};
  };

  void identify(const std::string& path);
  void check(const std::string& path, const char* what) const;
  std::string words_of(unsigned error) const;
  static unsigned called_back(void* self) noexcept;
  void frame() noexcept;
  void calibrate() noexcept;
  unsigned errors() const noexcept;

  std::shared_ptr<const HdLibrary> library_;
  hd::Handle device_ = hd::no_handle;
  hd::SchedulerHandle scheduled_ = 0;
  bool six_ = false;  ///< it takes a torque
  int style_ = 0;     ///< of calibration
  ArmIdentity identity_;
  DeviceClock::time_point last_frame_{};
  Raw raw_;  ///< the scheduler thread's
  TripleBuffer<Raw> readings_;
  TripleBuffer<Wanted> wrenches_;
  std::atomic<unsigned> error_{hd::success};  ///< the first that was not read yet
  std::counting_semaphore<> heard_{0};
};

}  // namespace sonde
