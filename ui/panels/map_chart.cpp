// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/map_chart.hpp"

#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkContextScene.h>
#include <vtkPen.h>
#include <vtkPlotPoints.h>

#include <cmath>

#include "ui/base/theme.hpp"

namespace sonde::ui {
namespace {

const QColor light_line(240, 244, 248);

constexpr std::array classes{MapClass::passive, MapClass::stable, MapClass::chattering,
                             MapClass::saturated, MapClass::unstable};

QColor colour_of(MapClass map_class) {
  constexpr std::array rgb{0xa1403bu, 0x4f7fb0u, 0xc9952fu, 0x6f9440u, 0x2c7a58u};
  return QColor(QRgb(rgb.at(static_cast<std::size_t>(map_class))));
}

constexpr auto mark_count = static_cast<std::size_t>(MapMark::count);

struct MarkLook {
  QColor edge;
  double edge_width;  ///< px
  QColor colour;
  double width;  ///< px
  int line = vtkPen::SOLID_LINE, marker = VTK_MARKER_NONE;
};
const std::array<MarkLook, mark_count>& looks() {
  constexpr int solid = vtkPen::SOLID_LINE;
  static const QColor faint(0, 0, 0, 120), across(0, 0, 0, 160);
  static const std::array<MarkLook, mark_count> all{
      {{faint, 3.2, light_line, 1.6},
       {faint, 3.2, light_line, 1.6, vtkPen::DASH_LINE},
       {faint, 3.2, light_line, 1.6, vtkPen::DOT_LINE},
       {Qt::black, 3.5, colour::contact, 1.8},
       {Qt::black, 6, colour::contact, 3.5},
       {across, 4, colour::ghost, 2},
       {Qt::black, 14, colour::ghost, 11, solid, VTK_MARKER_DIAMOND},
       {across, 4, Qt::white, 2},
       {Qt::black, 12, Qt::white, 10, solid, VTK_MARKER_CIRCLE}}};
  return all;
}

vtkPlotPoints* add_mark(vtkChartXY& chart, const MarkLook& look, const QColor& colour) {
  const bool line = look.marker == VTK_MARKER_NONE;
  auto* plot = vtkPlotPoints::SafeDownCast(line ? add_line(chart) : add_markers(chart));
  plot->SetMarkerStyle(look.marker);
  set_pen(*plot->GetPen(), colour);
  return plot;
}

}  // namespace

MapChart::MapChart(vtkContextScene& scene) {
  set_up(*chart_);
  show(false);
  for (const int place : {vtkAxis::BOTTOM, vtkAxis::LEFT})
    chart_->GetAxis(place)->SetGridVisible(false);  // it would be beneath the cells
  scene.AddItem(chart_);
  for (const MapClass each : classes) cells_.push_back(add_boxes(*chart_, colour_of(each)));
  grid_ = add_line(*chart_);
  set_pen(*grid_->GetPen(), QColor(0, 0, 0, 70));
  for (std::size_t i = 0; i < mark_count; ++i) {
    const MarkLook& look = looks().at(i);
    edges_.at(i) = add_mark(*chart_, look, look.edge);
    marks_.at(i) = add_mark(*chart_, look, look.colour);
    marks_.at(i)->GetPen()->SetLineType(look.line);
  }
}

MapChart::~MapChart() = default;

void MapChart::show(bool on) { chart_->SetVisible(on); }

void MapChart::set_titles(const QString& above, const QString& below) {
  chart_->SetTitle(above.toStdString());
  chart_->GetAxis(vtkAxis::BOTTOM)->SetTitle(below.toStdString());
}

void MapChart::fill_cells(const StabilityMap& map) {
  for (std::size_t i = 0; i < classes.size(); ++i) {
    std::vector<QRectF> boxes;
    for (const MapRow& row : map.rows)
      for (const MapRow::Stretch& stretch : row.stretches)
        if (stretch.map_class == classes.at(i))
          boxes.emplace_back(QPointF(std::log10(stretch.from), row.from),
                             QPointF(std::log10(stretch.to), row.to));
    set_boxes(*cells_[i], boxes);
  }
}

void MapChart::set_axis(int place, double from, double to, const std::vector<AxisMark>& at) {
  chart_->GetAxis(place)->SetRange(from, to);
  set_marks(*chart_->GetAxis(place), at);
}

void MapChart::set_grid(const std::vector<QPointF>& points) { set_points(*grid_, points); }

void MapChart::draw(MapMark mark, const std::vector<QPointF>& points) {
  const auto at = static_cast<std::size_t>(mark);
  for (vtkPlotPoints* plot : {edges_.at(at), marks_.at(at)}) {
    set_points(*plot, points);
    plot->SetVisible(!points.empty());
  }
}

void MapChart::widen(double ratio) {
  const auto set = [ratio](vtkPlotPoints& plot, double width) {
    plot.SetWidth(float(width * ratio));
    plot.SetMarkerSize(float(width * ratio));
  };
  for (std::size_t i = 0; i < mark_count; ++i) {
    set(*edges_.at(i), looks().at(i).edge_width);
    set(*marks_.at(i), looks().at(i).width);
  }
  grid_->SetWidth(float(ratio));
}

std::vector<LegendEntry> map_legend() {
  std::vector<LegendEntry> entries;
  entries.reserve(classes.size());
  for (const MapClass each : classes)
    entries.push_back({QStringLiteral("■"), colour_of(each), QLatin1String(name_of(each))});
  const QColor behind = colour_of(MapClass::passive);
  const auto on_map = [&](const char* mark, const QColor& colour, const char* words) {
    entries.push_back({QString::fromUtf8(mark), colour, QLatin1String(words), behind});
  };
  on_map("——", light_line, "limit, measured");
  on_map("– –", light_line, "in theory");
  on_map("····", light_line, "passive in theory");
  // There at all times: with it, the cells would move as contacts come and go.
  on_map("□", colour::contact, "contact now");
  on_map("●", Qt::white, "gains now");
  on_map("◆", colour::ghost, "recommended");
  return entries;
}

}  // namespace sonde::ui
