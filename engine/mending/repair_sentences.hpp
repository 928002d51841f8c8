// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "engine/mending/repairs.hpp"

namespace sonde {

/// What was done, a sentence each, without a full stop: "1 triangle turned to agree with its
/// neighbours". Empty where nothing was.
std::vector<std::string> sentences(const Repairs& repairs);

}  // namespace sonde
