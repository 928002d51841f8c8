// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "engine/geometry/mass.hpp"
#include "ui/document/instant.hpp"

namespace sonde::ui {

/// The part of one snapshot that an export writes. Poses, points and directions are in the fixed
/// body's mesh frame; units are SI.
struct ExportedInstant {
  double time = 0;  ///< s since the start of the servo or of the recording
  Pose probe;       ///< X_FM, the pose at which the probe is drawn
  Separation separation;
  Wrench wrench;
  std::optional<BackgroundResult> searched = {};  ///< from this device pose
  std::optional<double> clearance = {};           ///< m at this device pose; see signed_clearance
};

ExportedInstant exported_instant_of(const Instant& instant);

/// The motion of the probe from the device pose to the separated pose, in `steps` steps of equal
/// time (at least one) that last one second together.
std::vector<ExportedInstant> separation_in_steps(const Snapshot& snapshot,
                                                 const MassProperties& probe, int steps);

}  // namespace sonde::ui
