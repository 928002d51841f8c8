// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "engine/geometry/mass.hpp"
#include "engine/haptics/loop/servo.hpp"

namespace sonde::ui {

/// What is exported of one instant. Everything is in the fixed body's mesh frame, SI.
struct Moment {
  double time = 0;  ///< s
  Pose probe;       ///< X_FM of the probe as it is drawn
  Separation separation;
  Wrench wrench;
};

Moment moment_of(const Snapshot& snapshot);

/// The separation as a motion: the probe on its way from the device pose to the separated one, in
/// so many steps (at least one) over one second.
std::vector<Moment> separation_in_steps(const Snapshot& snapshot, const MassProperties& probe,
                                        int steps);

}  // namespace sonde::ui
