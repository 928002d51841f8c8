// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/trade/trade_chart.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/base/elementary.hpp"
#include "engine/base/quantile.hpp"
#include "engine/study/charts/svg_chart.hpp"

namespace sonde {
namespace {

using Figures = std::vector<TradeFigures>;
using Figure = double TradeFigures::*;

constexpr std::size_t pdg_color = 0, pdt_color = 1, reference_color = 7;
std::size_t color_of(Method method) { return method == Method::pdg ? pdg_color : pdt_color; }

/// A logarithmic axis has no 0: smaller values are drawn here, %.
constexpr double least_percent = 1e-3;
double percent(double share) { return std::max(100 * share, least_percent); }

ChartSeries series(const std::string& name, std::size_t color,
                   ChartSeries::Form form = ChartSeries::Form::line) {
  ChartSeries out{name};
  out.color = color;
  out.form = form;
  return out;
}

/// A line with a dot at each point: solid for typical values, dashed for bad ones.
void add_line(ChartPanel& panel, const ChartSeries& line) {
  ChartSeries dots = line;
  dots.name.clear();
  dots.form = ChartSeries::Form::points;
  panel.series.push_back(line);
  panel.series.push_back(dots);
}

void add_errors(ChartPanel& panel, const Figures& figures, Method method, Figure time) {
  if (figures.empty()) return;
  ChartSeries median = series(std::string(title_of(method)) + ", median", color_of(method));
  ChartSeries p90 = series(std::string(title_of(method)) + ", 90th percentile", color_of(method),
                           ChartSeries::Form::dashed);
  for (const TradeFigures& f : figures) {
    median.x.push_back(f.*time);
    median.y.push_back(percent(f.median));
    p90.x.push_back(f.*time);
    p90.y.push_back(percent(f.p90));
  }
  add_line(panel, median);
  add_line(panel, p90);
}

/// The repeatability of the reference: an error below it is meaningless.
void add_repeatability(ChartPanel& panel, const TradeResults& results) {
  const double p90 = trade_reference(results, Method::pdg).p90;
  ChartSeries line = series("reference repeats (90th p.)", reference_color);
  for (const ChartSeries& other : panel.series)
    for (const double x : other.x) line.x.push_back(x);
  if (line.x.empty() || !std::isfinite(p90)) return;
  const auto [from, to] = std::ranges::minmax(line.x);
  line.x = {from, to};
  line.y = {percent(p90), percent(p90)};
  panel.series.push_back(line);
}

/// Extends an axis to whole powers of ten, so that it has numbers.
void whole_decades(ChartAxis& axis, const std::vector<ChartSeries>& all) {
  double least = INFINITY, largest = 0;
  for (const ChartSeries& each : all)
    for (const double x : each.x) {
      least = std::fmin(least, x);
      largest = std::fmax(largest, x);
    }
  if (!(least > 0) || !(least < largest)) return;
  axis.from = elementary::pow(10, std::floor(elementary::log10(least)));
  axis.to = elementary::pow(10, std::ceil(elementary::log10(largest)));
}

/// Two dots for each series: the typical value and a bad one.
void add_others(ChartPanel& panel, const std::vector<TradeSeries>& others) {
  std::size_t color = pdt_color + 1;
  for (const TradeSeries& other : others) {
    for (const auto& [share, words] : {std::pair(0.5, ", median"), {0.9, ", 90th percentile"}}) {
      ChartSeries dot = series(other.name + words, color++, ChartSeries::Form::points);
      dot.x = {quantile(other.times, 0.5)};
      dot.y = {percent(quantile(other.errors, share))};
      panel.series.push_back(dot);
    }
  }
  if (!others.empty()) whole_decades(panel.x, panel.series);
}

ChartPanel error_panel(const std::string& title, const Figures& all, TradeKind kind, Figure time,
                       const std::string& x, const std::string& y) {
  ChartPanel out;
  out.title = title;
  out.x = {x, true};
  out.y = {y, true};
  out.height = 230;
  for (const Method method : traded_methods)
    add_errors(out, figures_of(all, kind, method), method, time);
  whole_decades(out.x, out.series);
  return out;
}

/// A figure of ticks against their budget.
void add_by_budget(ChartPanel& panel, const Figures& figures, const std::string& name,
                   std::size_t color, Figure value, ChartSeries::Form form) {
  ChartSeries line = series(name, color, form);
  for (const TradeFigures& f : figures) {
    if (f.setting.budget == 0) continue;
    line.x.push_back(static_cast<double>(f.setting.budget));
    line.y.push_back(f.*value);
  }
  add_line(panel, line);
}

ChartPanel tick_time_panel(const Figures& all, Method method) {
  ChartPanel out;
  out.title = std::string("Coherent: time of a tick by its budget, ") + title_of(method);
  out.x = {"budget, counted work", true};
  out.y = {"processor time, µs", true};
  const Figures figures = figures_of(all, TradeKind::tick, method);
  const std::size_t color = color_of(method);
  add_by_budget(out, figures, "median", color, &TradeFigures::time_median, ChartSeries::Form::line);
  add_by_budget(out, figures, "99 of 100 ticks", color, &TradeFigures::time_p99,
                ChartSeries::Form::dashed);
  add_by_budget(out, figures, "999 of 1000 ticks", color + 2, &TradeFigures::time_p999,
                ChartSeries::Form::dashed);
  return out;
}

ChartPanel tick_convergence(const Figures& all) {
  ChartPanel out;
  out.title = "Coherent: ticks in contact that did not converge";
  out.x = {"budget, counted work", true};
  out.y = {"share", false, 0.0, 1.0};
  out.height = 130;
  for (const Method method : traded_methods)
    add_by_budget(out, figures_of(all, TradeKind::tick, method), title_of(method), color_of(method),
                  &TradeFigures::unconverged, ChartSeries::Form::line);
  return out;
}

}  // namespace

std::string trade_picture(const TradeResults& results, const std::vector<TradeFigures>& all,
                          const std::vector<TradeSeries>& others) {
  SvgChart chart{results.scene + ": accuracy against time", {}};
  const std::string typical = "median processor time, µs";
  chart.panels.push_back(error_panel("Static search: above the best known depth", all,
                                     TradeKind::search, &TradeFigures::time_median, typical,
                                     "depth / best known − 1, %"));
  add_others(chart.panels.back(), others);
  add_repeatability(chart.panels.back(), results);
  if (!figures_of(all, TradeKind::bound, Method::pdg).empty()) {
    chart.panels.push_back(error_panel("Lower bound: below the best known depth", all,
                                       TradeKind::bound, &TradeFigures::time_median, typical,
                                       "1 − bound / best known, %"));
    chart.panels.back().y = {chart.panels.back().y.label, false, 0.0, 100.0};
  }
  if (!results.paths.empty()) {
    chart.panels.push_back(error_panel(
        "Coherent: off the depth without a budget", all, TradeKind::tick, &TradeFigures::time_p99,
        "processor time of a tick, 99th percentile, µs", "difference / deepest, %"));
    for (const Method method : traded_methods) chart.panels.push_back(tick_time_panel(all, method));
    chart.panels.push_back(tick_convergence(all));
  }
  return to_svg(chart);
}

}  // namespace sonde
