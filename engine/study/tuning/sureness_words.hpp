// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "engine/study/tuning/gain_recommendation.hpp"

namespace sonde {

/// How sure the gains of an axis are, in sentences for people: what each value of the profile that
/// is not sure makes of them, and which one limits them most; or that no value was varied.
std::vector<std::string> sureness_in_words(const TuningResults& results, GainAxis axis);

}  // namespace sonde
