// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/pose.hpp"
#include "engine/haptics/hand/hand.hpp"

namespace sonde {

/// Speed above which a handle counts as thrown: accelerated away by the force of the loop. In m/s
/// and rad/s, at the hand; 0: no limit.
struct ThrownSpeed {
  double way = 0;
  double turn = 0;
};

/// The speed to which the device's whole force (torque) accelerates its handle's mass (inertia) in
/// the time over which Runaway averages; at least half of `most`, which a fast hand reaches by
/// itself, and at most `most`. An unknown mass is taken as that of a light arm.
ThrownSpeed thrown_speed(const DeviceTraits& device, const ThrownSpeed& most) noexcept;

/// Detects a loop that diverges, by its effect: it throws the hand. The force is limited to what
/// the device can give. So a loop that is slightly unstable only buzzes, which the user feels and
/// sees; this class does not react to it. But a loop whose force feeds the motion (a device that
/// reports a wrong pose, a gain far above the stable one) moves the handle faster than a user who
/// feels a contact moves the hand. In this case, the drivers of the devices' makers switch the
/// force off too.
///
/// A torque throws the handle as a force does, so displacement and turn each have a limit. The
/// velocities are averaged over some 20 ms, as vectors, so that oscillations, the grid of an
/// encoder and a device slower than the servo do not add up.
class Runaway {
 public:
  explicit Runaway(const ThrownSpeed& fastest) : fastest_(fastest) { restart(); }

  /// Sets the limit from the next sample on.
  void set_fastest(const ThrownSpeed& fastest) noexcept { fastest_ = fastest; }

  /// Call it for another hand or another scene.
  void restart() noexcept;
  /// Call it if the next sample is not continuous with the last. seen() keeps its value, because a
  /// thrown handle soon reaches a position at which its device is no longer trusted.
  void lose_track() noexcept;
  /// The displacement (m) and the turn (rad, a rotation vector) of the hand in the dt (s) since the
  /// last call, and whether a wrench acted on it.
  void observe(const Vec3& way, const Vec3& turn, double dt, bool pushed) noexcept;
  /// Call it while the probe is out of contact: a hand that is slow again then counts as held.
  void release() noexcept;
  /// True if the hand was too fast under a force, or just after one, and has not counted as held
  /// since (release()).
  bool seen() const noexcept { return seen_; }

 private:
  bool too_fast() const noexcept;

  ThrownSpeed fastest_;
  Vec3 velocity_ = Vec3::Zero();  ///< m/s, averaged
  Vec3 spin_ = Vec3::Zero();      ///< rad/s, averaged
  double unpushed_ = 0;           ///< s since the last force
  bool seen_ = false;
};

}  // namespace sonde
