// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/trade/trade_report.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/study/trade/trade_chart.hpp"
#include "engine/text/number_text.hpp"

namespace sonde {
namespace {

using Json = nlohmann::ordered_json;
using Figures = std::vector<TradeFigures>;
using Figure = double TradeFigures::*;

constexpr TradeKind kinds[] = {TradeKind::search, TradeKind::bound, TradeKind::tick};

/// Unknown values are left empty.
std::string text_of(double value, int digits = 17) {
  return std::isfinite(value) ? number_text(value, digits) : std::string();
}

std::string joined(const std::vector<std::string>& fields, const char* separator) {
  std::string out;
  for (const std::string& field : fields)
    out.append(&field == &fields.front() ? "" : separator).append(field);
  return out;
}
std::string csv_line(const std::vector<std::string>& fields) { return joined(fields, ",") + "\n"; }
std::string md_line(const std::vector<std::string>& fields) {
  return std::string("| ").append(joined(fields, " | ")).append(" |\n");
}

std::string trade_csv(const TradeResults& results) {
  std::string out = "pose,kind,method,budget,depth,reference,error,iterations,time_us\n";
  for (std::size_t i = 0; i < results.poses.size(); ++i) {
    const TradePose& pose = results.poses[i];
    for (const TradeRun& run : pose.runs) {
      const TradeSetting& s = run.setting;
      out += csv_line({std::to_string(i), name_of(s.kind), name_of(s.method),
                       std::to_string(s.budget), text_of(run.depth),
                       text_of(pose.reference(s.method)), text_of(error_of(pose, run)),
                       std::to_string(run.iterations), text_of(run.time_us)});
    }
  }
  return out;
}

std::string extremes_csv(const TradeResults& results) {
  std::string out = "world,kind,method,pose,change\n";
  for (const TradeExtreme& extreme : results.extremes)
    for (std::size_t i = 0; i < extreme.change.size(); ++i)
      out += csv_line({extreme.world, name_of(extreme.kind), name_of(extreme.method),
                       std::to_string(i), text_of(extreme.change[i])});
  return out;
}

std::string poses_csv(const TradeResults& results) {
  std::string out = "px,py,pz,qw,qx,qy,qz\n";
  for (const TradePose& pose : results.poses) {
    std::vector<std::string> fields;
    for (const double number : pose.pose) fields.push_back(text_of(number));
    out += csv_line(fields);
  }
  return out;
}

struct Column {
  const char* key;
  const char* unit;
  const char* doc;
  Figure figure;
  bool of_ticks = false;  ///< not meaningful for a few poses
};
constexpr Column columns[] = {
    {"median_error", "", "median error, %", &TradeFigures::median},
    {"p90_error", "", "90th percentile, %", &TradeFigures::p90},
    {"worst_error", "", "worst, %", &TradeFigures::worst},
    {"within_1_percent", "", "within 1 %, %", &TradeFigures::within_1},
    {"within_5_percent", "", "within 5 %, %", &TradeFigures::within_5},
    {"unconverged", "", "not converged, %", &TradeFigures::unconverged, true},
    {"median_us", "us", "median µs", &TradeFigures::time_median},
    {"p99_us", "us", "p99 µs", &TradeFigures::time_p99},
    {"p999_us", "us", "p99.9 µs", &TradeFigures::time_p999, true},
};

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json json_of(const TradeReference& reference) {
  return {{"median_spread", number_or_null(reference.median)},
          {"p90_spread", number_or_null(reference.p90)},
          {"worst_spread", number_or_null(reference.worst)}};
}

std::string summary_json(const TradeResults& results, const Figures& all) {
  Json units = Json::object(), settings = Json::array(), extremes = Json::array();
  for (const Column& column : columns)
    if (*column.unit != 0) units[column.key] = column.unit;
  for (const TradeFigures& f : all) {
    Json json{{"kind", name_of(f.setting.kind)},
              {"method", name_of(f.setting.method)},
              {"budget", f.setting.budget},
              {"count", f.count},
              {"failed", f.failed}};
    for (const Column& column : columns) json[column.key] = number_or_null(f.*column.figure);
    settings.push_back(json);
  }
  for (const TradeExtreme& extreme : results.extremes) {
    const ExtremeFigures f = figures_of(extreme);
    extremes.push_back({{"world", extreme.world},
                        {"kind", name_of(extreme.kind)},
                        {"method", name_of(extreme.method)},
                        {"failed", f.failed},
                        {"median_change", number_or_null(f.median)},
                        {"worst_change", number_or_null(f.worst)}});
  }
  const Json whole{{"scene", results.scene},
                   {"poses", results.poses.size()},
                   {"reference",
                    {{"pdg", json_of(trade_reference(results, Method::pdg))},
                     {"pdt", json_of(trade_reference(results, Method::pdt))}}},
                   {"units", units},
                   {"settings", settings},
                   {"extremes", extremes}};
  return whole.dump(2) + "\n";
}

std::string summary_csv(const Figures& all) {
  std::vector<std::string> names = {"kind", "method", "budget", "count", "failed"};
  for (const Column& column : columns) names.emplace_back(column.key);
  std::string out = csv_line(names);
  for (const TradeFigures& f : all) {
    std::vector<std::string> fields = {name_of(f.setting.kind), name_of(f.setting.method),
                                       std::to_string(f.setting.budget), std::to_string(f.count),
                                       std::to_string(f.failed)};
    for (const Column& column : columns) fields.push_back(text_of(f.*column.figure));
    out += csv_line(fields);
  }
  return out;
}

std::string md_table(const Figures& figures, bool of_ticks) {
  std::vector<Column> shown;
  for (const Column& column : columns)
    if (of_ticks || !column.of_ticks) shown.push_back(column);
  std::vector<std::string> names = {"budget", "count", "failed"};
  for (const Column& column : shown) names.emplace_back(column.doc);
  std::string out = md_line(names) + md_line(std::vector<std::string>(names.size(), "---"));
  for (const TradeFigures& f : figures) {
    std::vector<std::string> fields = {
        f.setting.budget > 0 ? std::to_string(f.setting.budget) : "none", std::to_string(f.count),
        std::to_string(f.failed)};
    for (const Column& column : shown)  // a time is shown as it is, a share in per cent
      fields.push_back(text_of((*column.unit != 0 ? 1 : 100) * (f.*column.figure), 3));
    out += md_line(fields);
  }
  return out;
}

std::string extremes_md(const TradeResults& results) {
  std::string out =
      "\n## The same answers from bodies 2^-20 and 2^20 times as large, and far away\n\n" +
      md_line({"bodies", "what", "failed", "median change, %", "worst, %"}) +
      md_line(std::vector<std::string>(5, "---"));
  for (const TradeExtreme& extreme : results.extremes) {
    const ExtremeFigures f = figures_of(extreme);
    out +=
        md_line({extreme.world, std::string(name_of(extreme.kind)) + " " + title_of(extreme.method),
                 std::to_string(f.failed), text_of(100 * f.median, 3), text_of(100 * f.worst, 3)});
  }
  return out;
}

const char* title_of(TradeKind kind) {
  switch (kind) {
    case TradeKind::search:
      return "Static search, steps";
    case TradeKind::bound:
      return "Lower bound, counted work";
    case TradeKind::tick:
      break;
  }
  return "Coherent ticks, counted work";
}

std::string summary_md(const TradeResults& results, const Figures& all) {
  std::string out = "# " + results.scene + ": accuracy against time\n\n" +
                    std::to_string(results.poses.size()) + " poses. The reference repeats to ";
  for (const Method method : traded_methods) {
    const TradeReference r = trade_reference(results, method);
    out += text_of(100 * r.p90, 3) + " % on nine of ten (the worst: " + text_of(100 * r.worst, 3) +
           " %) for " + title_of(method) + (method == Method::pdg ? ", " : ".\n");
  }
  for (const TradeKind kind : kinds)
    for (const Method method : traded_methods) {
      const Figures some = figures_of(all, kind, method);
      if (some.empty()) continue;
      out += std::string("\n## ") + title_of(kind) + ": " + title_of(method) + "\n\n" +
             md_table(some, kind == TradeKind::tick);
    }
  return results.extremes.empty() ? out : out + extremes_md(results);
}

}  // namespace

std::vector<StudyFile> trade_files(const TradeResults& results) {
  const Figures all = trade_figures(results);
  return {{"trade.svg", trade_picture(results, all)},   {"trade.csv", trade_csv(results)},
          {"extremes.csv", extremes_csv(results)},      {"poses.csv", poses_csv(results)},
          {"summary.json", summary_json(results, all)}, {"summary.csv", summary_csv(all)},
          {"summary.md", summary_md(results, all)}};
}

std::vector<StudyFile> trade_files(const std::string& folder, const StudyFolder& study) {
  return trade_files(read_trade(folder, study));
}

}  // namespace sonde
