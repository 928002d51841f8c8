// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/trade/trade_results.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "engine/base/error.hpp"
#include "engine/base/numbers.hpp"
#include "engine/base/ordering.hpp"
#include "engine/base/quantile.hpp"

namespace sonde {
namespace {

using Json = nlohmann::ordered_json;

/// Share of the probe's radius: smaller depths have no meaningful error (see allowed_clearance).
constexpr double least_depth = 1e-6;

// ---- the parts as JSON ----

template <class Value>
Value named(const std::string& name, std::initializer_list<Value> values) {
  for (const Value value : values)
    if (name == name_of(value)) return value;
  throw std::invalid_argument("unknown name " + name);
}

/// JSON has no NaN: a failure is null.
double number(const Json& json) { return json.is_null() ? no_number : json.get<double>(); }

std::vector<double> numbers(const Json& json) {
  std::vector<double> out;
  for (const Json& each : json) out.push_back(number(each));
  return out;
}

Json json_of(const TradeSetting& setting) {
  return {{"kind", name_of(setting.kind)},
          {"method", name_of(setting.method)},
          {"budget", setting.budget}};
}

TradeSetting setting_of(const Json& json) {
  return {named(json.at("kind").get<std::string>(),
                {TradeKind::search, TradeKind::bound, TradeKind::tick}),
          named(json.at("method").get<std::string>(), {Method::pdg, Method::pdt}),
          json.at("budget").get<std::int64_t>()};
}

TradePose pose_of(const Json& json) {
  TradePose out;
  out.pose = json.at("pose").get<std::array<double, 7>>();
  out.long_pdg = numbers(json.at("long_pdg"));
  out.long_pdt = numbers(json.at("long_pdt"));
  for (const Json& run : json.at("runs"))
    out.runs.push_back({setting_of(run), number(run.at("depth")), run.at("iterations").get<int>(),
                        run.at("time_us").get<double>()});
  return out;
}

TradePath path_of(const Json& json) {
  TradePath out{setting_of(json), numbers(json.at("depth")),
                json.at("converged").get<std::vector<char>>(), numbers(json.at("time_us"))};
  if (out.depth.size() != out.converged.size() || out.depth.size() != out.time_us.size())
    throw std::invalid_argument("columns of different length");
  return out;
}

TradeExtreme extreme_of(const Json& json) {
  const TradeSetting setting = setting_of(json);
  return {json.at("world").get<std::string>(), setting.kind, setting.method,
          numbers(json.at("change"))};
}

// ---- the figures ----

/// The errors and times of one setting.
struct Samples {
  std::vector<double> errors, times;
  std::size_t failed = 0, unconverged = 0;

  void add(double error, double time_us, bool converged) {
    const bool bad = !std::isfinite(error);
    errors.push_back(bad ? infinity : error);
    times.push_back(time_us);
    failed += bad;
    unconverged += !converged;
  }
};

Samples samples_of(const TradeResults& results, const TradeSetting& setting) {
  Samples out;
  for (const TradePose& pose : results.poses) {
    if (!is_deep_enough(results, pose)) continue;
    for (const TradeRun& run : pose.runs)
      if (run.setting == setting) out.add(error_of(pose, run), run.time_us, true);
  }
  return out;
}

const TradePath* path_with(const TradeResults& results, const TradeSetting& setting) {
  const auto at = std::ranges::find(results.paths, setting, &TradePath::setting);
  return at == results.paths.end() ? nullptr : &*at;
}

Samples ticks_of(const TradeResults& results, const TradeSetting& setting) {
  Samples out;
  const TradePath* path = path_with(results, setting);
  const TradePath* whole = path_with(results, {setting.kind, setting.method, 0});
  if (!path || !whole || path->depth.size() != whole->depth.size()) return out;
  double deepest = 0;
  for (const double depth : whole->depth) deepest = std::fmax(deepest, depth);
  for (std::size_t i = 0; i < path->depth.size(); ++i) {
    const double got = path->depth[i], wanted = whole->depth[i];
    if (got == 0 && wanted == 0) continue;
    out.add(got == wanted ? 0 : std::abs(got - wanted) / deepest, path->time_us[i],
            path->converged[i] != 0);
  }
  return out;
}

double share_up_to(const std::vector<double>& sorted, double most) {
  const auto end = std::ranges::upper_bound(sorted, most);
  return static_cast<double>(end - sorted.begin()) / static_cast<double>(sorted.size());
}

TradeFigures figures(const TradeSetting& setting, Samples samples) {
  ordering::sort(samples.errors);
  ordering::sort(samples.times);
  TradeFigures out{.setting = setting, .count = samples.errors.size(), .failed = samples.failed};
  out.median = quantile(samples.errors, 0.5);
  out.p90 = quantile(samples.errors, 0.9);
  out.worst = quantile(samples.errors, 1);
  out.within_1 = share_up_to(samples.errors, 0.01);
  out.within_5 = share_up_to(samples.errors, 0.05);
  out.unconverged = static_cast<double>(samples.unconverged) / static_cast<double>(out.count);
  out.time_median = quantile(samples.times, 0.5);
  out.time_p99 = quantile(samples.times, 0.99);
  out.time_p999 = quantile(samples.times, 0.999);
  return out;
}

}  // namespace

const char* name_of(TradeKind kind) {
  constexpr std::array names{"static", "bound", "coherent"};
  return names[static_cast<std::size_t>(kind)];
}

const char* title_of(Method method) { return method == Method::pdg ? "PD_g" : "PD_t"; }

double TradePose::reference(Method method) const {
  const auto of = [&](Method which) {
    double least = infinity;
    for (const double depth : which == Method::pdg ? long_pdg : long_pdt)
      least = std::min(least, depth);
    for (const TradeRun& run : runs)
      if (run.setting.kind == TradeKind::search && run.setting.method == which)
        least = std::fmin(least, run.depth);
    return least;
  };
  return method == Method::pdt ? of(Method::pdt) : std::min(of(Method::pdg), of(Method::pdt));
}

double TradePose::spread(Method method) const {
  const std::vector<double>& found = method == Method::pdg ? long_pdg : long_pdt;
  if (found.empty()) return no_number;
  const auto [least, largest] = std::ranges::minmax(found);
  return largest / least - 1;
}

std::string to_json(std::span<const TradeSetting> settings) {
  Json out = Json::array();
  for (const TradeSetting& setting : settings) out.push_back(json_of(setting));
  return out.dump();
}

std::string to_json(const TradePose& pose) {
  Json runs = Json::array();
  for (const TradeRun& run : pose.runs) {
    Json json = json_of(run.setting);
    json["depth"] = run.depth;
    json["iterations"] = run.iterations;
    json["time_us"] = run.time_us;
    runs.push_back(json);
  }
  const Json json{{"pose", pose.pose},
                  {"long_pdg", pose.long_pdg},
                  {"long_pdt", pose.long_pdt},
                  {"runs", runs}};
  return json.dump(1) + "\n";
}

std::string to_json(const TradePath& path) {
  Json json = json_of(path.setting);
  json["depth"] = path.depth;
  json["converged"] = path.converged;
  json["time_us"] = path.time_us;
  return json.dump() + "\n";
}

std::string to_json(std::span<const TradeExtreme> extremes) {
  Json all = Json::array();
  for (const TradeExtreme& extreme : extremes) {
    Json json = json_of(TradeSetting{extreme.kind, extreme.method, 0});
    json["world"] = extreme.world;
    json["change"] = extreme.change;
    all.push_back(json);
  }
  return Json{{"extremes", all}}.dump(1) + "\n";
}

TradeResults read_trade(const std::string& folder, const StudyFolder& study) {
  TradeResults out;
  std::string reading = "study.json";
  try {
    const Json about = Json::parse(study.about);
    out.scene = about.at("scene").get<std::string>();
    out.radius = about.at("radius").get<double>();
    for (const Json& setting : about.at("settings")) out.settings.push_back(setting_of(setting));
    for (std::size_t i = 0; i < study.names.size(); ++i) {
      reading = "part " + study.names[i];
      if (!study.results[i]) throw std::out_of_range("it is missing");
      const Json part = Json::parse(*study.results[i]);
      if (part.contains("extremes"))
        for (const Json& extreme : part.at("extremes")) out.extremes.push_back(extreme_of(extreme));
      else if (part.contains("runs"))
        out.poses.push_back(pose_of(part));
      else
        out.paths.push_back(path_of(part));
    }
  } catch (const std::exception& error) {  // nlohmann's, or one of the above
    throw InputError::in(folder, reading + " is not what a trade study writes: " + error.what());
  }
  return out;
}

bool is_deep_enough(const TradeResults& results, const TradePose& pose) {
  return pose.reference(Method::pdg) > least_depth * results.radius;
}

double error_of(const TradePose& pose, const TradeRun& run) {
  if (run.setting.kind == TradeKind::bound) return 1 - run.depth / pose.reference(Method::pdg);
  return run.depth / pose.reference(run.setting.method) - 1;
}

std::vector<TradeFigures> trade_figures(const TradeResults& results) {
  std::vector<TradeFigures> out;
  for (const TradeSetting& setting : results.settings)
    out.push_back(figures(setting, setting.kind == TradeKind::tick ? ticks_of(results, setting)
                                                                   : samples_of(results, setting)));
  return out;
}

std::vector<TradeFigures> figures_of(const std::vector<TradeFigures>& all, TradeKind kind,
                                     Method method) {
  std::vector<TradeFigures> out;
  for (const TradeFigures& f : all)
    if (f.setting.kind == kind && f.setting.method == method) out.push_back(f);
  return out;
}

ExtremeFigures figures_of(const TradeExtreme& extreme) {
  ExtremeFigures out;
  std::vector<double> changes;
  for (const double change : extreme.change) {
    if (std::isfinite(change))
      changes.push_back(std::abs(change));
    else
      ++out.failed;
  }
  ordering::sort(changes);
  out.median = quantile(changes, 0.5);
  out.worst = quantile(changes, 1);
  return out;
}

TradeReference trade_reference(const TradeResults& results, Method method) {
  std::vector<double> spreads;
  for (const TradePose& pose : results.poses)
    if (is_deep_enough(results, pose) && std::isfinite(pose.spread(method)))
      spreads.push_back(pose.spread(method));
  ordering::sort(spreads);
  return {quantile(spreads, 0.5), quantile(spreads, 0.9), quantile(spreads, 1)};
}

}  // namespace sonde
