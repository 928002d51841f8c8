// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/study/charts/chart_scale.hpp"

namespace sonde {

/// Points (x, y) of one kind. A line is interrupted at a value that cannot be drawn (not finite, or
/// without a logarithm on a logarithmic axis); a single point of this kind is left out.
struct ChartSeries {
  enum class Form { line, dashed, points };
  std::string name;  ///< for the legend; empty: not in it
  std::vector<double> x = {}, y = {};
  Form form = Form::line;
  /// Index in the palette; default: its index among the series.
  std::optional<std::size_t> color = {};
};

/// The meaning of a coloured cell.
struct ChartCellKind {
  std::string name;   ///< for the legend
  std::string color;  ///< as SVG has it: "#d9f0d3"
};

/// A rectangle of a map, in units of the axes.
struct ChartCell {
  double x_from, x_to, y_from, y_to;
  std::size_t kind;  ///< in the panel's kinds
};

/// Cells lie under the grid, the series over it.
struct ChartPanel {
  std::string title;
  ChartAxis x, y;
  std::vector<ChartSeries> series;
  std::vector<ChartCellKind> kinds;
  std::vector<ChartCell> cells;
  double height = 190;  ///< of the plotted area, px
};

/// Panels above one another, each with its axes and its legend.
struct SvgChart {
  std::string title;
  std::vector<ChartPanel> panels;
};

/// The picture as an SVG file: the same bytes for the same chart, in any locale. A line with more
/// points than the picture has columns is drawn by the first, lowest, highest and last point of
/// each column, which looks the same. Every series and every cell has its name as a <title>.
std::string to_svg(const SvgChart& chart);

}  // namespace sonde
