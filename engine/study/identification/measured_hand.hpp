// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <variant>

#include "engine/devices/input_device.hpp"
#include "engine/haptics/hand/hand.hpp"
#include "engine/study/identification/pulse_player.hpp"
#include "engine/study/identification/released_device.hpp"

namespace sonde {

/// A force device while pulses measure it: nobody holds its handle, and the probe stays in place.
/// The times of the recording are those of the servo's ticks; for a simulated device, which counts
/// in ticks, they are nominal.
class MeasuredHand {
 public:
  /// A connected device. X_FM: the probe.
  MeasuredHand(std::shared_ptr<InputDevice> device, const PulsePlan& plan,
               const PulseBounds& bounds, const Pose& X_FM);
  /// A simulated device, without its hand. Throws as SimulatedDevice does.
  MeasuredHand(const SimulatedDeviceParameters& device, const PulsePlan& plan,
               const PulseBounds& bounds, const Pose& X_FM);
  MeasuredHand(const MeasuredHand&) = delete;
  MeasuredHand& operator=(const MeasuredHand&) = delete;

  /// Functions for the servo; this object must outlive it.
  const Hand& hand() const { return hand_; }
  PulsePlayer& pulses() { return pulses_; }

 private:
  using Device = std::variant<std::shared_ptr<InputDevice>, ReleasedDevice>;
  MeasuredHand(Device device, const PulsePlan& plan, const PulseBounds& bounds, const Pose& X_FM);
  HandSample sample(double dt) noexcept;
  HandSample asked(const Pose& X_BH, bool trusted) noexcept;
  void render(const Wrench& wrench) noexcept;

  Device device_;
  double sample_time_;  ///< s, nominal
  PulsePlayer pulses_;
  Pose X_FM_;
  double t_ = 0;                       ///< s, of the present tick
  bool begun_ = false;                 ///< there was a tick before this one
  Wrench command_;                     ///< on its way to the simulated motors
  std::uint32_t session_ = 0;          ///< of the connected device, at the first tick
  DeviceClock::time_point sampled_{};  ///< arrival of the sample of this tick
  Hand hand_;
};

}  // namespace sonde
