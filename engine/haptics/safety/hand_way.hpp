// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/mass.hpp"
#include "engine/geometry/pose.hpp"
#include "engine/haptics/coupling/coupling.hpp"
#include "engine/haptics/safety/change_rate.hpp"
#include "engine/haptics/safety/force_gate.hpp"

namespace sonde {

/// The hand's own motion from tick to tick, at the probe, and the change of the wrench that it
/// permits: twice what it can cause. What the force itself moved permits none. A device that
/// reports less often than the loop ticks tells a way in one tick, which counts until its next
/// report is due.
class HandWay {
 public:
  /// s: least time for the whole of a device's force, by whatever motion.
  static constexpr double whole_force = 0.01;

  struct Motion {
    Pose before, now;
    Vec3 force = Vec3::Zero();  ///< N, that acted meanwhile
    double fastest = 0;  ///< m/s, in the object norm: what moves faster leapt; 0: nothing does
    double since = 0;    ///< s, time of the motion
    double dt = 0;       ///< s since the last tick
  };
  struct Most {
    double force = 0, torque = 0;  ///< N, N·m, of coupling and device
  };

  void restart() noexcept;
  /// What the limits keep of the last wrench.
  void forget_force() noexcept;
  void measure(const MassProperties& mass, const Motion& motion) noexcept;
  /// The limits for the next wrench: what the motion permits, plus the rate at which other causes
  /// may change it (a contact that jumps to another position, a pose that is wrong for a tick,
  /// other gains). Out of contact (`separated`) the wrench ends immediately, unless the pose leapt
  /// there.
  ForceGate::Slew slew(const MassProperties& mass, const Coupling& coupling, const Most& most,
                       const ChangeRate& rate, bool separated, double dt) noexcept;
  /// The wrench that passed the gate within these limits.
  void spend(const Wrench& passed, double dt) noexcept;

  bool leapt() const noexcept { return leapt_; }      ///< further than a hand moves in a tick
  double yields() const noexcept { return yields_; }  ///< m/s, in the direction of the last force
  const Vec3& velocity() const noexcept { return velocity_; }  ///< m/s, by the last report

 private:
  double way_ = 0, way_before_ = 0;  ///< m, in the object norm, of the last two ticks
  double withdrawn_ = 0;  ///< m, of the last tick: also what was in the force's direction
  double unspent_ = 0;    ///< m: the part of it by which the force has not changed yet
  double per_way_ = 0;    ///< N/m: the change of force that it permits
  double fresh_for_ = 0;  ///< s until the device's next report is due; at most 0: each tick has one
  Wrench passed_;         ///< by the gate, in the last tick
  bool leapt_ = false;
  double yields_ = 0;
  Vec3 velocity_ = Vec3::Zero();
};

}  // namespace sonde
