// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "engine/study/parts/study_parts.hpp"

namespace sonde {

/// The final files of `sonde traces`, from its parts only: `traces.csv`, `summary.csv`,
/// `summary.md`, and pictures: `traces.svg`, with a row for each stiffness and a column for each
/// course and damping; with several dampings also a picture for each course, `traces-COURSE.svg`.
/// Errors as for tuning_files.
std::vector<StudyFile> traces_files(const std::string& folder, const StudyFolder& study);

}  // namespace sonde
