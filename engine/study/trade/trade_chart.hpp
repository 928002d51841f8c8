// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "engine/study/trade/trade_results.hpp"
#include "engine/study/trade/trade_series.hpp"

namespace sonde {

/// SVG: the error of searches, bounds and ticks against their time, median and 90th percentile,
/// with the repeatability of the reference; and the time of a tick against its budget. `all` are
/// the figures of the results, `others` the answers of other programs at the poses.
std::string trade_picture(const TradeResults& results, const std::vector<TradeFigures>& all,
                          const std::vector<TradeSeries>& others = {});

}  // namespace sonde
