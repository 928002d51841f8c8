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

/// The calling thread's name in the system's tools (top -H); up to 15 letters.
void name_thread(const char* name) noexcept;

/// Asks for both, for the calling thread and for the process. May wait; not to be called in a tick.
RealTime request_real_time() noexcept;

/// Asks for the calling thread to run before all ordinary ones, but behind those of
/// request_real_time(). For work that may have no end: where there is a single processor, only a
/// greater share of it is asked for. False where that is not permitted.
bool request_precedence() noexcept;

/// While it lives the calling thread runs before all ordinary ones and those of
/// request_precedence(), but behind the servo's: for one that waits for a device most of the time,
/// and whose delay the hand feels. Not for a single processor, which a device that floods would
/// take.
class Promptness {
 public:
  explicit Promptness(bool wanted) noexcept;
  ~Promptness();  ///< an ordinary thread again
  Promptness(const Promptness&) = delete;
  Promptness& operator=(const Promptness&) = delete;

  /// Static text: why not, and what would allow it; "" where it was granted or not wanted.
  const char* words() const noexcept { return words_; }

 private:
  bool granted_ = false;
  const char* words_ = "";
};

}  // namespace sonde
