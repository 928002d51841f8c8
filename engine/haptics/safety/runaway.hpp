// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/pose.hpp"

namespace sonde {

/// Sees a loop that diverges, by what it does: it throws the hand. A force is limited to what the
/// device can, so a loop that is unstable in the small only buzzes, which is felt and shown, and is
/// not this; but one whose force feeds the motion (a device that tells its pose wrong, a gain far
/// beyond the stable) takes the handle faster than a hand goes that feels something. The makers'
/// own drivers end the force in the same case.
///
/// A torque throws it as a force does: the way and the turn are watched each with its own limit.
/// The velocities are averaged over some 20 ms, as vectors: swings, the grid of an encoder and a
/// device slower than the servo do not add up.
class Runaway {
 public:
  /// Of the hand: m/s, and rad/s. 0: nothing is too fast.
  explicit Runaway(double fastest, double fastest_turn = 0)
      : fastest_(fastest), fastest_turn_(fastest_turn) {
    restart();
  }

  /// Another hand, or another scene.
  void restart() noexcept;
  /// What comes next is no neighbour of what was. What has been seen is not forgotten: a handle
  /// that is thrown is soon where its device is not to be trusted.
  void lose_track() noexcept;
  /// The way (m) and the turn (rad, a rotation vector) of the hand in the dt (s) since the last
  /// call; did a wrench act on it?
  void observe(const Vec3& way, const Vec3& turn, double dt, bool pushed) noexcept;
  /// Out of contact: a hand that is slow again is held.
  void release() noexcept;
  /// Too fast under a force, or just after it, and not held since.
  bool seen() const noexcept { return seen_; }

 private:
  bool too_fast() const noexcept;

  double fastest_, fastest_turn_;
  Vec3 velocity_ = Vec3::Zero();  ///< m/s, averaged
  Vec3 spin_ = Vec3::Zero();      ///< rad/s, averaged
  double unpushed_ = 0;           ///< s without a force
  bool seen_ = false;
};

}  // namespace sonde
