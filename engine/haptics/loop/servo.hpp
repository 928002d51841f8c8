// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

#include "engine/haptics/coupling/coupling.hpp"
#include "engine/haptics/loop/hand_loop.hpp"
#include "engine/haptics/loop/time_histogram.hpp"
#include "engine/penetration/contact/separation.hpp"
#include "engine/penetration/search/pair.hpp"
#include "engine/platform/real_time.hpp"

namespace sonde {

/// The result of one tick: plain data, copied through a triple buffer.
struct Snapshot {
  std::uint64_t tick = 0;  ///< ticks since the start
  double time = 0;         ///< s since the start, of the tick's beginning
  /// O, Q, contacts, σ: the local answer for the newest device pose. Q is not tested against the
  /// bodies; hand.rows.separated is.
  Separation separation;
  Wrench wrench;           ///< on the hand, after every limit
  HandState hand;          ///< why there is no force; rows, energy
  Coupling coupling;       ///< the gains of this tick, possibly during a glide
  double tick_us = 0;      ///< computing time of the tick
  double rate_hz = 0;      ///< measured over the last 100 ms or so
  std::uint64_t late = 0;  ///< ticks that began or ended past their deadline, so far
  bool paused = false;     ///< the other fields are of the last tick; a hand's force falls to zero
};

/// How well the servo keeps its deadlines, since the start.
struct ServoTiming {
  TimeHistogram period;    ///< from the beginning of a tick to that of the next
  TimeHistogram tick;      ///< time of a tick, including the device
  TimeHistogram geometry;  ///< time to make the rows
  TimeHistogram age;       ///< age of the rows at the ticks that used them
  std::uint64_t ticks = 0;
  std::uint64_t late = 0;     ///< ticks that began or ended past their deadline
  std::uint64_t in_step = 0;  ///< ticks with rows of the previous tick or younger
  RealTime real_time;
};

struct ServoSettings {
  double rate_hz = 1000;
  /// Limit of the geometry thread for each answer of the solver; its time grows while answers do
  /// not converge (RefreshLimit). It does not limit the servo's own tick: one that ends past its
  /// deadline is only counted (Snapshot::late).
  Budget budget{.steps = 0, .microseconds = 800};
  /// Can be given instead of the time of the budget: the error that nine of ten ticks should not
  /// exceed, as a share of the largest depth; 0: not given. The servo itself uses only the budget;
  /// with_budget() sets the budget from the accuracy.
  double accuracy = 0;
  SafetySettings safety;
  PassivitySettings passivity;
  bool real_time = true;  ///< ask the system for real-time scheduling and locked memory
};

/// The haptic loop in two threads. The servo keeps the rate: each tick samples the pose of the
/// hand, moves the newest contact rows to it, and renders the force. The geometry follows as fast
/// as it can and makes the rows. All functions here must be called from one other thread (the
/// window's).
class Servo {
 public:
  Servo(const Pair& pair, Method method, const Coupling& coupling, const ServoSettings& settings);
  ~Servo();  ///< stops the threads
  Servo(const Servo&) = delete;
  Servo& operator=(const Servo&) = delete;

  /// Starts at X_FM and runs until stop(). If the probe overlaps there, it searches first, which
  /// can take a while. A running servo is stopped first; use this to reset the loop to a pose. The
  /// servo follows set_device_pose().
  void start(const Pose& X_FM);
  /// The same with a hand, which the servo samples and renders to in each tick, even while paused.
  /// The last wrench is zero.
  void start(const Pose& X_FM, Hand hand);
  /// Promptly, at any rate, but for a pressed hand on a known device, whose force falls gradually,
  /// unless it is switched off (HandLoop::fade). The last snapshot stays, with a zero wrench.
  void stop();
  bool running() const;
  /// Sets the device pose; the newest call wins; lock-free. Has no effect if the servo was started
  /// with a hand.
  void set_device_pose(const Pose& X_FM);
  /// Sets the gains from the next tick on, over a tenth of a second; see GainGlide.
  void set_coupling(const Coupling& coupling);
  // These act from the next tick on, and persist over a restart.
  void set_rate(double rate_hz);
  void set_passivity_control(bool on);
  void set_budget_us(double time_us);  ///< ServoSettings::budget.microseconds
  /// Whether rows report where the geometry's time went (RowsUsed::phases); off initially.
  void set_time_phases(bool on);
  /// A paused loop keeps its threads and its last snapshot, and computes nothing. The force of a
  /// pressed hand falls gradually, and a loop that goes on meanwhile waits for that.
  void set_paused(bool paused);
  /// False: no force from the next tick on, whatever the contact, also while stop() or a pause lets
  /// it fall; any thread may say so. True: the force rises from zero.
  void set_force(bool on);
  /// The newest snapshot, valid until the next call; lock-free. Null before the first tick.
  const Snapshot* latest();
  /// The timing so far, valid until the next call; lock-free.
  const ServoTiming& timing();
  /// Returns every tick of this run in order, for plots and recordings. At the beginning of each
  /// pause it returns the last tick again, as `paused`. False if there is none left. A late reader
  /// finds the last 4 s at 1 kHz; older ticks are dropped and counted. There must be only one
  /// reader: each tick is returned once. Lock-free.
  bool next_tick(Snapshot& out);
  std::uint64_t ticks_dropped() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sonde
