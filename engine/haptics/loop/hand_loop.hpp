// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/haptics/coupling/coupler.hpp"
#include "engine/haptics/hand/hand.hpp"
#include "engine/haptics/loop/local_contacts.hpp"
#include "engine/haptics/safety/force_gate.hpp"
#include "engine/haptics/safety/passivity.hpp"
#include "engine/haptics/safety/runaway.hpp"
#include "engine/penetration/contact/contact_clusters.hpp"

namespace sonde {

/// The contact rows that a tick used.
struct RowsUsed {
  std::uint64_t age_ticks = 0;  ///< since the tick whose device pose they are about
  double age = 0;               ///< the same, s
  bool in_step = false;         ///< of the previous tick or younger: the geometry keeps up
  bool held_back = false;       ///< they did not reach to the device pose (see LocalAnswer)
  double reach = 0;             ///< m
  double refresh_us = 0;        ///< time the geometry took to make them
  double residual = 0;          ///< of the geometry's answer (Separation::residual)
  PhaseTimes phases;            ///< where that time went, if it was asked for
  Pose separated;  ///< the geometry's last separated pose, reached along a path swept free
};

/// What a tick computed besides the separation and the wrench.
struct HandState {
  Wrench asked;  ///< the coupling's wrench, within its limits; the hand may get less
  Withheld withheld = Withheld::nothing;
  double share = 0;     ///< share of the force that the ramp lets through
  bool slewed = false;  ///< a slew limit acted
  bool capped =
      false;  ///< the gains are stiffer than what the device bears, and were taken as that
  /// The gains wait for the end of this contact, as they would be unstable in it by an estimate.
  bool waiting = false;
  bool held = true;                         ///< false: the clutch is open
  std::optional<DeviceTraits> device = {};  ///< what holds the probe, as far as it is known
  HandEnergy energy;
  RowsUsed rows;
};

struct HandTick {
  Separation separation;  ///< of the newest trusted device pose, by the rows at hand
  Wrench wrench;          ///< on the hand
  HandState hand;
};

struct HandLoopSettings {
  double rate_hz = 1000;
  SafetySettings safety;
  PassivitySettings passivity;
};

/// The servo's part of the decoupled loop, with no thread and no clock: it moves the geometry's
/// newest rows to the newest device pose, applies the coupling, and keeps the hand safe.
class HandLoop {
 public:
  HandLoop(const MassProperties& mass, Method method, const Coupling& coupling,
           const HandLoopSettings& settings);

  /// Begins at X_FM; the force rises from zero.
  void restart(const Pose& X_FM) noexcept;
  void set_coupling(const Coupling& coupling) noexcept {
    set_coupling(GainGlide::Blend{.now = coupling, .before = coupling});
  }
  /// None stiffer than what the device bears by its maker's word.
  void set_coupling(const GainGlide::Blend& blend) noexcept;

  /// The share of the way to other gains that a step of time (s) may make in the present contact,
  /// of a hand on a known device: see ChangeRate. Stiffer gains than stable_by_estimate() wait
  /// until the contact is left.
  double most_of_glide(const GainGlide& glide, double dt) noexcept;

  void set_rate(double rate_hz) noexcept;
  /// Of the force on a known device; nobody else holds anything that could swing.
  void set_passivity_control(bool on) noexcept { passivity_.set_control(on); }

  struct Clock {
    std::uint64_t tick = 0;
    double now = 0;  ///< s, on the clock of the rows
    double dt = 0;   ///< s since the last tick; 0 where that is not known
  };
  /// `why`: an outside reason to withhold the force. No allocation, lock, log, throw.
  const HandTick& tick(const HandSample& sample, const LocalContacts& contacts, const Clock& clock,
                       Withheld why) noexcept;
  /// A tick without computation: the hand gets nothing, and the next force rises from zero. The
  /// rows age meanwhile, which is no fault of the geometry. So the reason stays until the geometry
  /// has answered since, within its time.
  const HandTick& rest(Withheld why) noexcept;

  /// A tick on the way to the end: the last wrench falls to nothing, at the rate at which it may
  /// change or within `time` (s) left; at once on a hand that is not a known device, or was given
  /// nothing.
  const HandTick& fade(const HandSample& sample, double dt, double time) noexcept;

  const HandTick& last() const noexcept { return out_; }
  /// The newest trusted device pose, to be passed to the geometry.
  const Pose& device() const noexcept { return X_FM_; }

 private:
  Withheld fault(const HandSample& sample, const LocalContacts& contacts,
                 const Clock& clock) const noexcept;
  /// The part of it that is the hand's own.
  Withheld fault(const HandSample& sample) const noexcept;
  Withheld overdue(const LocalContacts& contacts, const Clock& clock) const noexcept;
  /// True if the geometry's answer has not converged and its force may be off by more than is
  /// allowed.
  bool unsettled(const Separation& found) const noexcept;
  void follow(const HandSample& sample, double dt) noexcept;
  void set_change_rate(const HandSample& sample) noexcept;
  /// How far the hand came in this tick, and how much the wrench may change for that.
  /// `fastest`: of the probe, m/s; 0: no limit.
  void measure_way(const Pose& before, double fastest, double dt) noexcept;
  void set_slew(double dt) noexcept;
  /// What the wrench is limited to: by the gains, and by the device where that is known.
  double most_force() const noexcept;
  double most_torque() const noexcept;
  /// The wrench of a hand that is being measured, past the gate.
  void try_out(HandTrial& trial, Withheld reason, double dt) noexcept;
  void say_gate() noexcept;
  bool pushed() const noexcept;  ///< by the last wrench
  void separate(const LocalContacts& contacts, const Clock& clock) noexcept;

  MassProperties mass_;
  Method method_;
  double least_stall_;                        ///< s, of the settings
  double stalled_after_;                      ///< s, at this rate
  double force_error_;                        ///< N
  ThrownSpeed fastest_;                       ///< of the settings
  double period_ = 1e-3;                      ///< s
  ChangeRate of_hand_;                        ///< of the settings
  ChangeRate rate_{.force = 0, .torque = 0};  ///< at the probe, of the hand of the last tick
  Coupler coupler_;
  Passivity passivity_;
  Runaway runaway_;
  ForceGate gate_;
  ClusterIds ids_;
  double way_ = 0, way_before_ = 0;  ///< m, in the object norm, of the last two ticks
  bool leapt_ = false;               ///< further than a hand moves in a tick
  double yields_ = 0;                ///< m/s, at which the last wrench moves the hand its own way
  std::optional<DeviceTraits> device_;  ///< of the last tick
  Pose X_FM_;
  std::uint64_t jumps_ = 0;            ///< of the rows before
  double released_ = 0;                // m²: of those rows
  bool resting_ = false;               ///< the last tick was one of rest
  Withheld rest_ = Withheld::nothing;  ///< reason of the last rest
  double resumed_ = 0;                 ///< s, the first tick after that
  HandTick out_;
};

}  // namespace sonde
