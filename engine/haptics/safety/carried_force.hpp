// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/haptics/coupling/coupling.hpp"
#include "engine/haptics/safety/change_rate.hpp"

namespace sonde {

/// m/s, a third of the speed at which a handle may be moved by what is not its own motion: one that
/// goes where the force changes to, as fast as that, gets hardly any more of that change.
inline constexpr double slow_enough = 0.03;

/// The share of a rate of change that is left where the handle yields at this speed, m/s.
double share_where_it_yields(double speed) noexcept;

/// Where a device's scaling changes in a contact, the hand feels another force, at once, though it
/// has not moved. This carries what it felt over into the new scale: the difference is added to
/// what the coupling wants, and falls to nothing at the permitted rate of change.
class CarriedForce {
 public:
  /// Nothing is carried: the contact is left, or the force ended.
  void restart() noexcept { more_ = Wrench{}; }
  /// The coupling wants `now` where the hand feels `felt`, both in the new scale.
  void carry(const Wrench& felt, const Wrench& now) noexcept;
  /// The wrench for this tick, of dt (s). `velocity`: of the hand, m/s, in the frame of the force.
  /// It never pulls where the coupling pushes.
  Wrench added_to(const Wrench& wanted, const ChangeRate& rate, const Vec3& velocity,
                  double dt) noexcept;

 private:
  Wrench more_;
};

}  // namespace sonde
