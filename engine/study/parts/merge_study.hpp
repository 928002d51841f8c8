// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>

#include "engine/study/parts/study_parts.hpp"

namespace sonde {

/// Joins the parts of several folders of one study into the result of an unsplit run. Throws
/// InputError if the folders hold different studies, if a part is in none of them, or if two have
/// different results for it; the message names the parts. Times (members named time_us) may differ:
/// those of the first folder are kept.
StudyFolder merge_studies(std::span<const std::filesystem::path> folders);

/// Writes a complete study into a folder in the form of compute_parts, and creates the folder if
/// necessary. Throws InputError if the folder holds another study or cannot be written.
void write_study(const std::filesystem::path& folder, const StudyFolder& study);

}  // namespace sonde
