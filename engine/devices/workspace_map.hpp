// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/devices/axis_map.hpp"
#include "engine/haptics/coupling/coupling.hpp"

namespace sonde {

/// Maps the handle of a device that reports positions to the probe, and the wrench on the probe
/// back to the handle. Frames: B the device's base, H its handle, F the fixed body's mesh frame, C
/// the probe's centre of mass with the axes of its mesh frame. The handle's origin moves the centre
/// of mass, and the handle's rotation turns the probe about it:
///
///     p_FC = p_FC0 + R_FB A (p_BH - p_BH0)
///     R_FC = R_FB exp(M θ) R_FBᵀ R_FC0,   exp(θ) = R_BH R_BH0ᵀ
///
/// with the anchor, the pair of poses "0", chosen such that nothing jumps; A (scaling, gains,
/// swaps, signs) and M (the same for rotations, without the scaling) by rows of the axis map. An
/// axis whose source is of the other kind does not move; dead zones apply to deflections only.
///
/// The wrench is mapped by the transpose of the map of velocities, by the principle of virtual
/// work: the hand does exactly the work that is done on the probe. So with a scaling of s the hand
/// feels s² times the stiffness of the coupling (s times the force for 1/s of the displacement),
/// and a coupling that is passive at the probe is passive at the hand. No allocation anywhere.
class WorkspaceMap {
 public:
  /// Sets scaling, axes, and the orientation of the base. Does not move the anchor: call anchor()
  /// afterwards.
  void configure(const AxisMap& axes, double scaling, const Quat& q_FB) noexcept;
  /// From now on, this pose of the handle corresponds to this pose of the probe.
  void anchor(const Pose& X_BH, const Pose& X_FC) noexcept;
  /// X_FC. Beyond a quarter turn from the anchor, the handle drags the anchor along, so that no
  /// rotation becomes too large. With gains of 1 that changes nothing; with others the probe's
  /// rotation then depends on the hand's path. Neither the pose nor the wrench jumps.
  Pose follow(const Pose& X_BH) noexcept;
  /// The wrench on the handle, about its origin, in B, at the last pose; from the wrench about the
  /// probe's centre of mass, in F.
  DeviceWrench on_handle(const Wrench& wrench) const noexcept;
  /// The largest factor by which the map multiplies a velocity of the handle, in any direction, at
  /// the last pose.
  struct Ratios {
    double translation = 1;
    double rotation = 1;
  };
  Ratios largest_ratios() const noexcept;
  /// Whether the probe turns just as the handle does. Else a torque on the handle depends on the
  /// turn since the anchor, and jumps with a new one.
  bool turns_as_handle() const noexcept { return M_ == Mat3::Identity(); }

 private:
  /// Moves the anchor to a quarter turn about the axis (in B, unit) behind the present poses.
  void drag(const Vec3& axis, const Pose& X_BH, const Pose& X_FC) noexcept;

  Mat3 A_ = Mat3::Identity(), M_ = Mat3::Identity();
  Quat q_FB_ = Quat::Identity();
  Pose X_BH0_, X_FC0_;
  Mat3 spin_ = Mat3::Identity();  ///< from the handle's angular velocity to the probe's, both in B
};

}  // namespace sonde
