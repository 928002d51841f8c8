// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/charts/svg_elements.hpp"

#include <array>
#include <cmath>

#include "engine/text/number_text.hpp"

namespace sonde::svg {
namespace {

constexpr std::array palette = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                "#8a6d00", "#56b4e9", "#e69f00", "#555555"};

}  // namespace

std::string series_color(std::size_t series) { return palette[series % palette.size()]; }

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:  // control characters are not allowed in XML
        out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return out;
}

// Adding 0.0 avoids a negative zero.
std::string px(double value) { return number_text(std::round(value * 100) / 100 + 0.0); }

std::string text_at(double x, double y, const char* anchor, const std::string& text,
                    const std::string& more) {
  return "<text x=\"" + px(x) + "\" y=\"" + px(y) + "\" text-anchor=\"" + anchor + "\"" + more +
         ">" + escaped(text) + "</text>\n";
}

std::string line_of(double x0, double y0, double x1, double y1, const std::string& style) {
  return "<line x1=\"" + px(x0) + "\" y1=\"" + px(y0) + "\" x2=\"" + px(x1) + "\" y2=\"" + px(y1) +
         "\" " + style + "/>\n";
}

std::string rectangle(double x, double y, double w, double h, const std::string& style) {
  return "<rect x=\"" + px(x) + "\" y=\"" + px(y) + "\" width=\"" + px(w) + "\" height=\"" + px(h) +
         "\" " + style;
}

std::string polyline(const std::vector<Spot>& spots, const std::string& style) {
  if (spots.empty()) return {};
  std::string points;
  for (const Spot& spot : spots) points += px(spot.x) + "," + px(spot.y) + " ";
  points.pop_back();
  return "<polyline points=\"" + points + "\" " + style + "/>\n";
}

std::string page(double width, double height, const std::string& title, double title_x,
                 const std::string& content) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + px(width) + "\" height=\"" +
         px(height) + "\" viewBox=\"0 0 " + px(width) + " " + px(height) +
         "\" font-family=\"sans-serif\" font-size=\"12\">\n<title>" + escaped(title) +
         "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n" +
         text_at(title_x, 30, "start", title, " font-size=\"16\" font-weight=\"bold\"") + content +
         "</svg>\n";
}

}  // namespace sonde::svg
