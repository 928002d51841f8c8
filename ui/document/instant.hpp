// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/haptics/loop/background_search.hpp"
#include "engine/haptics/loop/clearance_gauge.hpp"
#include "engine/haptics/loop/lessened.hpp"
#include "engine/haptics/loop/servo.hpp"

namespace sonde::ui {

/// One moment, as plain data: everything that overlays, numbers and plots show of it, whether the
/// servo computes it now or a recording holds it. The gains are the snapshot's own.
struct Instant {
  Snapshot snapshot;
  /// The newest search that had ended by then, with what the loop followed to (with_followed).
  std::optional<BackgroundResult> searched;
  bool live = true;  ///< false: from a recording
  /// The newest that was measured, of this device pose or one just before.
  std::optional<GaugedClearance> clearance = {};
};

inline Instant instant_of(const Snapshot& snapshot, const BackgroundResult* searched, bool live) {
  Instant now{.snapshot = snapshot, .searched = {}, .live = live};
  if (searched) now.searched = with_followed(*searched, snapshot.separation);
  return now;
}

inline bool same_pose(const Pose& a, const Pose& b) {
  return a.p == b.p && a.q.coeffs() == b.q.coeffs();
}

/// The search's result for this device pose; null where it was about another.
inline const BackgroundResult* searched_here(const Instant& now) {
  const bool here = now.searched && same_pose(now.searched->device, now.snapshot.separation.device);
  return here ? &*now.searched : nullptr;
}

/// The clearance at this device pose, where the probe is free; null where it is held, or not known.
inline const GaugedClearance* clearance_here(const Instant& now) {
  const Separation& s = now.snapshot.separation;
  const bool here =
      s.status == Status::separated && now.clearance && same_pose(now.clearance->device, s.device);
  return here ? &*now.clearance : nullptr;
}

/// Returns whether the picture of b would look like that of a. That of the past says its time.
inline bool same_picture(const Instant& a, const Instant& b) {
  const Snapshot &x = a.snapshot, &y = b.snapshot;
  return a.live == b.live && (a.live || x.time == y.time) &&
         x.separation.status == y.separation.status &&
         same_pose(x.separation.device, y.separation.device) &&
         same_pose(x.separation.separated, y.separation.separated) &&
         (clearance_here(a) == nullptr) == (clearance_here(b) == nullptr) &&
         x.wrench.force == y.wrench.force && x.wrench.torque == y.wrench.torque &&
         x.paused == y.paused && x.hand.withheld == y.hand.withheld &&
         force_lessened(x.wrench, x.hand, x.coupling) ==
             force_lessened(y.wrench, y.hand, y.coupling);
}

}  // namespace sonde::ui
