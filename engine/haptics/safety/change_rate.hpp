// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/haptics/coupling/coupling.hpp"

namespace sonde {

/// How fast the wrench on a handle may change by what is not the hand's own motion: as it rises
/// after a start, and on the way to other gains, another mode or another scene. A hand that holds
/// by a spring K is moved no faster than that rate over K: 0.05 m/s for the lightest hand that is
/// studied, 200 N/m, at 10 N/s.
struct ChangeRate {
  double force = 10;    ///< N/s; 0: no limit
  double torque = 0.1;  ///< N·m/s; 0: no limit
};

/// The same, but never faster than the whole of these limits in a second, and as of the probe,
/// whose wrench the hand gets `ratio` (`turn_ratio`) times; where that is 0, it is not known: once.
ChangeRate change_rate_at_probe(const ChangeRate& of_hand, double max_force, double max_torque,
                                double ratio, double turn_ratio) noexcept;

/// The share of a change that a step of time (s) may make of it, at most 1.
double share_of_change(const Wrench& change, const ChangeRate& rate, double step) noexcept;

}  // namespace sonde
