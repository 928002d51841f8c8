// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sonde::app {

/// From here on an interrupt (Ctrl-C) ends the program at once with exit code 130. All results are
/// kept in memory until they are whole, so nothing has been written then.
void catch_interrupts();

/// From here on an interrupt is ignored: what is being written becomes whole.
void finish_despite_interrupts();

}  // namespace sonde::app
