// SPDX-License-Identifier: GPL-3.0-or-later
// Results of a study of the trade that nobody ran.
#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "engine/study/trade/trade_results.hpp"

namespace sonde::test {

/// Four poses with a depth of 1 m, searched with a budget and bounded; a path with a budget and
/// without. What it comes to is in trade_results_test.cpp.
inline TradeResults made_up_trade() {
  const TradeSetting search{TradeKind::search, Method::pdg, 8};
  const TradeSetting bound{TradeKind::bound, Method::pdg, 5000};
  const TradeSetting tick{TradeKind::tick, Method::pdg, 2000};
  const TradeSetting whole{TradeKind::tick, Method::pdg, 0};
  TradeResults out{"made up", 0.5, {search, bound, tick, whole}, {}, {}, {}};
  const double failed = std::numeric_limits<double>::quiet_NaN();
  const double found[] = {1, 1.02, 1.1, failed};
  for (int i = 0; i < 4; ++i) {
    TradePose pose;
    pose.pose = {0.1 * i, 0, 0.3, 1, 0, 0, 0};
    pose.long_pdg = {1, i == 3 ? 1.1 : 1};
    pose.long_pdt = {1.5};
    pose.runs = {{search, found[i], 8, 10.0 * (i + 1)}, {bound, 0.5 + 0.25 * (i % 2), 0, 3}};
    out.poses.push_back(pose);
  }
  out.paths = {{tick, {0, 1, 1, 2.03, 5}, {1, 0, 1, 1, 1}, {1, 2, 3, 4, 5}},
               {whole, {0, 0, 1, 2, 4}, {1, 1, 1, 1, 1}, {2, 4, 6, 8, 10}}};
  out.extremes = {{"far", TradeKind::search, Method::pdg, {0.25, -0.5, failed, 0}},
                  {"tiny", TradeKind::search, Method::pdg, {0, 0, 0, 0}}};
  return out;
}

/// The complete folder of a study that measured this.
inline StudyFolder folder_of(const TradeResults& results) {
  StudyFolder out{"trade",
                  R"({"scene": ")" + results.scene + R"(", "radius": )" +
                      std::to_string(results.radius) + R"(, "settings": )" +
                      to_json(results.settings) + "}",
                  {},
                  {}};
  for (const TradePath& path : results.paths) out.results.emplace_back(to_json(path));
  for (const TradePose& pose : results.poses) out.results.emplace_back(to_json(pose));
  out.results.emplace_back(to_json(results.extremes));
  for (std::size_t i = 0; i < out.results.size(); ++i)
    out.names.push_back("part-" + std::to_string(i));
  return out;
}

}  // namespace sonde::test
