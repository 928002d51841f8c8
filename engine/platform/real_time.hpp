// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sonde {

/// The scheduling that the system granted to a loop with deadlines.
struct RealTime {
  bool scheduled = false;  ///< this thread runs before all ordinary ones (SCHED_FIFO)
  /// No memory of the process is paged out (mlockall): the existing memory and, if the limit on
  /// locked memory permits, future memory too.
  bool locked = false;
  /// Static text: what was granted, or why not and what would permit it. "": not requested.
  const char* scheduling = "";
  const char* memory = "";
  const char* processor = "";
};

/// The threads of a loop with deadlines, for request_processor().
enum class LoopThread { servo, geometry };

/// The processor reserved for a thread of the loop, among those that the process may use: the last
/// one, and the one before. None (-1) if there are only two or fewer: other threads need one.
int processor_for(LoopThread thread, const int* allowed, int count) noexcept;
/// Binds the calling thread to that processor. Returns static text: what was done, or why not.
const char* request_processor(LoopThread thread) noexcept;

/// Touches the pages of the calling thread's stack that a tick may need, so that none causes a page
/// fault in a tick.
void touch_stack() noexcept;

/// The calling thread's name in the system's tools (top -H); up to 15 letters.
void name_thread(const char* name) noexcept;

/// The calling thread, and those that it starts, take about a tenth of a processor that others
/// want.
void stand_back() noexcept;

/// Requests both, for the calling thread and for the process. May wait; do not call it in a tick.
RealTime request_real_time() noexcept;

/// Requests that the calling thread run before all ordinary ones, but after those of
/// request_real_time(). For work that may not end: with a single processor, it only requests a
/// greater share. Returns false if that is not permitted.
bool request_precedence() noexcept;

/// While it exists, the calling thread runs before all ordinary ones and those of
/// request_precedence(), but after the servo's. For a thread that mostly waits for a device, and
/// whose delay the hand feels. Not used with a single processor, which a device that sends without
/// pause would occupy.
class Promptness {
 public:
  explicit Promptness(bool wanted) noexcept;
  ~Promptness();  ///< an ordinary thread again
  Promptness(const Promptness&) = delete;
  Promptness& operator=(const Promptness&) = delete;

  /// Static text: why not, and what would permit it; "" if it was granted or not wanted.
  const char* words() const noexcept { return words_; }

 private:
  bool granted_ = false;
  const char* words_ = "";
};

}  // namespace sonde
