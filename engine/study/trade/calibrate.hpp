// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/base/progress.hpp"
#include "engine/calibration/calibration.hpp"
#include "engine/scene/poses.hpp"
#include "engine/study/trade/trade.hpp"

namespace sonde {

/// Measures the error of searches with wall-clock limits from 0.5 to 64 ms and with none, at poses
/// where the two overlap. `references` are the depths to compare with, m; if a search finds less,
/// its depth becomes the reference. One thread; two runs never measure the same. Throws Cancelled.
CalibrationSeries calibrate_searches(const Pair& pair, const std::string& name, Method method,
                                     std::span<const Pose> poses, std::vector<double> references,
                                     std::uint64_t seed, const Progress& progress = {});

/// How much deeper a tick's answer is than the one without a limit, over the largest depth of the
/// path. A limit may also lead to another side of a sheet, where the way out is shorter: that is no
/// error. Infinite if one of the two failed: a failed reference confirms nothing, not even an
/// answer that fails too.
double tick_error(double got, double wanted, double deepest);

/// The same for the ticks along a path, with limits from 0.05 to 1.6 ms and none.
CalibrationSeries calibrate_ticks(const Pair& pair, const std::string& name, Method method,
                                  std::span<const TimedPose> path, std::uint64_t seed,
                                  const Progress& progress = {});

/// Both, with both methods, for the input of a trade study. The reference of a pose is the least of
/// three searches without a limit. The path may be empty.
Calibration calibrate(const TradeSetup& setup, const Progress& progress = {});

}  // namespace sonde
