// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "engine/geometry/mass.hpp"
#include "engine/haptics/loop/servo.hpp"

namespace sonde::ui {

/// The part of one snapshot that an export writes. Poses, points and directions are in the fixed
/// body's mesh frame; units are SI.
struct ExportedInstant {
  double time = 0;  ///< s since the start of the servo or of the recording
  Pose probe;       ///< X_FM, the pose at which the probe is drawn
  Separation separation;
  Wrench wrench;
};

ExportedInstant exported_instant_of(const Snapshot& snapshot);

/// The motion of the probe from the device pose to the separated pose, in `steps` steps of equal
/// time (at least one) that last one second together.
std::vector<ExportedInstant> separation_in_steps(const Snapshot& snapshot,
                                                 const MassProperties& probe, int steps);

}  // namespace sonde::ui
