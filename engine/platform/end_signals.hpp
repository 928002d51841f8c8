// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sonde {

/// Calls the handler where the user or the system tells the program to end (SIGINT, SIGTERM):
/// always, or the first time alone, after which a signal ends it as ever. The handler may run in
/// any thread, in the middle of anything: it may set a lock-free atomic, or call
/// EndPipe::tell_from_handler() or end_at_once().
enum class HandledSignals { all, first };
void on_end_signal(void (*handler)(int), HandledSignals which) noexcept;

/// From now on, writing to a pipe that nobody reads fails instead of ending the program.
void survive_broken_pipes() noexcept;

/// Ends the process without a destructor. May be called from a handler.
[[noreturn]] void end_at_once(int exit_code) noexcept;

/// Brings the word of a signal to a loop that waits for descriptors. Made once; it stays open.
struct EndPipe {
  /// The descriptor that becomes readable; negative where this system has none.
  static int open() noexcept;
  static void tell_from_handler() noexcept;
};

}  // namespace sonde
