// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/base/triple_buffer.hpp"
#include "engine/haptics/hand/hand.hpp"
#include "engine/haptics/hand/simulated_device.hpp"

namespace sonde {

/// A simulated device that holds the probe, in a hand that follows a target (the mouse). Its handle
/// corresponds to the probe's centre of mass, in a workspace `scaling` times smaller than the
/// scene. As with a real device, the handle gets `scaling` times the force, so that the hand does
/// the work that is done on the probe.
///
/// Its time is counted in ticks, each as long as the nominal period of the servo. So a late tick
/// slows the simulation down, but does not disturb the motion.
class SimulatedHand {
 public:
  /// `period` of the servo in s; the probe is at X_FM, and `com` is its centre of mass in its mesh
  /// frame. Throws as SimulatedDevice does.
  SimulatedHand(const SimulatedDeviceParameters& parameters, double period, double scaling,
                const Vec3& com, const Pose& X_FM);
  SimulatedHand(const SimulatedHand&) = delete;
  SimulatedHand& operator=(const SimulatedHand&) = delete;

  /// Functions for the servo; this object must outlive it.
  Hand hand();

  // To be called from one other thread; they act on the next tick.
  /// Sets the probe pose that the mouse asks for.
  void set_target(const Pose& X_FM) { targets_.write(X_FM); }
  /// Puts the handle and the hand at rest at X_FM.
  void place(const Pose& X_FM) { places_.write(X_FM); }
  void set_scaling(double scaling) { scalings_.write(scaling); }
  /// Changes to another period of the servo, in s, without a change of the handle, the hand or its
  /// push. Throws as SimulatedDevice does; then nothing changes.
  void set_period(double period);
  /// The same, also with other parameters of the hand and another inertia of the handle. The
  /// mechanism's damping, delay and limits do not change.
  void set_parameters(const SimulatedDeviceParameters& parameters, double period);

 private:
  HandSample sample() noexcept;
  /// Handle and push of the hand stay. HandSample::rescaled.
  double take_scaling(double scaling) noexcept;
  void follow_target() noexcept;
  Pose to_device(const Pose& X_FM) const noexcept;
  Pose to_probe(const Pose& X_WD) const noexcept;

  /// The data that depends on the period.
  struct Pace {
    SimulatedDevice device;
    double share;          ///< share of the distance to the target that the hand moves in a tick
    double mass, inertia;  ///< of the handle
  };
  static Pace pace_of(const SimulatedDeviceParameters& parameters, double period);

  SimulatedDeviceParameters parameters_;
  double scaling_;
  DeviceTraits traits_;  ///< at the handle
  Vec3 com_;
  Pace pace_;
  Pose hand_;  ///< X_FM of the hand
  Wrench command_;
  bool begun_ = false;  ///< a command has been given to the motors
  TripleBuffer<Pose> targets_;
  TripleBuffer<Pose> places_;
  TripleBuffer<double> scalings_;
  TripleBuffer<std::optional<Pace>> paces_;
};

}  // namespace sonde
