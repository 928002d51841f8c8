// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/study/parts/study_parts.hpp"
#include "engine/study/tuning/gain_words.hpp"

namespace sonde {

/// The results of the finished parts for one axis; no value if they have no sweep of it with the
/// unchanged profile. Parts still to come can only lower the limits. Errors as for read_tuning.
std::optional<TuningResults> tuning_so_far(const std::string& folder, const StudyFolder& study,
                                           GainAxis axis);

/// The recommended gains and their limit, for a terminal: "k 344 N/m, limited by friction (flat
/// contact, light hand)"; or that no stiffness is good, and why.
std::string gains_in_words(const TuningResults& results);

/// Why no stiffness is passive; empty where some is, or nothing is recommended.
std::string passivity_in_words(const TuningResults& results, const AxisGains& gains);
/// What the trial of rest found, and what would help where nothing rests; no sentence if there was
/// no trial.
std::vector<std::string> rest_in_words(const TuningResults& results, const AxisGains& gains);

/// The gains of one axis in sentences for people, the same in the terminal and in the window, and
/// in this order: what is recommended; in which hands it was held; what limits it, and where theory
/// and the sweeps see limits; what happens if the hand lets go; how sure that is; how a wall at
/// these gains feels. Of an axis that is swept alone, what concerns the recommendation is left out.
std::vector<std::string> axis_in_words(const TuningResults& results, GainAxis axis);
/// The same of all that is recommended.
std::vector<std::string> recommendation_in_words(const TuningResults& results);

}  // namespace sonde
