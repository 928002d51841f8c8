// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/trade/trade_front.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "engine/study/trade/trade_report.hpp"
#include "engine/text/number_text.hpp"

namespace sonde {
namespace {

TradePose scaled(TradePose pose, double by) {
  for (std::vector<double>* found : {&pose.long_pdg, &pose.long_pdt})
    for (double& depth : *found) depth *= by;
  for (TradeRun& run : pose.runs) run.depth *= by;
  return pose;
}

/// The largest depth of the path with that method and no budget; 0 if there is none.
double deepest(const TradeResults& pair, Method method) {
  double out = 0;
  for (const TradePath& path : pair.paths)
    if (path.setting == TradeSetting{TradeKind::tick, method, 0})
      for (const double depth : path.depth) out = std::fmax(out, depth);
  return out;
}

void add_paths(TradeResults& all, const TradeResults& pair) {
  for (const TradePath& path : pair.paths) {
    const double most = deepest(pair, path.setting.method);
    if (!(most > 0)) continue;
    auto at = std::ranges::find(all.paths, path.setting, &TradePath::setting);
    if (at == all.paths.end()) at = all.paths.insert(at, {path.setting, {}, {}, {}});
    for (const double depth : path.depth) at->depth.push_back(depth / most);
    at->converged.insert(at->converged.end(), path.converged.begin(), path.converged.end());
    at->time_us.insert(at->time_us.end(), path.time_us.begin(), path.time_us.end());
  }
}

void add_extremes(TradeResults& all, const TradeResults& pair) {
  for (const TradeExtreme& extreme : pair.extremes) {
    auto at = std::ranges::find_if(all.extremes, [&](const TradeExtreme& other) {
      return other.world == extreme.world && other.kind == extreme.kind &&
             other.method == extreme.method;
    });
    if (at == all.extremes.end())
      all.extremes.push_back(extreme);
    else
      at->change.insert(at->change.end(), extreme.change.begin(), extreme.change.end());
  }
}

/// A name as a CSV field, without separators.
std::string field(std::string name) {
  std::ranges::replace_if(
      name, [](char c) { return c == ',' || c == '"' || c == '\n' || c == '\r'; }, ' ');
  return name;
}

std::string exact_text(double value) { return std::isfinite(value) ? number_text(value, 17) : ""; }

std::string pairs_csv(std::span<const TradeResults> pairs) {
  std::string out =
      "pair,kind,method,budget,count,median_error,p90_error,within_1_percent,median_us\n";
  for (const TradeResults& pair : pairs)
    for (const TradeFigures& f : trade_figures(pair)) {
      out.append(field(pair.scene)).append(",").append(name_of(f.setting.kind));
      out.append(",").append(name_of(f.setting.method));
      out.append(",").append(std::to_string(f.setting.budget));
      out.append(",").append(std::to_string(f.count));
      for (const double value : {f.median, f.p90, f.within_1, f.time_median})
        out.append(",").append(exact_text(value));
      out += "\n";
    }
  return out;
}

}  // namespace

TradeResults pooled(std::span<const TradeResults> pairs) {
  TradeResults all;
  all.scene = std::to_string(pairs.size()) + " pairs";
  all.radius = 1;
  if (!pairs.empty()) all.settings = pairs.front().settings;
  for (const TradeResults& pair : pairs) {
    for (const TradePose& pose : pair.poses) all.poses.push_back(scaled(pose, 1 / pair.radius));
    add_paths(all, pair);
    add_extremes(all, pair);
  }
  return all;
}

std::vector<StudyFile> front_files(std::span<const TradeResults> pairs) {
  std::vector<StudyFile> out;
  for (StudyFile& file : trade_files(pooled(pairs))) {
    if (file.name == "trade.svg") file.name = "front.svg";
    if (file.name == "front.svg" || file.name.starts_with("summary."))
      out.push_back(std::move(file));
  }
  out.push_back({"pairs.csv", pairs_csv(pairs)});
  return out;
}

}  // namespace sonde
