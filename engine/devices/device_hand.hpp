// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>

#include "engine/base/triple_buffer.hpp"
#include "engine/devices/device_motion.hpp"
#include "engine/devices/input_device.hpp"

namespace sonde {

/// A connected device that holds the probe: its samples go through a DeviceMotion, and the wrench
/// goes back to it.
class DeviceHand {
 public:
  /// The probe is at X_FM; `com` is its centre of mass in its mesh frame.
  DeviceHand(std::shared_ptr<InputDevice> device, const DeviceSettings& settings, const Vec3& com,
             const Pose& X_FM);
  DeviceHand(const DeviceHand&) = delete;
  DeviceHand& operator=(const DeviceHand&) = delete;

  /// Functions for the servo; this object must outlive it.
  Hand hand();

  // To be called from one other thread; they act on the next tick.
  void set_settings(const DeviceSettings& settings) { settings_.write(settings); }
  /// See DeviceMotion.
  void set_profile(const std::optional<DeviceTraits>& at_handle) { profiles_.write(at_handle); }
  void set_view(const Quat& q_FV) { views_.write(q_FV); }
  void place(const Pose& X_FM) { places_.write(X_FM); }
  bool clutch_open() const { return clutch_open_.load(std::memory_order_relaxed); }

 private:
  HandSample sample(double dt) noexcept;
  void render(const Wrench& wrench) noexcept;

  std::shared_ptr<InputDevice> device_;
  DeviceMotion motion_;
  DeviceClock::time_point sampled_{};  ///< arrival of the sample of this tick
  TripleBuffer<DeviceSettings> settings_;
  TripleBuffer<std::optional<DeviceTraits>> profiles_;
  TripleBuffer<Quat> views_{Quat::Identity()};
  TripleBuffer<Pose> places_;
  std::atomic<bool> clutch_open_{false};
};

}  // namespace sonde
