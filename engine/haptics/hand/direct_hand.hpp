// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/base/triple_buffer.hpp"
#include "engine/haptics/hand/hand.hpp"

namespace sonde {

/// Holds the probe exactly at its target, and feels nothing: the mouse without a device.
class DirectHand {
 public:
  explicit DirectHand(const Pose& X_FM) : targets_(X_FM) {}

  /// For the servo; this object must outlive it.
  Hand hand() {
    return {.sample =
                [this](double /*dt*/) {
                  targets_.update();
                  return HandSample{.X_FM = targets_.front()};
                },
            .render = {}};
  }
  /// From one other thread; the newest wins.
  void set_target(const Pose& X_FM) { targets_.write(X_FM); }

 private:
  TripleBuffer<Pose> targets_;
};

}  // namespace sonde
