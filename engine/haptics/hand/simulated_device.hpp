// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "engine/geometry/pose.hpp"
#include "engine/haptics/coupling/coupling.hpp"

namespace sonde {

/// Parameters of the handle and the hand for one kind of motion, equal along every axis: for the
/// three translations (units on the left) or the three rotations (on the right).
struct HandleMotion {
  double inertia = 0.1;       ///< kg | kg·m², moved by the hand; above zero
  double damping = 0;         ///< N·s/m | N·m·s/rad, of the mechanism
  double friction = 0;        ///< N | N·m, Coulomb friction of the mechanism
  double resolution = 0;      ///< m | rad, one step of the encoders; 0: exact
  double limit = 10;          ///< N | N·m, largest output of the motors
  double hand_stiffness = 0;  ///< N/m | N·m/rad, from the handle to the hand's target
  double hand_damping = 0;    ///< N·s/m | N·m·s/rad, against the hand's own motion
  /// N·s/m | N·m·s/rad, the largest virtual damping that the driver allows; 0: unknown. Used in the
  /// choice of gains; the motion does not depend on it.
  double most_virtual_damping = 0;
  double most_stiffness = 0;  ///< N/m | N·m/rad, likewise for the stiffness
};

struct SimulatedDeviceParameters {
  HandleMotion translation{.hand_stiffness = 300, .hand_damping = 5};
  HandleMotion rotation{.inertia = 5e-5, .limit = 0.5, .hand_stiffness = 0.5, .hand_damping = 0.01};
  double delay = 0;  ///< s from command to motors, also fractions of a sample; up to 64 samples
};

/// The true state of the handle, not the encoders' reading.
struct HandleState {
  Pose X_WD;                     ///< m
  Vec3 velocity = Vec3::Zero();  ///< of the handle's origin, m/s
  Vec3 spin = Vec3::Zero();      ///< rad/s, in W
};

/// Simulates a haptic device with a hand on it, to run the loop without either: a rigid handle,
/// driven by motors that hold the last command between samples, and by a hand that is a spring and
/// a damper from the handle to a target. There is no gravity (devices compensate it).
///
///     m ẍ + b ẋ = f + k_h (x_h − x) + b_h (ẋ_h − ẋ) − friction
///
/// Rotations follow the same equation; their spring acts on the rotation vector from handle to
/// target. f is constant between samples, and x_h moves in a straight line (and turns about one
/// axis). The matrix exponential solves this exactly between samples. So no gain, the hand's
/// included, is too high for the *simulation*: a loop that buzzes here would also buzz on a real
/// device. Two things are not exact but become more accurate with the rate. Coulomb friction is
/// constant over a step and never exceeds the force that brings the handle to rest at the end of
/// the step (a handle at rest stays exactly at rest as long as the forces are below the limit of
/// friction). A rotation whose axis changes loses a little energy.
///
/// The same input gives the same bits.
class SimulatedDevice {
 public:
  static constexpr std::size_t most_samples_late = 64;

  /// `sample_time` in s. The handle starts at rest at X_WD, with the hand there. Allocates. Throws
  /// std::invalid_argument for parameters that no device has: an inertia or a sample time that is
  /// not above zero, another number that is negative or not finite, a delay of more than 64
  /// samples, or a hand so stiff that it oscillates more than a hundred times in one sample.
  SimulatedDevice(const SimulatedDeviceParameters& parameters, double sample_time,
                  const Pose& X_WD = {});

  /// Puts the handle at rest at X_WD, with the hand there and no pending command.
  void reset(const Pose& X_WD) noexcept { reset(X_WD, X_WD); }
  /// The same with the hand at X_WH.
  void reset(const Pose& X_WD, const Pose& X_WH) noexcept;
  /// Takes over the handle, hand and pending commands of a device that ran until now at its own
  /// rate.
  void go_on_from(const SimulatedDevice& before) noexcept;
  /// Advances from this sample to the next. `command` is the wrench on the hand, in W, about the
  /// handle's origin, cut to the motors' limits. X_WH is where the hand wants the handle at the
  /// next sample. `push` is a wrench that the hand adds to that of its spring, immediately and
  /// constant until then. No allocation, lock, log, throw.
  void step(const Wrench& command, const Pose& X_WH, const Wrench& push = {}) noexcept;

  /// The encoders' reading: position and rotation vector, with each coordinate rounded to a step.
  Pose measured() const noexcept;
  const HandleState& state() const noexcept { return state_; }
  /// Output of the motors at the end of the last step: delayed and cut to their limits.
  const Wrench& motors() const noexcept { return motors_; }

 private:
  /// The exact step of m ë + c ė + k e = g with constant g: gives the new (e, ė) from the old and
  /// g.
  struct LinearStep {
    double e_e, e_v, e_g, v_e, v_v, v_g;
  };
  /// A part of the sample with a constant motor force, divided into equal steps.
  struct Part {
    double step_time = 0;  ///< s
    std::size_t steps = 0;
    LinearStep translation{};
    LinearStep rotation{};
  };
  static LinearStep linear_step(const HandleMotion& motion, double time);
  Part part(double time) const;
  void advance(const Part& part, const Wrench& given, const Vec3& hand_velocity,
               const Vec3& hand_spin) noexcept;

  SimulatedDeviceParameters parameters_;
  double sample_time_;
  std::size_t samples_late_;  ///< whole samples from command to motors
  Part older_;                ///< the rest of the delay: the motors still output the last command
  Part newer_;
  HandleState state_;
  Pose X_WH_;
  Wrench motors_;
  std::array<Wrench, most_samples_late + 2> commands_{};  ///< the latest ones, as a ring
  std::size_t newest_ = 0;
};

}  // namespace sonde
