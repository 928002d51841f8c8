// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/platform/terminal.hpp"

#include <unistd.h>

namespace sonde {

bool error_stream_is_terminal() noexcept { return ::isatty(STDERR_FILENO) == 1; }

}  // namespace sonde
