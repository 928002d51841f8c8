// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/platform/terminal.hpp"

namespace sonde {

bool error_stream_is_terminal() noexcept { return false; }

}  // namespace sonde
