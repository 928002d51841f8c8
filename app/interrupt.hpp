// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sonde::app {

/// From here on an interrupt (Ctrl-C) ends the program at once with exit code 130. All results are
/// kept in memory until they are whole, so nothing has been written then.
void catch_interrupts();

/// From here on an interrupt is ignored: what is being written becomes whole.
void finish_despite_interrupts();

/// From here on an interrupt is noted and ends nothing by itself: for work that keeps what it has
/// finished, and asks in between whether it is to stop.
void note_interrupts();
bool interrupt_noted();

}  // namespace sonde::app
