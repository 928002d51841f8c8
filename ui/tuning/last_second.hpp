// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "engine/geometry/chart.hpp"
#include "engine/geometry/mass.hpp"
#include "engine/haptics/loop/servo.hpp"

namespace sonde::ui {

/// Figures of the last second of the servo in the hand.
struct Buzz {
  double chatter = 0;  ///< chatter_index, 0 to 1
  double energy = 0;   ///< J, net work on the hand; below zero where the hand gave it
};

/// Collects the ticks of the last second of one probe, in order, for these figures.
class LastSecond {
 public:
  /// A new probe: its ticks start over.
  void take(const MassProperties& probe);
  /// A tick earlier than the last one, or long after it, is the first of another second.
  void add(const Snapshot& tick);
  /// None before there is about a second of ticks. Takes some milliseconds.
  std::optional<Buzz> buzz() const;
  /// |F| on the hand of the ticks of the last so many seconds, N, the oldest first.
  std::vector<double> forces(double seconds) const;

 private:
  struct Tick {
    double time;   ///< s
    Vec6 wrench;   ///< on the hand
    double given;  ///< J, since the start
  };
  double length_ = 0;  ///< m, as in press_and_hold
  std::deque<Tick> ticks_;
};

}  // namespace sonde::ui
