// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "engine/mending/repairs.hpp"

namespace sonde {

/// The repairs, one sentence each, without a full stop: "1 triangle turned to agree with its
/// neighbours". Empty if there were none.
std::vector<std::string> sentences(const Repairs& repairs);

}  // namespace sonde
