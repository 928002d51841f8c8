// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/haptics/coupling/coupling_wrench.hpp"
#include "engine/haptics/hand/simulated_device.hpp"
#include "engine/haptics/loop/haptic_loop.hpp"

namespace sonde {

/// The input of a closed loop.
struct ClosedLoopSetup {
  Pair pair;
  Method method = Method::pdg;
  Coupling coupling = {};
  SimulatedDeviceParameters device = {};
  double sample_time = 1e-3;  ///< T, s
  Budget budget = {};         ///< of each tick; counted work, or the bits are not the same
};

/// A simulated device with a hand on it, and the haptic loop on two real bodies: the system that
/// `sonde tune` studies. The handle's origin is the probe's centre of mass, so the loop's torque is
/// about it; scene and device have the same scale. No thread and no clock: same input, same bits.
class ClosedLoop {
 public:
  /// Throws std::invalid_argument as SimulatedDevice does. Allocates.
  explicit ClosedLoop(const ClosedLoopSetup& setup);

  /// At rest at X_FM, the hand with it. The loop follows from there; where the probe overlaps, from
  /// Starts at rest at X_FM, with the hand there. The loop follows from there; if the probe
  /// overlaps, from the result of a static search. Allocates.
  void reset(const Pose& X_FM, const StaticOptions& options = {});

  /// Runs one sample: the pose from the encoders, the tick, the wrench to the motors, and the
  /// Runs one sample: the pose from the encoders, the tick, the wrench to the motors, and the
  /// handle until the next sample. X_FH is the hand's target for the probe's mesh frame at that
  /// time; `push` is the hand's wrench in addition to its spring, about the centre of mass, as it
  /// acts if the handle is not turned from that target (push_as_turned). No allocation, lock, log,
  /// throw.
  void step(const Pose& X_FH, const Wrench& push = {}) noexcept;

  /// The true pose of the mesh frame, not the encoders' reading.
  Pose X_FM() const noexcept { return device_.state().X_WD * X_DM_; }
  const SimulatedDevice& device() const noexcept { return device_; }
  const HapticLoop& haptic_loop() const noexcept { return loop_; }
  const ClosedLoopSetup& setup() const noexcept { return setup_; }

 private:
  ClosedLoopSetup setup_;
  Pose X_DM_;
  HapticLoop loop_;
  SimulatedDevice device_;
};

/// A push whose torque conserves energy: that of the potential −τ·φ, with φ the rotation vector
/// A push whose torque conserves energy: that of the potential −τ·φ, with φ the rotation vector
/// from the hand's target to the handle, as for a spring. (A torque that keeps its direction while
/// the handle turns has no potential. It gives ½ τ·∮φ×dφ to a handle that whirls about it, without
/// end.) Beyond 3 rad, near the limit of φ, it keeps its direction.
Wrench push_as_turned(const Wrench& push, const Vec3& phi);

/// Hooke's law at a separation: the spring's part of the coupling, before limits and without
/// damping. Zero out of contact.
Wrench spring_wrench(const MassProperties& mass, const Separation& separation,
                     const Coupling& coupling);

/// What the rates of dampers are taken from.
struct LastSeparation {
  SeparationMotion motion;  ///< zero out of contact
  Pose device;
};
/// No value if the separation failed.
std::optional<LastSeparation> last_separation(const MassProperties& mass,
                                              const Separation& separation);

/// The wrench that a coupling commands, before limits: Hooke's law and its damper on the rate of
/// the separation. `before` is the separation a sample time earlier; if there is none, or after a
/// jump, the rate is zero.
Wrench commanded_wrench(const ClosedLoopSetup& setup, const Separation& separation,
                        const std::optional<LastSeparation>& before);

/// Kinetic energy of the handle, J.
double kinetic_energy(const SimulatedDeviceParameters& device, const HandleState& state);

}  // namespace sonde
