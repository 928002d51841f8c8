// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/platform/terminal.hpp"

#include <windows.h>

namespace sonde {

bool error_stream_is_terminal() noexcept {
  DWORD mode = 0;
  return GetConsoleMode(GetStdHandle(STD_ERROR_HANDLE), &mode) != 0;
}

}  // namespace sonde
