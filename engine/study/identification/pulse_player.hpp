// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <vector>

#include "engine/haptics/safety/hand_trial.hpp"
#include "engine/study/identification/pulse_plan.hpp"
#include "engine/study/identification/response.hpp"

namespace sonde {

/// What ends a measurement when it is exceeded.
struct PulseBounds {
  double force = 0, torque = 0;  ///< N, N·m: a command is never larger, whatever the plan says
  double travel = 0.03;          ///< m, of the handle from where it began
  double turn = 0.9;             ///< rad, the same
  // How far the handle may move in the last third of a rest. More than a handle that creeps, and
  // less than what a hand does by itself.
  double rest_travel = 5e-4;  ///< m
  double rest_turn = 0.02;    ///< rad
};
/// Those of a plan that was made for these limits: three times the travel that it intends.
PulseBounds bounds_of(const PulsePlan& plan, const PulseLimits& limits);

/// Why there are no more pulses.
enum class PulsesEnd {
  none,      ///< there are
  done,      ///< the plan has been played
  stopped,   ///< by stop()
  withheld,  ///< the loop withheld the force: PulseProgress::withheld says why
  lost,      ///< the device is gone, or its pose cannot be true
  restless,  ///< the handle moved where it should be at rest: it is held, or drifts
  held,      ///< a larger pulse moved it much less than a smaller one
  drifted,   ///< it is too far from where it began
};
/// A sentence for the user; "" for none and done.
const char* words(PulsesEnd end);

struct PulseProgress {
  PulsesEnd end = PulsesEnd::none;
  Withheld withheld = Withheld::nothing;  ///< of an end that the loop made
  std::size_t sample = 0, samples = 0;    ///< played, and of the whole plan
  std::size_t pulse = 0, pulses = 0;      ///< begun, and of the whole plan
};

/// Plays a plan of pulses to a handle and records its answer. A handle that still moves where a
/// pulse is due gets up to four rests more. It ends by itself where the handle does not move as one
/// that nobody holds; from then on it asks for no force.
class PulsePlayer {
 public:
  /// Allocates all that it needs.
  PulsePlayer(const PulsePlan& plan, const PulseBounds& bounds);
  PulsePlayer(const PulsePlayer&) = delete;
  PulsePlayer& operator=(const PulsePlayer&) = delete;

  // For the servo thread, in this order in each tick: no allocation, lock, log, throw.
  /// What to render at t (s) with the handle measured at X_BH. The loop's answer is taken from it
  /// by the next call.
  HandTrial& next(double t, const Pose& X_BH, bool trusted) noexcept;
  /// What was rendered: recorded as the command of this tick.
  void rendered(const Wrench& wrench) noexcept;

  // From any other thread.
  /// No force from the next tick on.
  void stop() noexcept { stopping_.store(true, std::memory_order_relaxed); }
  PulseProgress progress() const noexcept;
  /// The recording so far. Call it after the end.
  Response response() const;

 private:
  PulsesEnd watch(double t, const Pose& X_BH, bool trusted) noexcept;
  bool restless(const Pose& X_BH) noexcept;
  bool held(const Pose& X_BH) noexcept;
  void finish(PulsesEnd end) noexcept;

  struct Timed {
    Pulse pulse;
    std::size_t begin = 0, end = 0;  ///< in samples; one past the last
  };
  PulseBounds bounds_;
  std::size_t watched_rest_;  ///< samples at the end of a rest
  std::size_t longest_wait_;  ///< samples more that a rest may take
  std::size_t left_to_wait_;  ///< samples, of all rests
  std::vector<Wrench> commands_;
  std::vector<Timed> pulses_;

  // The servo thread's own, until the end.
  HandTrial trial_;
  ResponseSample now_;
  bool asked_ = false;  ///< next() was called and rendered() not yet
  Pose start_, last_, rest_;
  std::size_t place_ = 0;            ///< the next sample of the plan
  std::size_t pulse_ = 0;            ///< the present or the coming one
  std::size_t waited_ = 0;           ///< samples, before that pulse, that are not in the plan
  double excursion_ = 0;             ///< m | rad, of the present pulse along its axis
  std::array<double, 6> largest_{};  ///< of the pulses before, for each axis
  Response rows_;

  std::atomic<std::size_t> played_{0};   ///< rows
  std::atomic<std::size_t> reached_{0};  ///< the furthest place_, for others
  std::atomic<PulsesEnd> end_{PulsesEnd::none};
  std::atomic<Withheld> withheld_{Withheld::nothing};
  std::atomic<bool> stopping_{false};
};

}  // namespace sonde
