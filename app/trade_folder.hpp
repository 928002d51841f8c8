// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace sonde::app {

/// The scenes of a folder, NAME.sonde.json, by name. Throws InputError where there is none.
std::vector<std::filesystem::path> scenes_in(const std::filesystem::path& folder);

/// The name of a scene's folder in the result: NAME.
std::string folder_name(const std::filesystem::path& scene);

/// Writes the front over the studies of the trade in the folders of `out`, and returns true; false
/// where one of them is not complete yet. `names` are theirs.
bool write_front(const std::filesystem::path& out, const std::vector<std::string>& names);

/// True where the folder holds folders with studies, and is none itself.
bool holds_studies(const std::filesystem::path& folder);

/// Merges what several such folders hold, one study after another, by `merge`(folders, out); then
/// writes the front. Throws InputError where a study is in none of them complete.
void merge_fronts(
    const std::vector<std::string>& folders, const std::filesystem::path& out,
    const std::function<void(const std::vector<std::string>&, const std::string&)>& merge);

}  // namespace sonde::app
