// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace sonde::ui {

/// One line on stderr, behind the program's name; control characters are written out, since the
/// text may hold what a file or a device says, and a terminal would obey it.
void tell_terminal(std::string_view text);

}  // namespace sonde::ui
