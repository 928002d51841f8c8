// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "engine/geometry/mass.hpp"
#include "engine/geometry/pose.hpp"
#include "engine/haptics/coupling/coupling.hpp"
#include "engine/haptics/hand/hand.hpp"

namespace sonde {

struct PassivitySettings {
  /// Dissipate the energy that the loop has added, by damping the hand's motion.
  bool control = true;
  double max_damping = 5;     ///< N·s/m at the hand, the largest damping of the controller
  double device_damping = 0;  ///< N·s/m, of the mechanism: a lower bound of what it dissipates
  double delay = 0;           ///< s from command to motors, of the device; whole ticks, 64 at most
};

/// The energy that the loop has given to the hand, from the rendered wrenches and the sampled
/// poses.
struct HandEnergy {
  double given = 0;   ///< J, net work on the hand since the start; a passive wall gives none
  double excess = 0;  ///< J, given by contacts beyond what the device dissipates; ≤ 0: passive
  /// J, taken out so far by the damping that was rendered, at the hand's newest known speed.
  double dissipated = 0;
  double damping = 0;  ///< N·s/m, that the controller wants in this tick
};

/// Passivity observer and controller in the time domain, after Hannaford and Ryu (2002). It always
/// observes the energy that passes to the hand, and can limit it. The force is held between two
/// samples (zero-order hold), so its work is exact,
///
///     W_k = W_{k−1} + F_{k−1}·(x_k − x_{k−1}) + τ_{k−1}·θ_k,
///
/// with x the probe's centre of mass and θ the rotation vector of its turn. If a device reports
/// less often than the servo samples, F and τ are the mean of those held since its last report:
/// exact for a hand that moves uniformly meanwhile. If a device's delay is known, the wrench is the
/// one that acted. A virtual wall stores no energy after the hand has left
/// it, so then W ≤ 0 if the wall is passive, whoever holds the device. The controller dissipates
/// the energy that a contact gave in excess, in the object norm: F −= α v, τ −= α Î ω, with α as
/// large as necessary and within the device's limit. The energy that one contact took from the hand
/// does not permit the next one to give energy.
class Passivity {
 public:
  Passivity(const MassProperties& mass, const PassivitySettings& settings, double period);

  /// Sets the device's properties from the next pose on; they replace those of the settings. None:
  /// those of the settings.
  void set_device(const std::optional<DeviceTraits>& device) noexcept;
  void set_control(bool on) noexcept { settings_.control = on; }
  void set_period(double period) noexcept { period_ = period; }  ///< s, from the next device on
  void restart(const Pose& X_FM) noexcept;
  /// The pose of this tick, which includes the effect of the last wrench. dt in s since the last
  /// pose. A pose that leapt (moved faster than a hand can) counts as no motion and no work;
  /// otherwise the work of a wrong pose could offset energy that a contact gives. The same holds
  /// for a pose too far away to compute with. `since` (s): see HandSample; if it is 0, an unchanged
  /// pose is not a report.
  void observe(const Pose& X_FM, double dt, bool leapt = false, double since = 0) noexcept;
  /// The wrench that would go to the hand, damped if the controller is on. Call rendered()
  /// afterwards.
  Wrench control(const Wrench& wanted) noexcept;
  /// The wrench that went to the hand in this tick.
  void rendered(const Wrench& wrench) noexcept;
  /// A tick without a pose and without a wrench; the hand's motion in it is unknown.
  void rested() noexcept;
  const HandEnergy& energy() const noexcept { return energy_; }

 private:
  static constexpr std::size_t most_ticks_late = 64;
  /// Since the last report, of the wrenches that acted.
  struct Held {
    Vec3 impulse = Vec3::Zero();  ///< N·s
    Vec3 twist = Vec3::Zero();    ///< N·m·s
    double time = 0;              ///< s
    int ticks = 0;
  };
  const Wrench& acting() const noexcept;
  double most_damping() const noexcept;
  void hold(const Wrench& wrench) noexcept;
  Wrench mean_held() const noexcept;
  void wait() noexcept;
  void report(const Vec3& step, const Vec3& turn, double since) noexcept;
  void forget_motion() noexcept;

  MassProperties mass_;
  PassivitySettings settings_;
  double period_;  ///< s
  DeviceTraits device_;
  std::size_t ticks_late_ = 0;
  Pose X_FM_;
  Vec3 step_ = Vec3::Zero();  ///< of the centre of mass up to the last report, m
  Vec3 turn_ = Vec3::Zero();  ///< rad, fixed frame, likewise
  double dt_ = 0;             ///< s, of the last tick
  double since_ = 0;          ///< s, time of step_ and turn_
  double acts_for_ = 0;       ///< s, for which that motion is assumed to continue
  double fresh_for_ = 0;      ///< s, the rest of that time
  Held held_;
  Wrench wanted_;                                       ///< of control(), before its damping
  bool controlled_ = false;                             ///< control() was called in this tick
  std::array<Wrench, most_ticks_late + 1> wrenches_{};  ///< the latest ones, as a ring
  std::size_t newest_ = 0;
  HandEnergy energy_;
};

}  // namespace sonde
