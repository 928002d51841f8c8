// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>
#include <algorithm>
#include <optional>

#include "engine/haptics/loop/background_search.hpp"
#include "ui/document/instant.hpp"

namespace sonde::ui {

/// Decides when to request a background search for the probe's pose. PD_t and the lower bound take
/// longer than a tick. While the probe moves they get a hundredth of the time, because the servo
/// and the picture need the machine. Times are in ms of one monotonic clock.
class SearchSchedule {
 public:
  /// Forgets everything about the shown pose.
  void forget() { newest_.reset(); }
  /// The result was found while nobody wanted it, or before.
  void pass_over(const BackgroundResult& result) {
    passed_over_ = result.device;
    newest_.reset();
  }
  /// Whether a result counts while the probe is there: not one that was passed over, unless the
  /// probe is where that was found.
  bool takes(const BackgroundResult& result, const Pose& device) const {
    return !passed_over_ || !same_pose(result.device, *passed_over_) ||
           same_pose(device, *passed_over_);
  }
  void answered(const BackgroundResult& result) {
    passed_over_.reset();
    newest_ = result;
    due_ = asked_ + std::max(pause, static_cast<qint64>(1e-2 * result.time_us));
  }
  /// Returns whether to request a search for this pose now; if so, counts it as requested.
  bool asks(const Pose& device, qint64 now) {
    if (!same_pose(device, seen_at_)) {
      seen_at_ = device;
      rests_since_ = now;
    }
    const bool rests = now - rests_since_ > pause && !same_pose(device, asked_about_);
    if (!rests && now < due_) return false;
    if (newest_ && same_pose(newest_->device, device)) return false;
    asked_about_ = device;
    asked_ = now;
    due_ = now + 10 * pause;
    return true;
  }
  const std::optional<BackgroundResult>& newest() const { return newest_; }

 private:
  static constexpr qint64 pause = 100;  // between two searches, and of a probe that rests
  std::optional<BackgroundResult> newest_;
  qint64 due_ = 0, asked_ = 0, rests_since_ = 0;
  Pose seen_at_, asked_about_;
  std::optional<Pose> passed_over_;
};

}  // namespace sonde::ui
