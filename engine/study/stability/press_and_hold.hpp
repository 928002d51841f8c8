// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "engine/study/stability/closed_loop.hpp"

namespace sonde {

/// A hand presses the probe into a contact, holds it there, knocks once, and holds on. The
/// behaviour of the loop over two windows of the same length afterwards decides the result.
struct Press {
  Pose X_FM;                  ///< free: where it begins at rest, and where the hand's spring stays
  Wrench push;                ///< of the hand, at the hold
  double rise_time = 0.1;     ///< s, until the whole push is there
  double settle_time = 0.1;   ///< s, after the rise and again after the knock
  double knock_time = 0.02;   ///< s, during which the hand pushes harder
  double knock = 1;           ///< by so many times the push
  Wrench jolt = {};           ///< and by this: what the push alone would not set swinging
  double window_time = 0.3;   ///< s, of each of the two windows
  double decay = 0.95;        ///< the swing must fall to this share from window to window
  double quiet_speed = 1e-3;  ///< m/s: what moves with less energy than the handle's mass at this
                              ///< speed stands still
};

/// The figures of a hold. "At the hold" is over the two windows.
struct HoldReport {
  /// Kinetic energy of the handle, mean of the second window over that of the first; 0 where it
  /// stands still. At 1 or above what swings does not die down.
  double growth = 0;
  double kinetic = 0;  ///< J, its mean over the second window
  double work = 0;     ///< J, of the motors on the handle over both windows
  /// N, amplitude of what the loop makes swing at the end of the hold, where it is felt; else 0
  double chatter = 0;
  double saturation = 0;    ///< share of the ticks at the hold at which the coupling's limits acted
  double force_error = 0;   ///< motors against the spring and damper commanded: rms difference over
                            ///< rms force, from the first contact to the end
  double torque_error = 0;  ///< the same of torques
  double depth = 0;         ///< m, mean at the hold
  double contact = 0;       ///< share of the ticks at the hold that are in contact
  double force = 0;         ///< N, mean size of the motors' force at the hold
  double torque = 0;        ///< N·m
  int jumps = 0;            ///< ticks that jumped to another place, as the engine reports it
  int pop_throughs = 0;     ///< those at which the probe came out on another side (popped_through)
  int failures = 0;         ///< ticks without an answer
  bool stable = false;      ///< still, or swinging less and less; in contact; no failures
  bool chattering = false;  ///< something that the loop makes swing is felt (Chatter::buzzes)
  bool saturated = false;   ///< saturation above saturation_limit
};

constexpr double saturation_limit = 0.01;

/// What is asked of a hold.
enum class HoldQuestion {
  figures,  ///< all of the report
  /// Whether it is stable, or comes to rest. It ends as soon as it can be neither: its growth is
  /// then what it came to by then, and no less than Press::decay. Chatter is not looked for.
  outcome,
};

HoldReport press_and_hold(ClosedLoop& loop, const Press& press,
                          HoldQuestion question = HoldQuestion::figures);

/// The hand's wrench beside its spring at a tick, and the tick at which the first window begins.
Wrench push_at(const Press& press, double sample_time, std::int64_t tick);
std::int64_t first_window_of(const Press& press, double sample_time);
/// J: what moves with less stands still.
double quiet_energy(const Press& press, const SimulatedDeviceParameters& device);

/// The ticks that a press takes.
std::int64_t tick_count(const Press& press, double sample_time);

}  // namespace sonde
