// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/haptics/coupling/coupling.hpp"
#include "engine/haptics/safety/change_rate.hpp"

namespace sonde {

/// Why there is no force on the hand.
enum class Withheld {
  nothing,     ///< there is a force if the probe is in contact
  stopped,     ///< the user pressed Esc
  paused,      ///< the loop computes nothing
  let_go,      ///< the clutch is open
  changed,     ///< another hand holds the probe, or the same with other axes
  untrusted,   ///< the device is gone, or reports something impossible
  not_finite,  ///< the device pose, or a force, is not a number
  failed,      ///< no separated pose was found
  stalled,     ///< the geometry has not answered for too long
  unsettled,   ///< its answer has not converged, and lags: the force fades, may not be zero yet
  diverged,    ///< the force threw the hand, which is still in contact or fast
  shut_down,   ///< the loop has ended
};
/// A few words for the window and the log.
const char* words(Withheld why);

struct SafetySettings {
  double ramp_time = 0.3;       ///< s: least time in contact until the force is full
  ChangeRate change_rate = {};  ///< for a hand on a known device
  double force_slew = 5000;     ///< N/s, largest change of the force; 0: no limit
  double torque_slew = 250;     ///< N·m/s
  double stalled_after = 0.02;  ///< s, age of the rows
  /// N; permitted error of the force of an answer that has not converged; 0: any. About a tenth of
  /// the largest force of a small device; chosen, not measured.
  double force_error = 0.3;
  double fade_time = 0.05;   ///< s, for the full force to fade if its error may be larger
  double runaway_speed = 2;  ///< m/s of the hand under a force, see Runaway; 0: no limit
  /// rad/s of the hand under a wrench; 0: no limit. Chosen, not measured: five turns a second.
  double runaway_turn = 30;
};

/// The last check of a wrench on its way to the hand. The force rises from zero after a start, and
/// after anything that withheld it. It changes no faster than its slew limits. It stays below the
/// limits of the coupling (Coupling::max_force and max_torque). It is zero immediately while it is
/// withheld. One exception: if the answer has not converged, the force fades, because a single such
/// tick should not make the force of a wall vanish. The ramp advances only while there is a force
/// to give: a contact made long after a fault also rises slowly.
///
/// See also the other limits of the wrench. Before the gate, Coupler::wrench
/// (engine/haptics/coupling/coupler.cpp) scales it down to the limits of the coupling. After it,
/// Passivity::control may damp it, within the limits of the coupling and with no more than the
/// ramp's share of that damping. Finally the driver of a device with force scales it down to what
/// that device can give (`limited` in engine/devices/device_sample.cpp).
class ForceGate {
 public:
  explicit ForceGate(const SafetySettings& settings = {}) : settings_(settings) {}

  /// The wrench to render, from the wanted one; dt in s since the last call. A wanted wrench that
  /// is not finite is withheld.
  Wrench pass(const Wrench& wanted, Withheld why, double max_force, double max_torque,
              double dt) noexcept;
  void restart() noexcept;  ///< the next force rises from zero
  /// Converts the last force to a new scaling of the device, in which the same force of the hand is
  /// `times` as large.
  void rescale(double times) noexcept { last_.force *= times; }
  /// Limits how fast the ramp may raise a wrench, at the probe; initially only its time limits it.
  void set_change_rate(const ChangeRate& rate) noexcept { rate_ = rate; }
  /// A slew limit in addition to that of the settings; 0: none.
  struct Slew {
    double force = 0, torque = 0;  ///< N/s, N·m/s
    bool ends_at_once = true;      ///< a change to a wrench of zero is not limited
    /// N/s, N·m/s, in addition if the wrench falls.
    double falling_force = 0, falling_torque = 0;
  };
  void set_slew(const Slew& slew) noexcept { slew_ = slew; }

  Withheld withheld() const noexcept { return withheld_; }  ///< of the last wrench
  double share() const noexcept {
    return share_;
  }  ///< share of the force that the ramp lets through
  bool slewed() const noexcept { return slewed_; }  ///< a slew limit acted

 private:
  /// The increase of the ramp's share in a step, s.
  double rise(const Wrench& wanted, double step) const noexcept;

  SafetySettings settings_;
  /// The smaller of two limits; a limit of 0 does not count.
  static double closer(double limit, double other) noexcept;

  ChangeRate rate_{.force = 0, .torque = 0};
  Slew slew_;
  Wrench last_;
  Withheld withheld_ = Withheld::nothing;
  double share_ = 0;
  bool slewed_ = false;
};

}  // namespace sonde
