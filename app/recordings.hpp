// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/recording/recording.hpp"

namespace sonde::app {

/// For the user: the content of each recording, whether its end is intact, and whether its meshes
/// are there.
std::string to_text(const std::vector<std::unique_ptr<Recording>>& recordings);
/// {"units": {...}, "recordings": [{...}, ...]}.
std::string to_json(const std::vector<std::unique_ptr<Recording>>& recordings);

}  // namespace sonde::app
