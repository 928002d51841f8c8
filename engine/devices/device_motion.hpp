// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/devices/device_sample.hpp"
#include "engine/devices/device_settings.hpp"
#include "engine/devices/workspace_map.hpp"
#include "engine/haptics/hand/hand.hpp"

namespace sonde {

/// Moves the probe according to a device's samples: through the WorkspaceMap if the device reports
/// positions, otherwise by its deflections, which are mapped, smoothed, and used as a displacement
/// or a velocity.
///
/// The probe keeps its pose, to the bit, while the clutch button is held and while the device is
/// not trusted. Afterwards, as after a change of settings, view or connection, the device's present
/// pose corresponds to the probe's present pose. So no pose ever jumps. A change of axes or view
/// turns the force at the handle, so there is no force for one tick, after which it rises from
/// zero. A change of the scaling alone is told to the loop, which carries the force over. No
/// device, no clock; no allocation, lock, throw.
class DeviceMotion {
 public:
  /// com: the probe's centre of mass in its mesh frame M, about which it turns.
  DeviceMotion(const DeviceSettings& settings, const Vec3& com, const Pose& X_FM) noexcept;

  void set_settings(const DeviceSettings& settings) noexcept;
  /// q_FV: orientation of the picture (x right, y up, z towards the eye), for
  /// DeviceSettings::Frame::view.
  void set_view(const Quat& q_FV) noexcept;
  /// What its profile says of the handle; none: nothing is known of it. What the device itself
  /// says counts more.
  void set_profile(const std::optional<DeviceTraits>& at_handle) noexcept { profile_ = at_handle; }
  /// Puts the probe at another pose.
  void place(const Pose& X_FM) noexcept;

  /// dt: s since the last call; 0 for the first call or after a pause.
  HandSample move(const DeviceSample& sample, double dt) noexcept;
  bool clutch_open() const { return clutch_open_; }
  /// The wrench in the device's base, on the hand, about the handle's point; zero for deflections.
  DeviceWrench on_handle(const Wrench& wrench) const noexcept;

 private:
  void configure() noexcept;
  void deflect(const SixAxes& deflection, double dt) noexcept;
  void anchor(const DeviceSample& sample) noexcept;
  Reach reach() const noexcept;
  DeviceTraits traits(const DeviceSample& sample) const noexcept;
  SixAxes in_fixed_frame(const SixAxes& in_base) const noexcept;

  DeviceSettings settings_;
  std::optional<DeviceTraits> profile_;
  Vec3 com_;
  Quat q_FV_ = Quat::Identity();
  Quat q_FB_ = Quat::Identity();
  WorkspaceMap map_;
  Pose X_FC_;  ///< the probe's centre of mass, with the axes of its mesh frame
  Pose rest_;  ///< X_FC at zero deflection, for position control
  SixAxes deflection_ = SixAxes::Zero();  ///< mapped and smoothed, in B
  bool following_ = false;                ///< false: must be anchored first
  bool remapped_ = false;                 ///< since the last sample
  double rescaled_ = 1;                   ///< likewise, see HandSample
  bool position_ = false;                 ///< of the last sample
  bool clutch_open_ = false;
  std::uint32_t session_ = 0;
  std::uint64_t count_ = 0;  ///< of reports, at the last sample
  DeviceClock::time_point time_{};
};

}  // namespace sonde
