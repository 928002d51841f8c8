// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "engine/geometry/chart.hpp"
#include "engine/geometry/mass.hpp"
#include "engine/haptics/loop/servo.hpp"
#include "engine/study/stability/chatter.hpp"

namespace sonde::ui {

/// Figures of the last second of the servo in the hand.
struct Buzz {
  bool loop = false;  ///< the force moves what holds the probe; with a mouse it does not
  Chatter chatter;    ///< none without a loop
  double energy = 0;  ///< J, net work on the hand; below zero where the hand gave it
  // Of the last tick: see HandState.
  bool capped = false, waiting = false;
  GainGlide::Blend rendered = {};  ///< those set, unless they wait
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
    double time;    ///< s
    Pose com;       ///< of the probe
    Wrench wrench;  ///< on the hand
    double given;   ///< J, since the start
  };

  Vec3 com_ = Vec3::Zero();             ///< of the probe, in its mesh frame, m
  std::optional<DeviceTraits> device_;  ///< of the last one, where the force moves it
  double length_ = 0;                   ///< m, as in press_and_hold
  std::deque<Tick> ticks_;
  bool capped_ = false, waiting_ = false;
  GainGlide::Blend rendered_;
};

}  // namespace sonde::ui
