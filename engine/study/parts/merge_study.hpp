// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>

#include "engine/study/parts/study_parts.hpp"

namespace sonde {

/// The parts of several folders of one study, together: what an unsplit run would have left. Throws
/// InputError where the folders hold different studies, where a part is in none of them, or where
/// two have different results for it; the parts are named. Times (members named time_us) may
/// differ: those of the first folder are kept.
StudyFolder merge_studies(std::span<const std::filesystem::path> folders);

/// Writes a complete study into a folder, which is made where there is none, as compute_parts
/// leaves it. Throws InputError where the folder holds another study or cannot be written.
void write_study(const std::filesystem::path& folder, const StudyFolder& study);

}  // namespace sonde
