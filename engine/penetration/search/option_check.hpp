// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/penetration/search/static_options.hpp"

namespace sonde {

/// Throws InputError, naming the option, if one is outside its range, or the budget is not valid.
void check(const StaticOptions& options);

}  // namespace sonde
