// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace sonde {

/// When the ticks of a periodic loop are due. Times are nanoseconds of one monotonic clock.
struct Schedule {
  std::int64_t period = 1'000'000;
  std::int64_t due = 0;  ///< due time of the tick now running, or of the next one

  /// Ends the tick that was due and moves on to the next. Returns whether the tick was past its
  /// deadline, which is the next one's start. One lost period is made up for. After a longer delay
  /// the schedule starts again from now, because a burst of ticks would feed the hand an old motion
  /// in fast forward.
  bool finish(std::int64_t now) {
    due += period;
    const bool late = now > due;
    if (now > due + period) due = now;
    return late;
  }
};

/// Ticks per second, over windows of 100 ms.
class RateMeter {
 public:
  /// Call it when a tick begins. Until the first window is full, the rate is that of the ticks so
  /// far.
  void tick(std::int64_t now) {
    if (ticks_++ == 0) {
      begin_ = now;
      return;
    }
    const std::int64_t elapsed = now - begin_;
    if (elapsed <= 0 || (full_ && elapsed < window)) return;
    rate_ = static_cast<double>(ticks_ - 1) * 1e9 / static_cast<double>(elapsed);
    if (elapsed < window) return;
    full_ = true;
    begin_ = now;
    ticks_ = 1;
  }
  double rate() const { return rate_; }  ///< Hz; 0 before the second tick

 private:
  static constexpr std::int64_t window = 100'000'000;
  std::int64_t begin_ = 0;
  std::int64_t ticks_ = 0;  ///< in this window, including the one that began it
  double rate_ = 0;
  bool full_ = false;
};

}  // namespace sonde
