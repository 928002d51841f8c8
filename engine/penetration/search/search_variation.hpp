// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "engine/penetration/search/search_tuning.hpp"

namespace sonde {

/// The numbers of SearchTuning that can be named, for studies of what each is worth.
std::vector<std::string> names_of_search_tuning();
/// The same names in one text, separated by commas, for help and messages.
std::string list_of_search_tuning();

/// Another value for one of them: "NAME=VALUE". Throws std::invalid_argument, with the reason,
/// where there is no such name (it lists those there are), or the value is no number of its kind,
/// or below zero.
void vary(SearchTuning& tuning, const std::string& assignment);

}  // namespace sonde
