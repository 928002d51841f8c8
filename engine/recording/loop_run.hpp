// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "engine/penetration/search/static_search.hpp"
#include "engine/recording/tick_log.hpp"
#include "engine/scene/poses.hpp"

namespace sonde {

/// A device pose at which to run the loop, with the gains of that tick.
struct LoopStep {
  TimedPose at;
  Coupling coupling;
  double dt = 0;        ///< s since the last one; 0 if unknown
  bool begins = false;  ///< the probe is placed here: nothing is followed from before
};

/// The device's path of a recording, with its gains. Unless they are along a path, the time across
/// a pause and across lost ticks is unknown.
std::vector<LoopStep> steps_of(const TickLog& ticks, const Progress& progress = {});
/// A path with one set of gains.
std::vector<LoopStep> steps_of(std::span<const TimedPose> path, const Coupling& coupling);

struct LoopRun {
  Budget budget;             ///< of a tick
  StaticOptions search;      ///< for starts in contact; its method is that of the loop
  bool time_phases = false;  ///< record where the time of each tick went
  double rate_hz = 1000;     ///< a tick that takes longer than its period is late
};

/// Runs the loop, with geometry and force in the same tick, over the poses, as `replay` does, and
/// calls `ticked` for each tick, in order. With budgets of counted work the bits are the same every
/// time, except for the times.
void run_loop(const Pair& pair, std::span<const LoopStep> steps, const LoopRun& run,
              const std::function<void(const Snapshot&)>& ticked);

}  // namespace sonde
