// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/text/number_text.hpp"

namespace sonde::bench {
namespace {

constexpr double width = 720, height = 460;
constexpr double left = 80, right = 520, top = 50, bottom = 400;
constexpr std::array colors = {"#0b5fa5", "#c2410c", "#15803d", "#7e22ce",
                               "#a16207", "#0f766e", "#be123c", "#475569"};

/// Whole decades that hold the values.
struct Decades {
  double low = 0, high = 1;
};

bool drawable(double value) { return std::isfinite(value) && value > 0; }

Decades decades(const Plot& plot, const std::vector<double> Series::*values) {
  bool any = false;
  Decades out;
  for (const Series& series : plot.series)
    for (const double v : series.*values) {
      if (!drawable(v)) continue;
      const double low = std::floor(std::log10(v)), high = std::ceil(std::log10(v));
      out = any ? Decades{std::min(out.low, low), std::max(out.high, high)} : Decades{low, high};
      any = true;
    }
  if (out.high <= out.low) out.high = out.low + 1;
  return out;
}

double place(double value, const Decades& range, double from, double to) {
  return from + (to - from) * (std::log10(value) - range.low) / (range.high - range.low);
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else
      out += c;
  }
  return out;
}

std::string number(double value) { return number_text(std::round(value * 100) / 100); }

std::string text_at(double x, double y, const std::string& anchor, const std::string& text,
                    const std::string& more = {}) {
  return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" + anchor + "\"" +
         more + ">" + escaped(text) + "</text>\n";
}

std::string line(double x0, double y0, double x1, double y1, const std::string& more) {
  return "<line x1=\"" + number(x0) + "\" y1=\"" + number(y0) + "\" x2=\"" + number(x1) +
         "\" y2=\"" + number(y1) + "\" " + more + "/>\n";
}

/// 1000 as "1 k", 1e6 as "1 M", 0.01 as "0.01".
std::string tick_text(double decade) {
  const int d = static_cast<int>(decade);
  if (d >= 6) return number_text(std::pow(10.0, d - 6)) + " M";
  if (d >= 3) return number_text(std::pow(10.0, d - 3)) + " k";
  return number_text(std::round(std::pow(10.0, d) * 1e9) / 1e9);
}

std::string axes(const Plot& plot, const Decades& x, const Decades& y) {
  const std::string grid = "stroke=\"#d4d4d4\"";
  std::string out;
  for (double d = x.low; d <= x.high; ++d) {
    const double at = place(std::pow(10.0, d), x, left, right);
    out += line(at, top, at, bottom, grid) + text_at(at, bottom + 18, "middle", tick_text(d));
  }
  for (double d = y.low; d <= y.high; ++d) {
    const double at = place(std::pow(10.0, d), y, bottom, top);
    out += line(left, at, right, at, grid) + text_at(left - 8, at + 4, "end", tick_text(d));
  }
  const double middle = (top + bottom) / 2;
  out += text_at((left + right) / 2, bottom + 42, "middle", plot.x_label);
  out += text_at(0, 0, "middle", plot.y_label,
                 " transform=\"translate(20 " + number(middle) + ") rotate(-90)\"");
  return out + text_at(left, 28, "start", plot.title, " font-weight=\"bold\"");
}

std::string curve(const Series& series, const Decades& x, const Decades& y,
                  const std::string& color) {
  std::string points, dots;
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    if (!drawable(series.x[i]) || !drawable(series.y[i])) continue;
    const std::string px = number(place(series.x[i], x, left, right));
    const std::string py = number(place(series.y[i], y, bottom, top));
    points.append(px).append(",").append(py).append(" ");
    dots.append("<circle cx=\"").append(px).append("\" cy=\"").append(py);
    dots.append("\" r=\"3\" fill=\"").append(color).append("\"/>\n");
  }
  return "<polyline points=\"" + points + "\" fill=\"none\" stroke=\"" + color +
         "\" stroke-width=\"2\"" + (series.dashed ? " stroke-dasharray=\"6 4\"" : "") + "/>\n" +
         dots;
}

}  // namespace

std::string to_svg(const Plot& whole) {
  Plot plot = whole;
  std::erase_if(plot.series, [](const Series& s) {
    return std::none_of(s.y.begin(), s.y.end(), drawable);  // nothing was measured
  });
  const Decades x = decades(plot, &Series::x), y = decades(plot, &Series::y);
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(width) +
                    "\" height=\"" + number(height) +
                    "\" font-family=\"sans-serif\" font-size=\"12\">\n"
                    "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n" +
                    axes(plot, x, y);
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const std::string color = colors[i % colors.size()];
    out += curve(plot.series[i], x, y, color);
    const double at = top + 10 + 20 * static_cast<double>(i);
    out += line(right + 14, at, right + 40, at,
                "stroke=\"" + color + "\" stroke-width=\"2\"" +
                    (plot.series[i].dashed ? " stroke-dasharray=\"6 4\"" : ""));
    out += text_at(right + 46, at + 4, "start", plot.series[i].name);
  }
  return out + "</svg>\n";
}

}  // namespace sonde::bench
