// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/penetration/search/pair.hpp"
#include "engine/scene/poses.hpp"
#include "engine/study/parts/study_parts.hpp"

namespace sonde {

/// What `sonde trade` measures: how much accuracy less time costs, on one pair of bodies.
struct TradeSetup {
  Pair pair;
  std::vector<Pose> poses = {};      ///< X_FM at which they overlap; searched one by one
  std::vector<TimedPose> path = {};  ///< followed tick by tick; may be empty
  std::string scene = {};            ///< its name, for titles
  std::uint64_t seed = 1;
  std::string inputs = "{}";  ///< JSON object: what tells the input files and the program apart
};

/// The study. A part for each pose: what it takes as the reference, some long searches with seeds
/// of their own, then the static search of both methods and the lower bound, each with budgets from
/// small to none. A part for each method and budget of a tick that follows the path. One for the
/// answers of bodies that are tiny, huge or far away. All budgets are counted work: only the times
/// differ from run to run. A part runs on one thread.
Study trade_study(const TradeSetup& setup);

}  // namespace sonde
