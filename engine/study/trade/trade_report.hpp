// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "engine/study/trade/trade_results.hpp"

namespace sonde {

/// The files of a trade study:
///
///     trade.svg      error against time of each kind; times of ticks by budget
///     trade.csv      each pose with each setting
///     extremes.csv   each pose where the bodies are tiny, huge or far away
///     poses.csv      the poses, as sonde query reads them
///     summary.json, summary.csv, summary.md    each setting over all poses, or over the path
///
/// The same results give the same bytes; two runs differ only in the times.
std::vector<StudyFile> trade_files(const TradeResults& results);

/// The same from a complete folder of the study; errors as for read_trade.
std::vector<StudyFile> trade_files(const std::string& folder, const StudyFolder& study);

}  // namespace sonde
