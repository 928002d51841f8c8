// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/terminal.hpp"

#include <cstdio>

#include "engine/text/printable.hpp"

namespace sonde::ui {

void tell_terminal(std::string_view text) {
  std::fprintf(stderr, "sonde-view: %s\n", printable(text).c_str());
}

}  // namespace sonde::ui
