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
  std::vector<double> errors;  ///< |depth / reference − 1|, ascending; infinite without an answer
  std::vector<double> times;   ///< µs, ascending
};

/// One answer of another program.
struct TradeAnswer {
  std::string series;
  std::size_t pose;  ///< of the study
  double depth;      ///< m; infinite without an answer
  double time_us;
};

/// Reads such answers: CSV `series,pose,depth,time_us`, with the pose's index in poses.csv and
/// depths in m, empty without an answer. Throws InputError with the file, the line and the reason,
/// also if the study has no such pose.
std::vector<TradeAnswer> read_trade_answers(const std::filesystem::path& file, std::size_t poses);

/// The reference is the study's PD_g at the pose; poses that the study leaves out are left out here
/// too.
std::vector<TradeSeries> trade_series(const std::vector<TradeAnswer>& answers,
                                      const TradeResults& results);

}  // namespace sonde
