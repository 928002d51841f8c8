// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sonde {

/// What the system granted of what a loop with deadlines asks for.
struct RealTime {
  bool scheduled = false;  ///< this thread runs before all ordinary ones (SCHED_FIFO)
  bool locked = false;     ///< no memory of the process is paged out (mlockall)
  /// Static text: what was granted, or why not and what would allow it. "": not asked for.
  const char* scheduling = "";
  const char* memory = "";
};

/// Asks for both, for the calling thread and for the process. May wait; not to be called in a tick.
RealTime request_real_time() noexcept;

/// Asks for the calling thread to run before all ordinary ones, but behind those of
/// request_real_time(). For work that may have no end: where there is a single processor, only a
/// greater share of it is asked for. False where that is not permitted.
bool request_precedence() noexcept;

}  // namespace sonde
