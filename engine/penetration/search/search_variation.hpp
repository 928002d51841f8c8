// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "engine/penetration/search/search_tuning.hpp"

namespace sonde {

/// The names of the numbers of SearchTuning that can be varied, for studies of their effect.
std::vector<std::string> names_of_search_tuning();
/// The same names in one text, separated by commas, for help and messages.
std::string list_of_search_tuning();

/// Sets one of them to another value: "NAME=VALUE". Throws std::invalid_argument, with the reason,
/// if there is no such name (the message lists them), or if the value is not a number of the right
/// type or is negative.
void vary(SearchTuning& tuning, const std::string& assignment);

}  // namespace sonde
