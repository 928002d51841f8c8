// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <optional>

#include "engine/haptics/loop/servo.hpp"

namespace sonde::ui {

/// What nine in ten of the last ticks in contact keep to.
struct Reached {
  /// The part of the depth that the geometry's answer may be too deep by. It is 1 − √(1 − r²) with
  /// r the residual: exact where the contacts are flat, and 1 where time ended before any contact
  /// was known.
  double within = 0;
  double rows_us = 0;    ///< time that the geometry took
  double tick_us = 0;    ///< time that the servo's own tick took
  double converged = 0;  ///< share of these ticks
  /// The mean time of each phase in a tick: the geometry's, and as `couple` the servo's own tick.
  PhaseTimes phases;
};

/// Collects the last ticks in contact, in order.
class ReachedAccuracy {
 public:
  static constexpr std::size_t most = 120;  ///< ticks: two seconds of pictures
  static constexpr std::size_t least = 20;  ///< before that there is no answer

  /// A tick earlier than the last one is the first of others. Paused ticks and those out of contact
  /// do not count.
  void add(const Snapshot& tick);
  void clear() { ticks_.clear(); }
  std::optional<Reached> reached() const;

 private:
  struct Tick {
    double time, within, rows_us, tick_us;
    bool converged;
    PhaseTimes phases;
  };
  std::deque<Tick> ticks_;
};

}  // namespace sonde::ui
