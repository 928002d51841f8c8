// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/haptics/loop/background_search.hpp"
#include "engine/haptics/loop/servo.hpp"

namespace sonde::ui {

/// One moment, as plain data: everything that overlays, numbers and plots show of it, whether the
/// servo computes it now or a recording holds it. The gains are the snapshot's own.
struct Instant {
  Snapshot snapshot;
  std::optional<BackgroundResult> searched;  ///< the newest search that had ended by then
  bool live = true;                          ///< false: from a recording
};

inline bool same_pose(const Pose& a, const Pose& b) {
  return a.p == b.p && a.q.coeffs() == b.q.coeffs();
}

/// The search's result for this device pose; null where it was about another.
inline const BackgroundResult* searched_here(const Instant& now) {
  const bool here = now.searched && same_pose(now.searched->device, now.snapshot.separation.device);
  return here ? &*now.searched : nullptr;
}

/// Returns whether the picture of b would look like that of a.
inline bool same_picture(const Instant& a, const Instant& b) {
  const Snapshot &x = a.snapshot, &y = b.snapshot;
  return a.live == b.live && x.separation.status == y.separation.status &&
         same_pose(x.separation.device, y.separation.device) &&
         same_pose(x.separation.separated, y.separation.separated) &&
         x.wrench.force == y.wrench.force && x.wrench.torque == y.wrench.torque &&
         x.paused == y.paused;
}

}  // namespace sonde::ui
