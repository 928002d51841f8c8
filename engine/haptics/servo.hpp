// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

#include "engine/geometry/body.hpp"
#include "engine/haptics/coupling.hpp"
#include "engine/haptics/haptic_loop.hpp"
#include "engine/penetration/separation.hpp"

namespace sonde {

/// What one tick computed: plain data, copied through a triple buffer.
struct Snapshot {
  std::uint64_t tick = 0;  ///< ticks since the start
  double time = 0;         ///< s since the start, of the tick's beginning
  Separation separation;   ///< O, Q, contacts, σ
  Wrench wrench;           ///< after the limits, on the hand
  double tick_us = 0;      ///< time the tick's computation took
  double rate_hz = 0;      ///< measured over the last 100 ms or so
  std::uint64_t late = 0;  ///< ticks that began or ended past their deadline, so far
  bool paused = false;
};

struct ServoSettings {
  double rate_hz = 1000;
  Budget budget{.steps = 0, .microseconds = 800};  ///< for the solver, in each tick
};

/// The servo thread. Everything here is called from one other thread (the window's).
class Servo {
 public:
  Servo(std::shared_ptr<const Body> probe, std::shared_ptr<const Body> fixed, Method method,
        const Coupling& coupling, const ServoSettings& settings);
  ~Servo();  ///< stops the thread
  Servo(const Servo&) = delete;
  Servo& operator=(const Servo&) = delete;

  /// Starts at X_FM (searches where the probe overlaps there: can take a while) and runs until
  /// stop(). A running servo is stopped first: this is how to set the loop back to a pose.
  void start(const Pose& X_FM);
  void stop();  ///< at once, whatever the rate; the last snapshot stays
  bool running() const;
  /// The newest device pose wins; lock-free.
  void set_device_pose(const Pose& X_FM);
  /// Acts on the next tick.
  void set_coupling(const Coupling& coupling);
  /// A paused loop keeps its thread and its last snapshot, and computes nothing.
  void set_paused(bool paused);
  /// The newest snapshot, valid until the next call; lock-free. Null before the first tick.
  const Snapshot* latest();
  /// Every tick of this run in its order, for plots and recordings; false where there is none left.
  /// The last 4 s at 1 kHz are kept for a reader that is late; beyond, ticks are dropped and
  /// counted. Lock-free.
  bool next_tick(Snapshot& out);
  std::uint64_t ticks_dropped() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sonde
