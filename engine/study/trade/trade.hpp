// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/penetration/search/pair.hpp"
#include "engine/penetration/search/search_tuning.hpp"
#include "engine/scene/poses.hpp"
#include "engine/study/parts/study_parts.hpp"

namespace sonde {

/// The input of `sonde trade`: accuracy against time, on one pair of bodies.
struct TradeSetup {
  Pair pair;
  std::vector<Pose> poses = {};      ///< X_FM at which they overlap; searched one by one
  std::vector<TimedPose> path = {};  ///< followed tick by tick; may be empty
  std::string scene = {};            ///< its name, for titles
  std::uint64_t seed = 1;
  /// For the searches with budgets. The searches for the reference use the default tuning.
  SearchTuning tuning = {};
  std::string inputs = "{}";  ///< JSON object that identifies the input files and the program
};

/// The study. Each pose is a part: several long searches with their own seeds, which give the
/// reference, then the static search of both methods and the lower bound, each with budgets from
/// small to none. Each method and tick budget is a part that follows the path. One part has the
/// answers for bodies that are tiny, huge or far away. All budgets are counted work, so only the
/// times differ from run to run. A part runs on one thread.
Study trade_study(const TradeSetup& setup);

}  // namespace sonde
