// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/haptics/coupling/coupler.hpp"
#include "engine/haptics/hand/hand.hpp"
#include "engine/haptics/loop/local_contacts.hpp"
#include "engine/haptics/safety/borne_gains.hpp"
#include "engine/haptics/safety/carried_force.hpp"
#include "engine/haptics/safety/force_gate.hpp"
#include "engine/haptics/safety/hand_way.hpp"
#include "engine/haptics/safety/passivity.hpp"
#include "engine/haptics/safety/runaway.hpp"
#include "engine/penetration/contact/contact_clusters.hpp"

namespace sonde {

/// The contact rows that a tick used.
struct RowsUsed {
  std::uint64_t age_ticks = 0;  ///< ticks since the one whose device pose they were made for
  double age = 0;               ///< the same in s
  bool in_step = false;         ///< of the previous tick or younger: the geometry keeps up
  bool held_back = false;       ///< the answer was stopped at their reach (see LocalAnswer)
  double reach = 0;             ///< m
  double refresh_us = 0;        ///< time that the geometry took to make them
  double residual = 0;          ///< of the geometry's answer (Separation::residual)
  PhaseTimes phases;            ///< where that time went, if recorded
  Pose separated;  ///< the geometry's last separated pose, reached along a path swept free
};

/// Further results of a tick, besides the separation and the wrench.
struct HandState {
  Wrench asked;  ///< the coupling's wrench, within its limits; the hand may get less
  Withheld withheld = Withheld::nothing;
  double share = 0;     ///< share of the force that the ramp lets through
  bool slewed = false;  ///< a slew limit acted
  bool capped = false;  ///< the gains exceed what the device can hold, and were reduced to that
  /// The gains wait for the end of this contact, because an estimate says they would be unstable in
  /// it.
  bool waiting = false;
  GainGlide::Blend gains = {};              ///< in use, before the device's own limits
  bool held = true;                         ///< false: the clutch is open
  std::optional<DeviceTraits> device = {};  ///< the device that holds the probe, if known
  HandEnergy energy;
  RowsUsed rows;
};

struct HandTick {
  Separation separation;  ///< for the newest trusted device pose, from the rows in use
  Wrench wrench;          ///< on the hand
  HandState hand;
};

struct HandLoopSettings {
  double rate_hz = 1000;
  SafetySettings safety;
  PassivitySettings passivity;
};

/// The servo's part of the decoupled loop, without thread or clock: it moves the geometry's newest
/// rows to the newest device pose, applies the coupling, and keeps the hand safe.
class HandLoop {
 public:
  HandLoop(const MassProperties& mass, Method method, const Coupling& coupling,
           const HandLoopSettings& settings);

  /// Starts at X_FM; the force rises from zero.
  void restart(const Pose& X_FM) noexcept;
  void set_coupling(const Coupling& coupling) noexcept {
    set_coupling(GainGlide::Blend{.now = coupling, .before = coupling});
  }
  /// Sets the gains, reduced to the stiffness that the device's maker states.
  void set_coupling(const GainGlide::Blend& blend) noexcept;

  /// The share of a glide to other gains that a step of `dt` (s) may make in the present contact,
  /// if the hand is on a known device: see ChangeRate. Gains stiffer than stable_by_estimate() wait
  /// until the contact ends, in a change of mode too: see share_of_way().
  double most_of_glide(const GainGlide& glide, double dt) noexcept;

  void set_rate(double rate_hz) noexcept;
  /// Limits the energy given to a known device; other hands cannot oscillate.
  void set_passivity_control(bool on) noexcept { passivity_.set_control(on); }

  struct Clock {
    std::uint64_t tick = 0;
    double now = 0;  ///< s, on the clock of the rows
    double dt = 0;   ///< s since the last tick; 0 if unknown
  };
  /// `why`: an external reason to withhold the force. No allocation, lock, log, throw.
  const HandTick& tick(const HandSample& sample, const LocalContacts& contacts, const Clock& clock,
                       Withheld why) noexcept;
  /// A tick without computation: the hand gets no force, and the next force rises from zero. The
  /// rows grow old meanwhile, but that is no fault of the geometry. So `why` remains the reason
  /// until the geometry has answered again within its time limit.
  const HandTick& rest(Withheld why) noexcept;

  /// A tick of the shutdown: the last wrench falls to zero, at its permitted rate of change or
  /// within the remaining `time` (s), whichever is faster; more slowly where the hand presses on
  /// meanwhile. It is zero immediately on a hand that is not a known device, or that got no force.
  static constexpr double longest_fade = 6;  ///< s
  const HandTick& fade(const HandSample& sample, double dt, double time) noexcept;

  const HandTick& last() const noexcept { return out_; }
  /// The newest trusted device pose, to be passed to the geometry.
  const Pose& device() const noexcept { return X_FM_; }
  /// How far the geometry is behind in the last tick, as a share of what withholds the force: the
  /// error of an answer that has not converged, or the age of the rows. 0: not at all; from 1 on
  /// there is no force, or there soon will be none.
  double behind() const noexcept;

 private:
  Withheld fault(const HandSample& sample, const LocalContacts& contacts,
                 const Clock& clock) const noexcept;
  /// The part that concerns the hand alone.
  Withheld fault(const HandSample& sample) const noexcept;
  Withheld overdue(const LocalContacts& contacts, const Clock& clock) const noexcept;
  /// True if the geometry's answer has not converged, and the probe lags so far behind that the
  /// error of the force may exceed the limit (LocalAnswer::lag). Where the rows' optimum is within
  /// the way for which they are trusted, it gives the force, as it does for old rows.
  bool is_unsettled() const noexcept { return unsettled_share() > 1; }
  double unsettled_share() const noexcept;
  void follow(const HandSample& sample, double dt) noexcept;
  void set_change_rate(const HandSample& sample) noexcept;
  /// `rescaled`: see HandSample; 0: the force begins anew.
  void hold_below(double rescaled) noexcept;
  Wrench wanted(const HandSample& sample, double dt) noexcept;
  /// Carries what the hand felt over into another scale, or over a limit that falls.
  void carry_over(const Wrench& felt, const Wrench& now, double rescaled) noexcept;
  struct Limits {
    double force, torque;
  };
  /// Those of the coupling; what is carried over may be above them.
  Limits limits() const noexcept;
  /// The limits of the wrench: those of the coupling, and those of the device if known.
  double most_force() const noexcept;
  /// Of the handle, from a speed of the probe, m/s.
  double at_handle(double speed) const noexcept {
    return device_ && device_->ratio > 0 ? speed / device_->ratio : speed;
  }
  double most_torque() const noexcept;
  /// Renders the wrench of a hand that is being measured, through the gate.
  void try_out(HandTrial& trial, Withheld reason, double dt) noexcept;
  void say_gate() noexcept;
  void forget_force() noexcept;
  /// The wrench that the gate let through, less what dissipates energy in excess.
  Wrench damped(const Wrench& passed, double dt) noexcept;
  bool pushed() const noexcept;  ///< whether the last wrench was not zero
  void separate(const LocalContacts& contacts, const Clock& clock) noexcept;

  MassProperties mass_;
  Method method_;
  double least_stall_;                        ///< s, from the settings
  double stalled_after_;                      ///< s, at this rate
  double force_error_;                        ///< N
  ThrownSpeed fastest_;                       ///< from the settings
  double period_ = 1e-3;                      ///< s
  ChangeRate of_hand_;                        ///< from the settings
  ChangeRate rate_{.force = 0, .torque = 0};  ///< at the probe, for the hand of the last tick
  ChangeRate whole_rate_ = rate_;             ///< the same, if it does not yield, of its device
  GainGlide::Blend set_;                      ///< as set, before any limit
  Coupler coupler_;
  Passivity passivity_;
  Runaway runaway_;
  HandWay way_;
  ForceGate gate_;
  Wrench damping_;  ///< of the last tick, part of its wrench
  CarriedForce carried_;
  /// Of the coupling in the last tick, at the probe as it is scaled now.
  double max_force_ = 0, max_torque_ = 0;
  /// Until the contact is left, gains that are stable by estimate, or no more than these, are all.
  std::optional<FeltGains> felt_already_;
  /// Since the start, or since another device was handed over, no tick had a device and a contact.
  bool anew_ = true;
  ClusterIds ids_;
  double lag_ = 0;                      ///< m, of the last answer (LocalAnswer)
  std::optional<DeviceTraits> device_;  ///< of the last tick
  Pose X_FM_;
  std::uint64_t jumps_ = 0;            ///< of the previous rows
  std::uint64_t falls_ = 0;            ///< of the previous rows
  double released_ = 0;                // m²: of the previous rows
  bool resting_ = false;               ///< the last tick was rest()
  Withheld rest_ = Withheld::nothing;  ///< reason of the last rest
  double resumed_ = 0;                 ///< s, time of the first tick after that
  HandTick out_;
};

}  // namespace sonde
