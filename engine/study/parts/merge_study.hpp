// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>

#include "engine/study/parts/study_parts.hpp"

namespace sonde {

/// Joins the parts of several folders of one study into what an unsplit run would have left. Throws
/// InputError where the folders hold different studies, where a part is in none of them, or where
/// two have different results for it; the message names the parts. Times (members named time_us)
/// may differ: those of the first folder are kept.
StudyFolder merge_studies(std::span<const std::filesystem::path> folders);

/// Writes a complete study into a folder as compute_parts leaves it, and makes the folder if
/// necessary. Throws InputError where the folder holds another study or cannot be written.
void write_study(const std::filesystem::path& folder, const StudyFolder& study);

}  // namespace sonde
