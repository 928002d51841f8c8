// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkNew.h>

#include <QPointF>
#include <array>
#include <vector>

#include "ui/panels/chart_legend.hpp"
#include "ui/panels/chart_style.hpp"
#include "ui/tuning/stability_map.hpp"

class vtkChartXY;
class vtkContextScene;
class vtkPlot;
class vtkPlotPoints;

namespace sonde::ui {

/// What is drawn over the cells of a map, from below.
enum class MapMark : std::size_t {
  stable,
  theory_stable,
  theory_passive,
  contact_frame,
  contact_stable,
  recommended_across,
  recommended_at,
  now_across,
  now_at,
  count
};

/// The chart of a stability map: cells in the colours of their classes, lines and points over them,
/// each with a dark edge, to be told from every colour of the map. Its axes count decimal
/// logarithms of stiffness, and dampings or rows.
class MapChart {
 public:
  /// On show first when it is told so.
  explicit MapChart(vtkContextScene& scene);
  ~MapChart();
  MapChart(const MapChart&) = delete;
  MapChart& operator=(const MapChart&) = delete;

  vtkChartXY& chart() { return *chart_; }
  void show(bool on);
  void set_titles(const QString& above, const QString& below);
  void fill_cells(const StabilityMap& map);
  void set_axis(int place, double from, double to, const std::vector<AxisMark>& at);
  /// A line that is drawn over the cells, beneath the marks.
  void set_grid(const std::vector<QPointF>& points);
  /// In the units of the axes, a line broken where a number is none; no points: it is not seen.
  void draw(MapMark mark, const std::vector<QPointF>& points);
  /// Widths and sizes, where so many device pixels are one of Qt's.
  void widen(double ratio);

 private:
  static constexpr auto marks_count = static_cast<std::size_t>(MapMark::count);
  vtkNew<vtkChartXY> chart_;
  std::vector<vtkPlot*> cells_;
  vtkPlot* grid_ = nullptr;
  std::array<vtkPlotPoints*, marks_count> edges_{}, marks_{};
};

/// What the colours, the lines and the points of such a chart say. Lines and points stand as they
/// are seen on the map: on a window of its own shade one may be lost.
std::vector<LegendEntry> map_legend();

}  // namespace sonde::ui
