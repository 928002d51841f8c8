// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace sonde {

/// "1ms", "800us", "0.02s" or "0.02": a time in seconds, above zero and finite. `name` is the
/// value's name in the error. Throws InputError.
double time_in(std::string_view text, const std::string& name);

/// "1%" or "0.01": a share, above 0 and below 1. Throws InputError.
double share_in(std::string_view text, const std::string& name);

}  // namespace sonde
