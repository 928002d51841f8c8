// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace sonde {

/// µs of a clock that never goes back.
inline double now_us() {
  using namespace std::chrono;
  return duration<double, std::micro>(steady_clock::now().time_since_epoch()).count();
}

/// A clock that long work asks between its steps; none: never out of time.
struct Deadline {
  double microseconds = 0;  ///< 0: none
  double started = 0;       ///< from now_us()
  /// `ahead`: or will be in so many µs.
  bool passed(double ahead = 0) const {
    return microseconds > 0 && now_us() - started + ahead > microseconds;
  }
};

}  // namespace sonde
