// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "engine/study/parts/study_parts.hpp"

namespace sonde {

/// What `sonde tune` ends with: `map.csv`, `map.svg`, `coupling.json`, which a scene can include
/// (not where no stiffness is good), and `recommendation.json`, which says why. A function of the
/// study's folder alone, so the same bits wherever its parts were computed. Throws InputError where
/// a part is missing or is not what a study writes; `folder` is for the complaint.
std::vector<StudyFile> tuning_files(const std::string& folder, const StudyFolder& study);

}  // namespace sonde
