// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/base/triple_buffer.hpp"
#include "engine/haptics/hand/hand.hpp"

namespace sonde {

/// A hand that holds the probe exactly at its target and feels nothing: a mouse without a device.
///
/// A dragged mouse delivers a target only every many ticks. The probe moves to a new target in the
/// time that has passed since the target before it, so it moves a little in every tick, as with a
/// device, and contacts between close-fitting parts are followed in short steps. It lags behind the
/// newest target by at most longest_pause, unless it waits. The first target after a pause of the
/// loop is taken at once.
///
/// Nobody holds a handle here, so the probe may wait: where the loop is behind it, it moves more
/// slowly, and stands as long as the force would be withheld. It catches up afterwards.
class DirectHand {
 public:
  /// s: the longest time for the way to a target.
  static constexpr double longest_pause = 0.2;
  /// s: the longest time that the probe stands for the loop's sake, until the loop is no longer
  /// behind. Answers to some bodies never converge, and the probe must go on.
  static constexpr double longest_wait = 0.2;

  explicit DirectHand(const Pose& X_FM) : from_(X_FM), to_(X_FM), targets_(X_FM) {}

  /// Functions for the servo; this object must outlive it.
  Hand hand() {
    return {.sample = [this](double dt) { return HandSample{.X_FM = next(dt)}; },
            .render = {},
            .follow = [this](double behind) { behind_ = behind; }};
  }
  /// To be called from one other thread; the newest call wins.
  void set_target(const Pose& X_FM) { targets_.write(X_FM); }

 private:
  /// The probe's pose `dt` (s) after the last call.
  Pose next(double dt) noexcept;
  Pose now() const noexcept;

  /// The share of its speed at which the probe moves, by how far the loop is behind.
  double pace(double dt) noexcept;
  double part() const noexcept;  ///< of the way to the newest target that is done

  Pose from_, to_;
  double since_ = longest_pause;  ///< s since the newest target
  double gone_ = 0;               ///< s of the motion to it, without the time of waiting
  double duration_ = 0;           ///< s: duration of that motion
  double mouse_ = 0;              ///< s: the time in which the mouse went the same way
  double behind_ = 0;             ///< see Hand::follow
  double waited_ = 0;             ///< s since the loop was last not behind
  TripleBuffer<Pose> targets_;
};

}  // namespace sonde
