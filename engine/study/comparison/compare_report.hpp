// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "engine/study/comparison/compare.hpp"

namespace sonde {

/// The files of a comparison:
///
///     wrench.svg     force, torque and depth against time, and their components
///     spectrum.svg   power against frequency
///     wrench.csv     both renderings, tick by tick
///     summary.json, summary.csv, summary.md    the measures and the verdicts
///
/// The same comparison gives the same bytes.
std::vector<StudyFile> compare_files(const Comparison& comparison);

/// The same from a complete folder of the study; `folder` is for error messages. Throws InputError
/// if a part is missing or was not written by a study.
std::vector<StudyFile> compare_files(const std::string& folder, const StudyFolder& study);

}  // namespace sonde
