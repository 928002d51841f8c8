// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "engine/haptics/hand/hand.hpp"

namespace sonde {

/// Changes the hand of a running servo. The servo never frees a hand: the switch keeps a replaced
/// hand until the servo no longer uses it.
class HandSwitch {
 public:
  /// The pointers own everything that the hand's functions need.
  explicit HandSwitch(std::shared_ptr<const Hand> first);
  HandSwitch(const HandSwitch&) = delete;
  HandSwitch& operator=(const HandSwitch&) = delete;

  /// The servo's hand, which forwards to the one that is set. A hand's first sample gets dt = 0,
  /// and is `changed` if another hand was used before; its last wrench is zero. This object must
  /// outlive the servo.
  Hand hand();

  // To be called from one other thread.
  /// A paused hand is not sampled: its pose stays. Its first sample after the pause gets dt = 0.
  void set_paused(bool paused) { paused_.store(paused, std::memory_order_relaxed); }
  void set(std::shared_ptr<const Hand> next);
  /// Frees the hands that the servo no longer uses. Call it from time to time.
  void sweep();
  std::size_t kept() const { return kept_.size(); }

 private:
  HandSample sample(double dt) noexcept;

  std::vector<std::shared_ptr<const Hand>> kept_;  ///< in the order they were set
  std::atomic<const Hand*> wanted_;
  std::atomic<const Hand*> used_;  ///< by the servo; one of kept_
  std::atomic<bool> paused_{false};

  // Used by the servo thread only.
  const Hand* held_ = nullptr;  ///< null before its first tick
  HandSample last_;
  bool resting_ = false;  ///< last_ was returned without a sample
};

}  // namespace sonde
