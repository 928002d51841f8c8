// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "engine/penetration/search/static_search.hpp"
#include "engine/recording/tick_log.hpp"
#include "engine/scene/poses.hpp"

namespace sonde {

/// A device pose that the loop is to be run at, with the gains of that tick.
struct LoopStep {
  TimedPose at;
  Coupling coupling;
  double dt = 0;        ///< s since the last one; 0 where that is not known
  bool begins = false;  ///< the probe is put here: nothing is followed from before
};

/// The device's path of a recording and its gains. A time that passed in a pause, or in ticks that
/// were lost, is not known.
std::vector<LoopStep> steps_of(const TickLog& ticks, const Progress& progress = {});
/// A path with one set of gains.
std::vector<LoopStep> steps_of(std::span<const TimedPose> path, const Coupling& coupling);

struct LoopRun {
  Budget budget;          ///< of a tick
  StaticOptions search;   ///< where the loop begins in contact; its method is that of the loop
  double rate_hz = 1000;  ///< a tick that takes longer than its period is late
};

/// The loop in step over the poses, as `replay` runs it: a tick for each, handed on in its order.
/// The same bits every time where the budgets are of counted work, but for the times.
void run_loop(const Pair& pair, std::span<const LoopStep> steps, const LoopRun& run,
              const std::function<void(const Snapshot&)>& ticked);

}  // namespace sonde
