// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/haptics/coupling/coupling.hpp"

namespace sonde {

/// Largest rate of change of the wrench on a handle from causes other than the hand's own motion:
/// the rise after a start, and the change to other gains, another mode or another scene. A hand
/// with the stiffness K is moved no faster than that rate over K: at 10 N/s 0.05 m/s for the light
/// hand of a study, 200 N/m. A softer one yields, which slows the rate down (HandLoop).
struct ChangeRate {
  double force = 10;    ///< N/s; 0: no limit
  double torque = 0.1;  ///< N·m/s; 0: no limit
};

/// The rate `of_hand`, converted to the probe, and first limited so that a change from zero to
/// max_force (max_torque) takes at least a second. The hand gets the probe's wrench times `ratio`
/// (`turn_ratio`); 0: unknown, taken as 1.
ChangeRate change_rate_at_probe(const ChangeRate& of_hand, double max_force, double max_torque,
                                double ratio, double turn_ratio) noexcept;

/// The share of a change that a step of time (s) may make, at most 1.
double share_of_change(const Wrench& change, const ChangeRate& rate, double step) noexcept;

}  // namespace sonde
