// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

#include "engine/platform/real_time.hpp"
#include "engine/haptics/coupling/coupling.hpp"
#include "engine/haptics/loop/hand_loop.hpp"
#include "engine/haptics/loop/time_histogram.hpp"
#include "engine/penetration/contact/separation.hpp"
#include "engine/penetration/search/pair.hpp"

namespace sonde {

/// What one tick computed: plain data, copied through a triple buffer.
struct Snapshot {
  std::uint64_t tick = 0;  ///< ticks since the start
  double time = 0;         ///< s since the start, of the tick's beginning
  /// O, Q, contacts, σ: the local answer for the newest device pose. Q is not tested against the
  /// bodies; hand.rows.separated is.
  Separation separation;
  Wrench wrench;           ///< on the hand, after every limit
  HandState hand;          ///< why there is no force; rows, energy
  Coupling coupling;       ///< the gains of this tick, possibly on their way to new ones
  double tick_us = 0;      ///< time the tick's computation took
  double rate_hz = 0;      ///< measured over the last 100 ms or so
  std::uint64_t late = 0;  ///< ticks that began or ended past their deadline, so far
  bool paused = false;     ///< everything else is of the last tick; the hand gets nothing
};

/// How well the servo keeps its deadlines, since the start.
struct ServoTiming {
  TimeHistogram period;    ///< from the beginning of a tick to that of the next
  TimeHistogram tick;      ///< time a tick took, the device included
  TimeHistogram geometry;  ///< time the rows took
  TimeHistogram age;       ///< of the rows, at the ticks that used them
  std::uint64_t ticks = 0;
  std::uint64_t late = 0;     ///< ticks that began or ended past their deadline
  std::uint64_t in_step = 0;  ///< ticks with rows of the previous tick or younger
  RealTime real_time;
};

struct ServoSettings {
  double rate_hz = 1000;
  /// What the geometry thread may use for each answer of the solver. It does not limit the servo's
  /// own tick: one that ends past its deadline is only counted (Snapshot::late).
  Budget budget{.steps = 0, .microseconds = 800};
  /// Instead of the budget's time: the error that nine in ten ticks should keep to, as a share of
  /// the largest depth; 0: not given. The servo goes by the budget alone: with_budget() sets that.
  double accuracy = 0;
  SafetySettings safety;
  PassivitySettings passivity;
  bool real_time = true;  ///< ask the system for real-time scheduling and locked memory
};

/// The haptic loop in two threads. The servo keeps the rate: each tick samples the pose of the
/// hand, moves the newest contact rows to it, and pushes the hand back. The geometry follows as
/// fast as it can and makes the rows. One other thread (the window's) makes all calls here.
class Servo {
 public:
  Servo(const Pair& pair, Method method, const Coupling& coupling, const ServoSettings& settings);
  ~Servo();  ///< stops the threads
  Servo(const Servo&) = delete;
  Servo& operator=(const Servo&) = delete;

  /// Starts at X_FM and runs until stop(). Where the probe overlaps there, it searches, which can
  /// take a while. A running servo is stopped first: this is how to set the loop back to a pose.
  /// The servo follows set_device_pose().
  void start(const Pose& X_FM);
  /// The same with a hand, which the servo samples and renders to in each tick, even while it is
  /// paused; the last wrench is zero.
  void start(const Pose& X_FM, Hand hand);
  void stop();  ///< at once, whatever the rate; the last snapshot stays, without its wrench
  bool running() const;
  /// Sets the device pose; the newest call wins; lock-free. It has no effect where the servo was
  /// started with a hand.
  void set_device_pose(const Pose& X_FM);
  /// Acts from the next tick on, over a tenth of a second; see GainGlide.
  void set_coupling(const Coupling& coupling);
  // These act from the next tick on, and stay over a restart.
  void set_rate(double rate_hz);
  void set_passivity_control(bool on);
  void set_budget_us(double time_us);  ///< ServoSettings::budget.microseconds
  /// Whether rows say where the geometry's time went (RowsUsed::phases); off at first.
  void set_time_phases(bool on);
  /// A paused loop keeps its threads and its last snapshot, and computes nothing.
  void set_paused(bool paused);
  /// False: no force from the next tick on, whatever the contact. True: the force rises from zero.
  void set_force(bool on);
  /// The newest snapshot, valid until the next call; lock-free. Null before the first tick.
  const Snapshot* latest();
  /// The timing so far, valid until the next call; lock-free.
  const ServoTiming& timing();
  /// Gives every tick of this run in order, for plots and recordings. At the beginning of each
  /// pause it gives the last tick again, as `paused`. False where there is none left. The last 4 s
  /// at 1 kHz are kept for a reader that is late; beyond that, ticks are dropped and counted. There
  /// must be one reader: each tick is given once. Lock-free.
  bool next_tick(Snapshot& out);
  std::uint64_t ticks_dropped() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sonde
