// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/base/effort.hpp"

namespace sonde {

/// A time limit that long work checks between its steps; by default there is none.
struct Deadline {
  double microseconds = 0;  ///< 0: none
  double started = 0;       ///< from now_us()
  /// Whether the time is over, or will be over in `ahead` µs.
  bool passed(double ahead = 0) const {
    return microseconds > 0 && now_us() - started + ahead > microseconds;
  }
  /// The limit as an effort, for work that can stop at any point.
  Effort effort() const { return {0, microseconds > 0 ? started + microseconds : 0}; }
  /// A deadline with the same start and a share of the time.
  Deadline part(double share) const { return {share * microseconds, started}; }
};

}  // namespace sonde
