// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace sonde {

/// Horizontal bars of equal length, each divided into the same parts as shares of a whole. The size
/// of the whole stands behind the bar.
struct StackedBars {
  struct Bar {
    std::string name;
    std::vector<double> parts;  ///< ≥ 0 and finite, one for each name of a part
  };
  std::string title;
  std::string label;                    ///< of the axis: "share of the time, %"
  std::string unit;                     ///< of the parts: "µs"
  std::vector<std::string> part_names;  ///< parts that no bar has are left out of the legend
  std::vector<Bar> bars;
};

/// The picture as an SVG file, the same bytes for the same bars. Throws std::invalid_argument if a
/// part is missing, negative or not finite.
std::string to_svg(const StackedBars& chart);

}  // namespace sonde
