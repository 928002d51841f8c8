// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/recording/recording.hpp"

namespace sonde::app {

/// Reads a recording whose scene's paths stay in the folder (anywhere, where that is empty). Throws
/// as read_recording, and InputError where one leads out.
std::unique_ptr<Recording> recording_at(const std::filesystem::path& file,
                                        const std::string& within, const Progress& progress = {});

/// For the user: the content of each recording, whether its end is intact, and whether its meshes
/// are there.
std::string to_text(const std::vector<std::unique_ptr<Recording>>& recordings);
/// {"units": {...}, "recordings": [{...}, ...]}.
std::string to_json(const std::vector<std::unique_ptr<Recording>>& recordings);

}  // namespace sonde::app
