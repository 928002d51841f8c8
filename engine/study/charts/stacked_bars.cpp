// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/charts/stacked_bars.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "engine/study/charts/chart_scale.hpp"
#include "engine/study/charts/svg_elements.hpp"
#include "engine/text/number_text.hpp"

namespace sonde {

using namespace svg;

namespace {

constexpr double bars_left = 190, bars_top = 84, bar_width = 520, bar_height = 24, step = 38;  // px
constexpr double room_right = 90, room_below = 60;

/// Three digits, without a power of ten.
std::string figure(double value) {
  return value < 100 ? number_text(value, 3) : number_text(std::round(value));
}

double whole(const StackedBars::Bar& bar) {
  return std::accumulate(bar.parts.begin(), bar.parts.end(), 0.0);
}

void check(const StackedBars& chart) {
  for (const StackedBars::Bar& bar : chart.bars) {
    const bool sound = bar.parts.size() == chart.part_names.size() &&
                       std::ranges::all_of(
                           bar.parts, [](double part) { return std::isfinite(part) && part >= 0; });
    if (!sound) throw std::invalid_argument("a stacked bar with a part missing or negative");
  }
}

std::string legend(const StackedBars& chart) {
  std::string out;
  double at = bars_left;
  for (std::size_t i = 0; i < chart.part_names.size(); ++i) {
    if (std::ranges::none_of(chart.bars, [i](const auto& bar) { return bar.parts[i] > 0; }))
      continue;
    out += rectangle(at, 48, 12, 12, "fill=\"" + series_color(i) + "\"/>\n");
    out += text_at(at + 17, 58, "start", chart.part_names[i]);
    at += 36 + 7 * double(chart.part_names[i].size());
  }
  return out;
}

std::string axis(const StackedBars& chart, const ChartScale& scale, double bottom) {
  std::string out;
  for (const ChartScale::Tick& tick : scale.ticks()) {
    const double x = bars_left + bar_width * tick.place;
    out += line_of(x, bars_top - 8, x, bottom, "stroke=\"#e6e6e6\"");
    if (!tick.text.empty()) out += text_at(x, bottom + 16, "middle", tick.text);
  }
  return out + text_at(bars_left + bar_width / 2, bottom + 38, "middle", chart.label);
}

std::string drawn(const StackedBars& chart, const StackedBars::Bar& bar, double y) {
  const double all = whole(bar);
  const double middle = y + bar_height / 2 + 4;
  std::string out = text_at(bars_left - 10, middle, "end", bar.name);
  double sum = 0;
  for (std::size_t i = 0; i < bar.parts.size(); ++i) {
    if (!(bar.parts[i] > 0)) continue;
    const double from = bars_left + bar_width * sum / all;
    sum += bar.parts[i];
    out += rectangle(from, y, bars_left + bar_width * sum / all - from, bar_height,
                     "fill=\"" + series_color(i) + "\"><title>") +
           escaped(chart.part_names[i] + ": " + figure(bar.parts[i]) + " " + chart.unit) +
           "</title></rect>\n";
  }
  return out + text_at(bars_left + bar_width + 8, middle, "start", figure(all) + " " + chart.unit);
}

}  // namespace

std::string to_svg(const StackedBars& chart) {
  check(chart);
  const ChartScale scale(ChartAxis{}, {0, 100});
  const double bottom = bars_top + step * double(chart.bars.size()) - (step - bar_height) + 8;
  std::string content = legend(chart) + axis(chart, scale, bottom);
  for (std::size_t i = 0; i < chart.bars.size(); ++i)
    content += drawn(chart, chart.bars[i], bars_top + step * double(i));
  return page(bars_left + bar_width + room_right, bottom + room_below, chart.title, 12, content);
}

}  // namespace sonde
