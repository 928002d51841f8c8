// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace sonde::bench {

struct Series {
  std::string name;
  std::vector<double> x, y;
  bool dashed = false;
};

/// Curves on two logarithmic axes.
struct Plot {
  std::string title, x_label, y_label;  ///< labels with their units
  std::vector<Series> series;
};

/// The picture as SVG. Points that have no logarithm are left out, and
/// series without any other.
std::string to_svg(const Plot& whole);

}  // namespace sonde::bench
