// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/charts/small_multiples.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/study/charts/chart_scale.hpp"
#include "engine/study/charts/svg_elements.hpp"

namespace sonde {

using namespace svg;

namespace {

constexpr double left = 150, top = 84, cell_width = 190, strip_height = 52, strip_gap = 12;  // px
constexpr double note_room = 20, cell_gap = 14, below = 44, right = 20;
constexpr std::size_t most_points = std::size_t(cell_width);

void check(const SmallMultiples& table) {
  bool fits = table.cells.size() == table.rows.size() * table.columns.size();
  for (const ChartTableCell& cell : table.cells)
    fits = fits && cell.y.size() == table.quantities.size() &&
           std::ranges::all_of(cell.y, [&](const auto& y) { return y.size() == cell.x.size(); });
  if (!fits) throw std::invalid_argument("a table of charts with a cell or a line missing");
}

/// The axis that contains a quantity of all cells, and 0.
ChartScale scale_of(const SmallMultiples& table, std::size_t quantity) {
  std::vector<double> all{0};
  for (const ChartTableCell& cell : table.cells)
    all.insert(all.end(), cell.y[quantity].begin(), cell.y[quantity].end());
  return {ChartAxis{}, all};
}

/// The range of x over all cells.
ChartScale scale_of_x(const SmallMultiples& table) {
  std::vector<double> all;
  for (const ChartTableCell& cell : table.cells)
    all.insert(all.end(), cell.x.begin(), cell.x.end());
  ChartAxis axis;
  if (all.size() > 1) {
    const auto [low, high] = std::ranges::minmax(all);
    if (low < high) axis.from = low, axis.to = high;
  }
  return {axis, all};
}

/// The position of a strip.
struct Strip {
  double x, y;
  double across(double place) const { return x + cell_width * place; }
  double down(double place) const { return y + strip_height * (1 - place); }
};

/// For a line with more points than columns, keeps the lowest and highest of each group.
std::vector<Spot> thinned(const std::vector<Spot>& spots) {
  if (spots.size() <= most_points) return spots;
  std::vector<Spot> out;
  const std::size_t each = (2 * spots.size() + most_points - 1) / most_points;
  for (std::size_t begin = 0; begin < spots.size(); begin += each) {
    const auto from = spots.begin() + std::ptrdiff_t(begin);
    const auto to = spots.begin() + std::ptrdiff_t(std::min(begin + each, spots.size()));
    auto [low, high] =
        std::minmax_element(from, to, [](const Spot& a, const Spot& b) { return a.y < b.y; });
    if (high < low) std::swap(low, high);
    out.push_back(*low);
    if (high != low) out.push_back(*high);
  }
  return out;
}

std::string line(const ChartTableCell& cell, std::size_t quantity, const ChartScale& x,
                 const ChartScale& y, const Strip& strip) {
  const std::string style =
      "fill=\"none\" stroke=\"" + series_color(quantity) + "\" stroke-width=\"1.3\"";
  std::string out;
  std::vector<Spot> piece;
  for (std::size_t i = 0; i < cell.x.size(); ++i) {
    const auto at_x = x.place(cell.x[i]), at_y = y.place(cell.y[quantity][i]);
    if (at_x && at_y) {
      piece.push_back({strip.across(*at_x), strip.down(*at_y)});
    } else {
      out += polyline(thinned(piece), style);
      piece.clear();
    }
  }
  return out + polyline(thinned(piece), style);
}

/// The frame, with numbers on its upright axis if it is the first in a row.
std::string frame(const ChartScale& x, const ChartScale& y, const Strip& strip, bool first) {
  std::string out;
  for (const ChartScale::Tick& tick : x.ticks())
    if (!tick.text.empty())
      out += line_of(strip.across(tick.place), strip.y, strip.across(tick.place),
                     strip.y + strip_height, "stroke=\"#e6e6e6\"");
  double last = INFINITY;
  for (const ChartScale::Tick& tick : y.ticks()) {
    if (tick.text.empty()) continue;
    const double at = strip.down(tick.place);
    out += line_of(strip.x, at, strip.x + cell_width, at, "stroke=\"#e6e6e6\"");
    if (!first || std::abs(last - at) < 14) continue;
    out += text_at(strip.x - 5, at + 4, "end", tick.text, " font-size=\"10\"");
    last = at;
  }
  return out + rectangle(strip.x, strip.y, cell_width, strip_height,
                         "fill=\"none\" stroke=\"#888\" stroke-width=\"0.7\"/>\n");
}

double cell_height(const SmallMultiples& table) {
  return double(table.quantities.size()) * (strip_height + strip_gap) + note_room + cell_gap;
}

std::string drawn(const SmallMultiples& table, std::size_t row, std::size_t column,
                  const std::vector<ChartScale>& scales, const ChartScale& x) {
  const ChartTableCell& cell = table.cells[row * table.columns.size() + column];
  Strip strip{left + double(column) * (cell_width + cell_gap),
              top + double(row) * cell_height(table)};
  std::string out = "<g class=\"cell\"><title>" +
                    escaped(table.rows[row] + ", " + table.columns[column]) + "</title>\n";
  for (std::size_t quantity = 0; quantity < scales.size(); ++quantity) {
    out += frame(x, scales[quantity], strip, column == 0);
    out += line(cell, quantity, x, scales[quantity], strip);
    strip.y += strip_height + strip_gap;
  }
  const char* style = cell.bad ? " font-size=\"10\" font-weight=\"bold\" fill=\"#b30000\""
                               : " font-size=\"10\" fill=\"#444\"";
  return out + text_at(strip.x, strip.y + 8, "start", cell.note, style) + "</g>\n";
}

std::string names(const SmallMultiples& table, const ChartScale& x) {
  std::string out;
  double at = left;
  for (std::size_t i = 0; i < table.quantities.size(); ++i) {
    out += line_of(at, 52, at + 22, 52, "stroke=\"" + series_color(i) + "\" stroke-width=\"2.5\"");
    out += text_at(at + 28, 56, "start", table.quantities[i].label);
    at += 48 + 7 * double(table.quantities[i].label.size());
  }
  const double bottom = top + double(table.rows.size()) * cell_height(table) - note_room - cell_gap;
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    const Strip strip{left + double(column) * (cell_width + cell_gap), bottom};
    out += text_at(strip.x, top - 8, "start", table.columns[column], " font-weight=\"bold\"");
    double last = -INFINITY;
    for (const ChartScale::Tick& tick : x.ticks()) {
      const double place = strip.across(tick.place);
      if (tick.text.empty() || place - last < 36) continue;
      out += text_at(place, bottom + note_room + 12, "middle", tick.text, " font-size=\"10\"");
      last = place;
    }
  }
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    out += text_at(12, top + double(row) * cell_height(table) + 16, "start", table.rows[row],
                   " font-weight=\"bold\"");
  return out + text_at(left, bottom + note_room + 30, "start", table.x_label);
}

}  // namespace

std::string to_svg(const SmallMultiples& table) {
  check(table);
  std::vector<ChartScale> scales;
  for (std::size_t i = 0; i < table.quantities.size(); ++i) scales.push_back(scale_of(table, i));
  const ChartScale x = scale_of_x(table);
  std::string content = names(table, x);
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    for (std::size_t column = 0; column < table.columns.size(); ++column)
      content += drawn(table, row, column, scales, x);
  const double width = left + double(table.columns.size()) * (cell_width + cell_gap) + right;
  const double height = top + double(table.rows.size()) * cell_height(table) + below;
  return page(std::max(width, 640.0), height, table.title, 12, content);
}

}  // namespace sonde
