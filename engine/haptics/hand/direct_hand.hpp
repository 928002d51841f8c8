// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/base/triple_buffer.hpp"
#include "engine/haptics/hand/hand.hpp"

namespace sonde {

/// A hand that holds the probe exactly at its target and feels nothing: a mouse without a device.
class DirectHand {
 public:
  explicit DirectHand(const Pose& X_FM) : targets_(X_FM) {}

  /// Functions for the servo; this object must outlive it.
  Hand hand() {
    return {.sample =
                [this](double /*dt*/) {
                  targets_.update();
                  return HandSample{.X_FM = targets_.front()};
                },
            .render = {}};
  }
  /// To be called from one other thread; the newest call wins.
  void set_target(const Pose& X_FM) { targets_.write(X_FM); }

 private:
  TripleBuffer<Pose> targets_;
};

}  // namespace sonde
