// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sonde::app {

/// From here on an interrupt (Ctrl-C, SIGTERM) ends the program at once with exit code 130. All
/// results stay in memory until they are whole, so nothing has been written then. A pipe whose
/// reader has gone (SIGPIPE) is an error of writing.
void catch_interrupts();

/// From here on an interrupt is ignored, so that a file that is being written becomes whole.
void finish_despite_interrupts();

/// From here on an interrupt only sets a flag: for work that keeps its finished parts and checks
/// the flag in between.
void note_interrupts();
bool interrupt_noted();

}  // namespace sonde::app
