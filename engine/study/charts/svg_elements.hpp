// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// The elements of SVG charts, as text. Positions are in pixels, to a hundredth.
namespace sonde::svg {

struct Spot {
  double x, y;
};

/// The colours of series in their order, cyclic: Okabe and Ito's palette, which most colour-blind
/// people can distinguish; black is for the text.
std::string series_color(std::size_t series);

std::string px(double value);
std::string escaped(const std::string& text);
/// `anchor`: "start", "middle" or "end"; `more`: further attributes, after a space.
std::string text_at(double x, double y, const char* anchor, const std::string& text,
                    const std::string& more = {});
std::string line_of(double x0, double y0, double x1, double y1, const std::string& style);
/// Without the end of the tag after `style`: the caller adds it.
std::string rectangle(double x, double y, double w, double h, const std::string& style);
/// Empty if there are no spots.
std::string polyline(const std::vector<Spot>& spots, const std::string& style);
/// A whole file: a white page with a title.
std::string page(double width, double height, const std::string& title, double title_x,
                 const std::string& content);

}  // namespace sonde::svg
