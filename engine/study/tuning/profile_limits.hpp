// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/study/tuning/gain_recommendation.hpp"

namespace sonde {

/// Adds the limits that follow from the profile, not from the runs: "driver", "resolution" and
/// "rendered". `device`: its values by key, one of which may be varied.
void add_profile_limits(const TuningResults& results, const std::vector<const TuningLine*>& lines,
                        const std::map<std::string, double>& device, GainAxis axis, double damping,
                        std::vector<GainLimit>& limits);

}  // namespace sonde
