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

/// Bounds that end a measurement when they are exceeded.
struct PulseBounds {
  double force = 0, torque = 0;  ///< N, N·m: a command is never larger, whatever the plan says
  double travel = 0.03;          ///< m, of the handle from its start
  double turn = 0.9;             ///< rad, the same
  // Largest motion of the handle in the last third of a rest. More than a creeping handle moves,
  // and less than a hand moves.
  double rest_travel = 5e-4;  ///< m
  double rest_turn = 0.02;    ///< rad
};
/// The bounds for a plan with these limits: three times the intended travel.
PulseBounds bounds_of(const PulsePlan& plan, const PulseLimits& limits);

/// Why there are no more pulses.
enum class PulsesEnd {
  none,      ///< there are more pulses
  done,      ///< the plan has been played
  stopped,   ///< by stop()
  withheld,  ///< the loop withheld the force: PulseProgress::withheld says why
  lost,      ///< the device is gone, or its pose cannot be true
  restless,  ///< the handle moved during a rest: it is held, or drifts
  held,      ///< a larger pulse moved it much less than a smaller one
  drifted,   ///< it is too far from its start
};
/// A sentence for the user; "" for none and done.
const char* words(PulsesEnd end);

struct PulseProgress {
  PulsesEnd end = PulsesEnd::none;
  Withheld withheld = Withheld::nothing;  ///< if the loop ended the pulses
  std::size_t sample = 0, samples = 0;    ///< played, and of the whole plan
  std::size_t pulse = 0, pulses = 0;      ///< begun, and of the whole plan
};

/// Plays a plan of pulses to a handle and records its response. A handle that still moves when a
/// pulse is due gets up to four more rests. The player ends by itself if the handle does not move
/// as a free handle does; from then on it requests no force.
class PulsePlayer {
 public:
  /// Allocates everything that it needs.
  PulsePlayer(const PulsePlan& plan, const PulseBounds& bounds);
  PulsePlayer(const PulsePlayer&) = delete;
  PulsePlayer& operator=(const PulsePlayer&) = delete;

  // For the servo thread, in this order in each tick: no allocation, lock, log, throw.
  /// The wrench to render at t (s), with the handle measured at X_BH. The next call reads the
  /// loop's answer from it.
  HandTrial& next(double t, const Pose& X_BH, bool trusted) noexcept;
  /// The wrench that was rendered: recorded as the command of this tick.
  void rendered(const Wrench& wrench) noexcept;

  // From any other thread.
  /// No force is requested from the next tick on.
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
  std::size_t watched_rest_;  ///< samples at the end of a rest that are checked
  std::size_t longest_wait_;  ///< samples by which a rest may be extended
  std::size_t left_to_wait_;  ///< remaining samples of extension, for all rests
  std::vector<Wrench> commands_;
  std::vector<Timed> pulses_;

  // Used by the servo thread only, until the end.
  HandTrial trial_;
  ResponseSample now_;
  bool asked_ = false;  ///< next() was called, and rendered() was not yet
  Pose start_, last_, rest_;
  std::size_t place_ = 0;            ///< the next sample of the plan
  std::size_t pulse_ = 0;            ///< the current or the next one
  std::size_t waited_ = 0;           ///< samples before that pulse that are not in the plan
  double excursion_ = 0;             ///< m | rad, of the current pulse along its axis
  std::array<double, 6> largest_{};  ///< of the earlier pulses, for each axis
  Response rows_;

  std::atomic<std::size_t> played_{0};   ///< rows
  std::atomic<std::size_t> reached_{0};  ///< the furthest place_, for others
  std::atomic<PulsesEnd> end_{PulsesEnd::none};
  std::atomic<Withheld> withheld_{Withheld::nothing};
  std::atomic<bool> stopping_{false};
};

}  // namespace sonde
