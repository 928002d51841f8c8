// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "engine/study/parts/study_parts.hpp"

namespace sonde {

/// The final files of `sonde tune`: `map.csv`, `map.svg`, `coupling.json`, which a scene can
/// include (absent if no stiffness is good), and `recommendation.json`, which gives the reasons.
/// Depends only on the study's folder, so the bits are the same wherever its parts were computed.
/// Throws InputError if a part is missing or was not written by a study; `folder` is for the
/// message.
std::vector<StudyFile> tuning_files(const std::string& folder, const StudyFolder& study);

}  // namespace sonde
