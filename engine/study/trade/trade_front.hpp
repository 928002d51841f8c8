// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "engine/study/trade/trade_results.hpp"

namespace sonde {

/// The results of several pairs as one. Lengths are in units of the probe's radius, and those of a
/// path in units of its largest depth, so the figures (trade_figures) are those of all poses and of
/// all ticks together. The settings are those of the first pair; the others must have the same.
TradeResults pooled(std::span<const TradeResults> pairs);

/// The front over several pairs: `front.svg` as trade.svg, `summary.json`, `.csv` and `.md` of all
/// of them together, and `pairs.csv` with the searches of each.
std::vector<StudyFile> front_files(std::span<const TradeResults> pairs);

}  // namespace sonde
