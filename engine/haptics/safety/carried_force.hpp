// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/haptics/coupling/coupling.hpp"
#include "engine/haptics/safety/change_rate.hpp"

namespace sonde {

/// m/s: a handle that yields to a change of force at this speed gets hardly any more of that
/// change. A third of the speed at which causes other than the hand's own motion may move a handle.
inline constexpr double slow_enough = 0.03;

/// The share, 0.01 to 1, of its rate at which a force may change while the handle yields to it at
/// this speed, m/s.
double share_where_it_yields(double speed) noexcept;

/// The rate, N/s (or N·m/s), at which a force of that size ends that has no cause any more, if
/// forces change at `rate`. `along`: m/s, the handle's speed in its direction. It ends more slowly
/// while the hand presses, and within about 50 ms if it only pushes the handle along.
double rate_of_end(double size, double rate, double along) noexcept;

/// If a device's scaling changes during a contact, or a limit of the force falls, the force on the
/// hand would jump although the hand has not moved. This class carries the old force over: the
/// difference is added to the coupling's wrench, and decays to zero at the permitted rate of
/// change.
class CarriedForce {
 public:
  /// Carries nothing from now on: the contact or the force has ended.
  void restart() noexcept { more_ = Wrench{}; }
  /// From now on, the coupling's wrench is `now`, while the hand still feels `felt`; both in the
  /// new scale.
  void carry(const Wrench& felt, const Wrench& now) noexcept;
  /// The wrench for a tick of dt (s): `wanted` plus the rest that is carried, limited so that it
  /// never points against `wanted`. `velocity`: of the hand, m/s, in the frame of the force.
  Wrench added_to(const Wrench& wanted, const ChangeRate& rate, const Vec3& velocity,
                  double dt) noexcept;

 private:
  Wrench more_;
};

}  // namespace sonde
