// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/study/parts/study_parts.hpp"
#include "engine/study/tuning/gain_recommendation.hpp"

namespace sonde {

/// The results of the finished parts for one axis; no value if they have no sweep of it with the
/// unchanged profile. Parts still to come can only lower the limits. Errors as for read_tuning.
std::optional<TuningResults> tuning_so_far(const std::string& folder, const StudyFolder& study,
                                           GainAxis axis);

/// The recommended gains and their limit, for a terminal: "k 344 N/m, limited by friction (flat
/// contact, light hand)"; or that no stiffness is good, and why.
std::string gains_in_words(const TuningResults& results);

/// "limited by stability without friction (flat contact, light hand)".
std::string limit_in_words(const GainLimit& limit);
/// Why no stiffness is passive; empty where some is, or nothing is recommended.
std::string passivity_in_words(const TuningResults& results, const AxisGains& gains);
/// What the trial of rest found, and what would help where nothing rests; no sentence if there was
/// no trial.
std::vector<std::string> rest_in_words(const TuningResults& results, const AxisGains& gains);

/// The same as a sentence; and, where they apply: that the gains rely on friction, why no virtual
/// damping is best, that theory has a lower limit, and which assumption limits, with the
/// recommendation at both ends.
std::vector<std::string> recommendation_in_words(const TuningResults& results);

}  // namespace sonde
