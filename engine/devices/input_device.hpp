// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "engine/devices/device_sample.hpp"
#include "engine/devices/latency.hpp"

namespace sonde {

/// Selects the device to open; zero or empty fields match any device.
struct DeviceChoice {
  std::uint16_t vendor = 0, product = 0;
  std::string serial{};
  /// Its node, such as /dev/hidraw3: exactly this device, even if there are others like it. After
  /// it has gone, its serial number identifies it; without one, the port that it was plugged into;
  /// and if no such device is there, the first matching device that was not there, on a port on
  /// which there was none, when it was opened: this is the same device, plugged in elsewhere.
  std::string path{};
  /// Its port, if it has no serial number.
  std::string port{};
};

/// The state of a device, for the user.
struct DeviceStatus {
  DeviceState state = DeviceState::absent;
  std::string reason;  ///< one line with the reason, if the state is not ready
  std::string name, path, port;
  DeviceCapabilities capabilities;
  std::uint64_t reports = 0;      ///< reports since the start
  std::uint64_t refused = 0;      ///< implausible reports among these
  std::uint64_t lost = 0;         ///< missing by the device's own count, in this connection
  std::uint32_t connections = 0;  ///< number of times it was opened
  /// From the arrival of a sample to when the device has the force that answers it, in this
  /// connection; for a device without force, to when the motion and the force were computed.
  LatencySummary latency;
  /// Static text: why the reading thread has ordinary priority, although it is in the force loop;
  /// "" if it has a higher one, or needs none.
  const char* scheduling = "";
  /// For a force device: what keeps the processors from deep sleep, or why nothing does.
  const char* wakefulness = "";
};

/// A 6-DoF device of any kind: pose or deflections in, wrench out. Its own thread searches for the
/// device about once a second, opens it, reads it, writes the wrench after each pose that it reads,
/// and searches again when the device has gone. Whatever a device does, at most its connection
/// ends.
///
/// The device gets no force unless its last report is fresh and plausible, and the wrench is less
/// than 50 ms old.
class InputDevice {
 public:
  explicit InputDevice(DeviceChoice choice = {});
  ~InputDevice();  ///< switches the force off and closes the device
  InputDevice(const InputDevice&) = delete;
  InputDevice& operator=(const InputDevice&) = delete;

  // To be called from one thread, the servo's: no allocation, no lock, no throw.
  /// The newest sample as valid at `now`: old ones have no deflection and are not ready.
  DeviceSample latest(DeviceClock::time_point now = DeviceClock::now()) noexcept;
  /// Sets the wrench, limited to what the device can give. A device without force ignores it.
  void set_wrench(const DeviceWrench& wrench,
                  DeviceClock::time_point now = DeviceClock::now()) noexcept;

  // To be called from any other thread.
  DeviceStatus status() const;
  void set_led(bool on);  ///< also applies after a reconnection

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sonde
