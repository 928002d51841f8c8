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
  /// Throws InputError if it cannot be loaded or lacks a function.
  explicit HdLibrary(const std::filesystem::path& file);

  const hd::Api& api() const { return api_; }
  /// Its version, which some libraries report only with a device; empty if unknown.
  const std::string& version() const { return version_; }

 private:
  hd::Api api_{};
  std::string version_;
};

/// An open arm of 3D Systems; closes with the object, with its force off. A program can open only
/// one at a time: there is a single scheduler.
///
/// The library calls back at 1 kHz, in its own thread, which alone accesses the device: it reads
/// the pose, writes the newest wrench, and never allocates, locks or waits. There too, a wrench
/// older than 50 ms counts as none.
///
/// The library's frame has x to the right, y up, z towards the user; ours has x to the right, y
/// away from the user, z up. The library's velocity limit, largest force and ramps are not changed.
class HdArm {
 public:
  /// Opens an arm by its name in the maker's configuration; "Default Device" is the default. Throws
  /// InputError "libHD/NAME: reason".
  HdArm(std::shared_ptr<const HdLibrary> library, const std::string& name);
  ~HdArm();
  HdArm(const HdArm&) = delete;
  HdArm& operator=(const HdArm&) = delete;

  const ArmIdentity& identity() const { return identity_; }
  /// Waits for the next pose, at most 5 ms.
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
  double nominal(unsigned parameter, double most) const;
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
  Raw raw_;  ///< used by the scheduler's thread
  TripleBuffer<Raw> readings_;
  TripleBuffer<Wanted> wrenches_;
  std::atomic<unsigned> error_{hd::success};  ///< the first error that was not read yet
  std::counting_semaphore<> heard_{0};
};

}  // namespace sonde
