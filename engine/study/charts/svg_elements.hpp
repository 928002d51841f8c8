// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// The pieces that the SVG charts are made of, as text. Places are in pixels, to a hundredth.
namespace sonde::svg {

struct Spot {
  double x, y;
};

/// The colours of series in their order, from the beginning again after the last: Okabe and Ito's,
/// which most colour-blind eyes tell apart; black is for the text.
std::string series_color(std::size_t series);

std::string px(double value);
std::string escaped(const std::string& text);
/// `anchor`: "start", "middle" or "end"; `more`: further attributes, after a space.
std::string text_at(double x, double y, const char* anchor, const std::string& text,
                    const std::string& more = {});
std::string line_of(double x0, double y0, double x1, double y1, const std::string& style);
/// Left open after `style`: the caller ends it.
std::string rectangle(double x, double y, double w, double h, const std::string& style);
/// Empty where there is no spot.
std::string polyline(const std::vector<Spot>& spots, const std::string& style);
/// A whole file: a white page with a title.
std::string page(double width, double height, const std::string& title, double title_x,
                 const std::string& content);

}  // namespace sonde::svg
