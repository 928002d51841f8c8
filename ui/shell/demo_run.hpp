// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "engine/base/progress.hpp"
#include "engine/penetration/search/pair.hpp"
#include "engine/scene/poses.hpp"
#include "ui/document/kept_ticks.hpp"

namespace sonde::ui {

/// A path run through by the loop in step, tick by tick, with no clock: the same every time.
struct DemoRun {
  std::shared_ptr<KeptTicks> kept;  ///< every tick, with what is searched at the deepest
  double deepest = 0;               ///< s, of the tick that is held furthest from the hand
  bool touches = false;             ///< false: no tick is in contact, and the last one counts
};

/// Runs through the path at its own times and 1 kHz (a path of more than a minute at fewer ticks),
/// and searches the ways out of the deepest pose, without a limit of time. Times that a clock would
/// measure are left out of the ticks. Throws Cancelled.
DemoRun run_demo(const Pair& pair, const std::vector<TimedPose>& path, const Coupling& coupling,
                 const Progress& progress = {});

}  // namespace sonde::ui
