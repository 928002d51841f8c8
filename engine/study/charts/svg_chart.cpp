// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/charts/svg_chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/study/charts/svg_elements.hpp"

namespace sonde {

using namespace svg;

namespace {

// px; the legend is to the right
constexpr double width = 960, panel_left = 90, panel_right = 740;
constexpr double heading = 44, above = 30, panel_below = 52, legend_line = 18;

std::string color_of(const ChartPanel& panel, std::size_t series) {
  return series_color(panel.series[series].color.value_or(series));
}

std::string stroke_of(const ChartSeries& series, const std::string& color) {
  const bool dashed = series.form == ChartSeries::Form::dashed;
  return "fill=\"none\" stroke=\"" + color + "\" stroke-width=\"1.5\"" +
         (dashed ? " stroke-dasharray=\"6 4\"" : "");
}

/// One panel's place in the picture and its two scales.
class PanelFrame {
 public:
  PanelFrame(const ChartPanel& panel, double top)
      : panel_(panel),
        top_(top),
        x_(panel.x, values(panel, &ChartSeries::x, &ChartCell::x_from, &ChartCell::x_to)),
        y_(panel.y, values(panel, &ChartSeries::y, &ChartCell::y_from, &ChartCell::y_to)) {}

  double top() const { return top_; }
  double bottom() const { return top_ + panel_.height; }
  const ChartScale& x() const { return x_; }
  const ChartScale& y() const { return y_; }
  double across(double place) const { return panel_left + (panel_right - panel_left) * place; }
  double down(double place) const { return bottom() - panel_.height * place; }

  std::optional<Spot> spot(double x, double y) const {
    const auto at_x = x_.place(x), at_y = y_.place(y);
    if (!at_x || !at_y) return std::nullopt;
    return Spot{across(*at_x), down(*at_y)};
  }
  bool holds(const Spot& spot) const {
    return spot.x >= panel_left - edge && spot.x <= panel_right + edge && spot.y >= top() - edge &&
           spot.y <= bottom() + edge;
  }
  Spot nearest(const Spot& spot) const {
    return {std::clamp(spot.x, panel_left, panel_right), std::clamp(spot.y, top(), bottom())};
  }
  /// The part of a segment inside the frame, after Liang and Barsky; no value if it is outside.
  std::optional<std::array<Spot, 2>> inside(const Spot& a, const Spot& b) const {
    const double dx = b.x - a.x, dy = b.y - a.y;
    double from = 0, to = 1;
    const auto cut = [&](double along, double room) {  // keeps t with along t <= room
      if (along == 0) return room >= 0;
      (along < 0 ? from : to) =
          along < 0 ? std::max(from, room / along) : std::min(to, room / along);
      return from <= to;
    };
    if (!cut(-dx, a.x - panel_left + edge) || !cut(dx, panel_right + edge - a.x) ||
        !cut(-dy, a.y - top() + edge) || !cut(dy, bottom() + edge - a.y))
      return std::nullopt;
    return std::array{from > 0 ? nearest({a.x + from * dx, a.y + from * dy}) : nearest(a),
                      to < 1 ? nearest({a.x + to * dx, a.y + to * dy}) : nearest(b)};
  }

 private:
  static constexpr double edge = 1e-6;  // px: rounding throws nothing out

  static std::vector<double> values(const ChartPanel& panel, std::vector<double> ChartSeries::*of,
                                    double ChartCell::*from, double ChartCell::*to) {
    std::vector<double> out;
    for (const ChartSeries& series : panel.series)
      out.insert(out.end(), (series.*of).begin(), (series.*of).end());
    for (const ChartCell& cell : panel.cells) out.insert(out.end(), {cell.*from, cell.*to});
    return out;
  }
  const ChartPanel& panel_;
  double top_;
  ChartScale x_, y_;
};

std::string grid(bool named) {
  return std::string("stroke=\"") + (named ? "#c4c4c4" : "#e6e6e6") + "\"";
}

std::string upright_ticks(const PanelFrame& frame) {
  std::string out;
  for (const ChartScale::Tick& tick : frame.y().ticks()) {
    const double at = frame.down(tick.place);
    out += line_of(panel_left, at, panel_right, at, grid(!tick.text.empty()));
    if (!tick.text.empty()) out += text_at(panel_left - 8, at + 4, "end", tick.text);
  }
  return out;
}

/// A name in the middle of each row, and a line between rows.
std::string row_names(const std::vector<std::string>& names, const PanelFrame& frame) {
  constexpr double line = 13;  // px
  std::string out;
  for (std::size_t row = 0; row < names.size(); ++row) {
    const auto edge = frame.y().place(double(row)), middle = frame.y().place(double(row) + 0.5);
    if (!edge || !middle) continue;
    out +=
        line_of(panel_left, frame.down(*edge), panel_right, frame.down(*edge), "stroke=\"#000\"");
    const std::size_t cut = names[row].find('\n');
    const double at = frame.down(*middle) + 4;
    const bool two = cut != std::string::npos;
    out += text_at(panel_left - 8, two ? at - line / 2 : at, "end", names[row].substr(0, cut));
    if (two) out += text_at(panel_left - 8, at + line / 2, "end", names[row].substr(cut + 1));
  }
  return out;
}

std::string axes(const ChartPanel& panel, const PanelFrame& frame) {
  std::string out;
  for (const ChartScale::Tick& tick : frame.x().ticks()) {
    const double at = frame.across(tick.place);
    out += line_of(at, frame.top(), at, frame.bottom(), grid(!tick.text.empty()));
    if (!tick.text.empty()) out += text_at(at, frame.bottom() + 17, "middle", tick.text);
  }
  out += panel.y.names.empty() ? upright_ticks(frame) : row_names(panel.y.names, frame);
  out += rectangle(panel_left, frame.top(), panel_right - panel_left, panel.height,
                   "fill=\"none\" stroke=\"#000\" class=\"frame\"/>\n");
  out += text_at((panel_left + panel_right) / 2, frame.bottom() + 38, "middle", panel.x.label);
  out += text_at(
      0, 0, "middle", panel.y.label,
      " transform=\"translate(22 " + px((frame.top() + frame.bottom()) / 2) + ") rotate(-90)\"");
  return out + text_at(panel_left, frame.top() - 9, "start", panel.title, " font-weight=\"bold\"");
}

std::string cells(const ChartPanel& panel, const PanelFrame& frame) {
  std::string out;
  for (const ChartCell& cell : panel.cells) {
    const auto one = frame.spot(cell.x_from, cell.y_from), other = frame.spot(cell.x_to, cell.y_to);
    if (!one || !other || cell.kind >= panel.kinds.size()) continue;
    const ChartCellKind& kind = panel.kinds[cell.kind];
    const Spot a = frame.nearest(*one), b = frame.nearest(*other);
    out += rectangle(
        std::min(a.x, b.x), std::min(a.y, b.y), std::abs(b.x - a.x), std::abs(b.y - a.y),
        "class=\"cell\" shape-rendering=\"crispEdges\" fill=\"" + escaped(kind.color) + "\"");
    out += "><title>" + escaped(kind.name) + "</title></rect>\n";
  }
  return out;
}

/// Reduces one unbroken piece of a line to the visible points: of those in one column of pixels the
/// first, the lowest, the highest and the last.
std::vector<Spot> thinned_by_columns(const std::vector<Spot>& spots) {
  constexpr std::size_t few = 2 * static_cast<std::size_t>(panel_right - panel_left);
  if (spots.size() <= few) return spots;
  std::vector<Spot> out;
  for (std::size_t begin = 0; begin < spots.size();) {
    std::size_t end = begin, low = begin, high = begin;
    while (end < spots.size() && std::floor(spots[end].x) == std::floor(spots[begin].x)) {
      if (spots[end].y < spots[low].y) low = end;
      if (spots[end].y > spots[high].y) high = end;
      ++end;
    }
    std::array kept = {begin, std::min(low, high), std::max(low, high), end - 1};
    const auto last = std::unique(kept.begin(), kept.end());
    for (auto i = kept.begin(); i != last; ++i) out.push_back(spots[*i]);
    begin = end;
  }
  return out;
}

std::string dot(const Spot& spot, const std::string& color) {
  return "<circle cx=\"" + px(spot.x) + "\" cy=\"" + px(spot.y) + "\" r=\"3.5\" fill=\"" + color +
         "\" stroke=\"#fff\" stroke-width=\"0.8\"/>\n";
}

/// An unbroken line, clipped to the frame, because not every viewer clips.
std::string line_inside(const std::vector<Spot>& spots, const PanelFrame& frame,
                        const std::string& style) {
  std::string out;
  std::vector<Spot> piece;
  const std::vector<Spot> line = thinned_by_columns(spots);
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const auto part = frame.inside(line[i], line[i + 1]);
    if (!part) continue;
    const bool goes_on =
        !piece.empty() && piece.back().x == (*part)[0].x && piece.back().y == (*part)[0].y;
    if (!goes_on) {
      out += polyline(piece, style);
      piece = {(*part)[0]};
    }
    piece.push_back((*part)[1]);
  }
  return out + polyline(piece, style);
}

std::string drawn(const ChartSeries& series, const PanelFrame& frame, const std::string& color) {
  std::string out = "<g class=\"series\"><title>" + escaped(series.name) + "</title>\n";
  const std::string style = stroke_of(series, color);
  std::vector<Spot> piece;
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    const auto spot = frame.spot(series.x[i], series.y[i]);
    if (series.form == ChartSeries::Form::points) {
      if (spot && frame.holds(*spot)) out += dot(*spot, color);
    } else if (spot) {
      piece.push_back(*spot);
    } else {
      out += line_inside(piece, frame, style);
      piece.clear();
    }
  }
  return out + line_inside(piece, frame, style) + "</g>\n";
}

std::string legend(const ChartPanel& panel, double top) {
  constexpr double mark = panel_right + 14, text = panel_right + 46;
  std::string out;
  double y = top + 10;
  const auto name = [&](const std::string& named) {
    out += text_at(text, y + 4, "start", named);
    y += legend_line;
  };
  for (const ChartCellKind& kind : panel.kinds) {
    out +=
        rectangle(mark + 6, y - 7, 14, 14,
                  "fill=\"" + escaped(kind.color) + "\" stroke=\"#000\" stroke-width=\"0.5\"/>\n");
    name(kind.name);
  }
  for (std::size_t i = 0; i < panel.series.size(); ++i) {
    const ChartSeries& series = panel.series[i];
    if (series.name.empty()) continue;
    const std::string color = color_of(panel, i);
    out += series.form == ChartSeries::Form::points
               ? dot({mark + 13, y}, color)
               : line_of(mark, y, mark + 26, y, stroke_of(series, color));
    name(series.name);
  }
  return out;
}

/// Height of a panel with its heading and legend, px.
double height_of(const ChartPanel& panel) {
  const auto names = panel.kinds.size() + panel.series.size();
  return above + std::max(panel.height + panel_below, legend_line * static_cast<double>(names + 1));
}

std::string drawn(const ChartPanel& panel, double top) {
  const PanelFrame frame(panel, top);
  std::string out = "<g class=\"panel\">\n" + cells(panel, frame) + axes(panel, frame);
  for (std::size_t i = 0; i < panel.series.size(); ++i)
    out += drawn(panel.series[i], frame, color_of(panel, i));
  return out + legend(panel, top) + "</g>\n";
}

}  // namespace

std::string to_svg(const SvgChart& chart) {
  double y = heading;
  std::string panels;
  for (const ChartPanel& panel : chart.panels) {
    panels += drawn(panel, y + above);
    y += height_of(panel);
  }
  return page(width, y, chart.title, panel_left, panels);
}

}  // namespace sonde
