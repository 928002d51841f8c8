// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "engine/study/trade/trade_results.hpp"

namespace sonde {

/// SVG: the error of searches, bounds and ticks against the time they take, typical and bad, with
/// what the reference repeats to; and what the budget of a tick does to its time. `all` are the
/// figures of the results.
std::string trade_picture(const TradeResults& results, const std::vector<TradeFigures>& all);

}  // namespace sonde
