// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/study/trade/trade_results.hpp"

namespace sonde {

/// The answers of another program at the poses of a study, for its picture.
struct TradeSeries {
  std::string name;
  std::vector<double> errors;  ///< |depth / reference − 1|, ascending; infinite where it gave none
  std::vector<double> times;   ///< µs, ascending
};

/// Reads them: CSV `series,pose,depth,time_us`, the pose by its place in poses.csv, depths in m,
/// empty where there is none. The reference is the study's PD_g at that pose; poses that the study
/// leaves out are left out here. Throws InputError with the file, the line and the reason.
std::vector<TradeSeries> read_trade_series(const std::filesystem::path& file,
                                           const TradeResults& results);

}  // namespace sonde
