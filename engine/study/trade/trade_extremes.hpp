// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/penetration/search/pair.hpp"
#include "engine/study/parts/study_parts.hpp"
#include "engine/study/trade/trade_results.hpp"

namespace sonde {

/// How the answers change if the same two bodies are 2^-20 or 2^20 times as large, or if both
/// meshes lie 10⁴ radii of the probe away from their origins. Nothing should change except by
/// rounding. At each pose, runs the static search of both methods and the lower bound, without a
/// budget and with one seed. Throws Cancelled.
std::vector<TradeExtreme> measure_extremes(const Pair& pair, std::span<const Pose> poses,
                                           std::uint64_t seed, const Stop& stop);

}  // namespace sonde
