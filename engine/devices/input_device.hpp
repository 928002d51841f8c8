// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "engine/devices/device_sample.hpp"

namespace sonde {

/// Which device to open: what is zero or empty does not matter.
struct DeviceChoice {
  std::uint16_t vendor = 0, product = 0;
  std::string serial{};
  /// Its node, /dev/hidraw3: that very one, though others are like it. Where it has gone, it is
  /// known again by its serial number; where it tells none, the first that fits and was not there
  /// when it was opened is it, plugged in again.
  std::string path{};
};

/// How a device is doing, for people to read.
struct DeviceStatus {
  DeviceState state = DeviceState::absent;
  std::string reason;  ///< one line that says why, where the state is not ready
  std::string name, path;
  DeviceCapabilities capabilities;
  std::uint64_t reports = 0;      ///< heard, since the start
  std::uint64_t refused = 0;      ///< of these, could not be true
  std::uint64_t lost = 0;         ///< missing by the device's own count, in this connection
  std::uint32_t connections = 0;  ///< how often it was opened
  /// Static text: why the thread that reads it runs no sooner than ordinary ones, though it is in
  /// the loop of forces; "" where it does, or need not.
  const char* scheduling = "";
};

/// A 6-DoF device of whatever kind: pose or deflections in, wrench out. A thread of its own looks
/// for the device about once a second, opens it, reads it, writes the wrench after each pose it
/// reads, and looks again when it has gone. Nothing a device does ends more than its connection.
///
/// The device gets no force unless its last report is fresh and can be true, and the wrench is less
/// than 50 ms old.
class InputDevice {
 public:
  explicit InputDevice(DeviceChoice choice = {});
  ~InputDevice();  ///< switches the force off and closes the device
  InputDevice(const InputDevice&) = delete;
  InputDevice& operator=(const InputDevice&) = delete;

  // From one thread, the servo's: no allocation, no lock, no throw.
  /// The newest sample as it counts `now`: old ones hold no deflection and are not ready.
  DeviceSample latest(DeviceClock::time_point now = DeviceClock::now()) noexcept;
  /// Wanted from now on; limited to what the device can. Ignored by a device without force.
  void set_wrench(const DeviceWrench& wrench,
                  DeviceClock::time_point now = DeviceClock::now()) noexcept;

  // From any other thread.
  DeviceStatus status() const;
  void set_led(bool on);  ///< kept over a reconnection

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sonde
