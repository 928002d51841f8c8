// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "engine/devices/device_sample.hpp"
#include "engine/devices/latency.hpp"

namespace sonde {

/// Selects the device to open; zero or empty fields match any.
struct DeviceChoice {
  std::uint16_t vendor = 0, product = 0;
  std::string serial{};
  /// Its node, /dev/hidraw3: exactly that one, though others are like it. After it has gone, its
  /// serial number identifies it; if it has none, the port that it was plugged into; and if nothing
  /// that matches is there, the first matching device that was not there, on a port that none was
  /// on, when it was opened: the same device, plugged in elsewhere.
  std::string path{};
  /// Its port, where it has no serial number.
  std::string port{};
};

/// The state of a device, for the user.
struct DeviceStatus {
  DeviceState state = DeviceState::absent;
  std::string reason;  ///< one line that says why, where the state is not ready
  std::string name, path, port;
  DeviceCapabilities capabilities;
  std::uint64_t reports = 0;      ///< reports since the start
  std::uint64_t refused = 0;      ///< implausible reports among these
  std::uint64_t lost = 0;         ///< missing by the device's own count, in this connection
  std::uint32_t connections = 0;  ///< how often it was opened
  /// From the arrival of a sample to when the device has the force that answers it, in this
  /// connection; of a device without force, to when the motion and the force were computed.
  LatencySummary latency;
  /// Static text: why the thread that reads it has ordinary priority, though it is in the loop of
  /// forces; "" where it has a higher one, or needs none.
  const char* scheduling = "";
  /// Of a force device: what keeps the processors from sleeping deeply, or why nothing does.
  const char* wakefulness = "";
};

/// A 6-DoF device of any kind: pose or deflections in, wrench out. Its own thread looks for the
/// device about once a second, opens it, reads it, writes the wrench after each pose that it reads,
/// and looks again when the device has gone. Nothing that a device does ends more than its
/// connection.
///
/// The device gets no force unless its last report is fresh and plausible, and the wrench is less
/// than 50 ms old.
class InputDevice {
 public:
  explicit InputDevice(DeviceChoice choice = {});
  ~InputDevice();  ///< switches the force off and closes the device
  InputDevice(const InputDevice&) = delete;
  InputDevice& operator=(const InputDevice&) = delete;

  // From one thread, the servo's: no allocation, no lock, no throw.
  /// The newest sample as it counts at `now`: old ones have no deflection and are not ready.
  DeviceSample latest(DeviceClock::time_point now = DeviceClock::now()) noexcept;
  /// Sets the wrench, limited to what the device can. A device without force ignores it.
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
