// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "engine/study/stability/closed_loop.hpp"

namespace sonde {

/// A hand presses the probe into a contact, holds it there, knocks once, and holds on. The
/// behaviour of the loop in two windows of the same length afterwards decides the result.
struct Press {
  Pose X_FM;                  ///< free: the start, at rest, and the target of the hand's spring
  Wrench push;                ///< of the hand, at the hold
  double rise_time = 0.1;     ///< s, until the whole push acts
  double settle_time = 0.1;   ///< s, after the rise and again after the knock
  double knock_time = 0.02;   ///< s, during which the hand pushes harder
  double knock = 1;           ///< by this multiple of the push
  Wrench jolt = {};           ///< added to the knock: excites what the push alone would not
  double window_time = 0.3;   ///< s, of each of the two windows
  double decay = 0.95;        ///< the oscillation must fall to this share from window to window
  double quiet_speed = 1e-3;  ///< m/s: what moves with less energy than the handle's mass at this
                              ///< speed stands still
};

/// The results of a hold. "At the hold" is over the two windows.
struct HoldReport {
  /// Kinetic energy of the handle, mean of the second window over that of the first; 0 if it stands
  /// still. At 1 or above, the oscillation does not decay.
  double growth = 0;
  double kinetic = 0;  ///< J, its mean over the second window
  double work = 0;     ///< J, of the motors on the handle over both windows
  /// N, amplitude of an oscillation caused by the loop at the end of the hold, if it is felt;
  /// otherwise 0
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
  int pop_throughs = 0;     ///< jumps at which the probe came out on another side (popped_through)
  int failures = 0;         ///< ticks without an answer
  bool stable = false;      ///< still, or with a decaying oscillation; in contact; no failures
  bool chattering = false;  ///< an oscillation caused by the loop is felt (Chatter::buzzes)
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

/// The hand's wrench in addition to its spring at a tick, and the tick at which the first window
/// begins.
Wrench push_at(const Press& press, double sample_time, std::int64_t tick);
std::int64_t first_window_of(const Press& press, double sample_time);
/// J: a handle with less kinetic energy stands still.
double quiet_energy(const Press& press, const SimulatedDeviceParameters& device);

/// The number of ticks of a press.
std::int64_t tick_count(const Press& press, double sample_time);

}  // namespace sonde
