// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/offset_plot.hpp"

#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkContextScene.h>
#include <vtkImageData.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlot.h>
#include <vtkPlotHistogram2D.h>

#include <QMouseEvent>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "ui/panels/chart_legend.hpp"
#include "ui/panels/chart_style.hpp"

namespace sonde::ui {
namespace {

constexpr double to_degrees = 180 / std::numbers::pi;
constexpr double map_left = 46, map_right = 18, map_head = 20, map_foot = 38;  // px

/// What can be of a point, in the colours that the study's picture has.
struct Outcome {
  const char* words;
  QColor colour;
};
const std::array<Outcome, 3>& outcomes() {
  static const std::array<Outcome, 3> all{{{"goes in", {0x1b, 0x78, 0x37}},
                                           {"binds", {0xfd, 0xae, 0x61}},
                                           {"overlaps at once", {0xba, 0xba, 0xba}}}};
  return all;
}
std::size_t outcome(double free, double wanted) { return free >= wanted ? 0 : free >= 0 ? 1 : 2; }

std::vector<LegendEntry> legend_entries() {
  std::vector<LegendEntry> entries;
  for (const Outcome& each : outcomes())
    entries.push_back({QStringLiteral("■"), each.colour, QString::fromUtf8(each.words)});
  return entries;
}

/// At the first cell, the middle and the last one.
std::vector<AxisMark> marks_of(std::size_t cells, double largest) {
  const double count = static_cast<double>(cells);
  if (cells < 2) return {{0.5, QStringLiteral("0")}};
  return {
      {0.5, number(-largest)}, {0.5 * count, QStringLiteral("0")}, {count - 0.5, number(largest)}};
}

}  // namespace

/// The axes count cells.
struct OffsetPlot::Map {
  explicit Map(vtkContextScene& scene) {
    set_up(*chart);
    vtkNew<vtkLookupTable> colours;
    colours->SetNumberOfTableValues(static_cast<vtkIdType>(outcomes().size()));
    colours->SetTableRange(0, static_cast<double>(outcomes().size()) - 1);
    for (vtkIdType i = 0; const Outcome& each : outcomes())
      colours->SetTableValue(i++, each.colour.redF(), each.colour.greenF(), each.colour.blueF());
    cells->SetTransferFunction(colours);
    chart->AddPlot(cells);
    chosen = add_line(*chart);
    chosen->SetVisible(false);
    chart->SetVisible(false);
    scene.AddItem(chart);
  }

  void fill(const OffsetMap& map) {
    chart->SetVisible(!map.free.empty());
    if (map.free.empty()) return;
    const auto wide = static_cast<int>(map.at.offsets), high = static_cast<int>(map.at.tilts);
    vtkNew<vtkImageData> image;
    image->SetDimensions(wide, high, 1);
    image->AllocateScalars(VTK_DOUBLE, 1);
    auto* at = static_cast<double*>(image->GetScalarPointer());
    for (std::size_t j = 0; j < map.at.tilts; ++j)
      for (std::size_t i = 0; i < map.at.offsets; ++i)
        *at++ = static_cast<double>(outcome(map.free[i * map.at.tilts + j], map.wanted));
    cells->SetInputData(image);
    cells->SetPosition({0, 0, static_cast<float>(wide), static_cast<float>(high)});
    chart->GetAxis(vtkAxis::BOTTOM)->SetRange(0, wide);
    chart->GetAxis(vtkAxis::LEFT)->SetRange(0, high);
  }

  /// Round a cell, within it: half the line is `edge` wide, in cells.
  void mark(const std::optional<MapPlace>& place, const QSizeF& edge) {
    chosen->SetVisible(place.has_value());
    if (!place) return;
    const QRectF cell(static_cast<double>(place->offset), static_cast<double>(place->tilt), 1, 1);
    const QRectF inner = cell.adjusted(edge.width(), edge.height(), -edge.width(), -edge.height());
    set_points(*chosen, {inner.topLeft(), inner.topRight(), inner.bottomRight(), inner.bottomLeft(),
                         inner.topLeft()});
  }

  vtkNew<vtkChartXY> chart;
  vtkNew<vtkPlotHistogram2D> cells;
  vtkPlot* chosen;
};

OffsetPlot::OffsetPlot(QWidget* parent)
    : ChartCanvas(parent), drawn_(std::make_unique<Map>(scene())), legend_(new ChartLegend(this)) {
  setObjectName(QStringLiteral("offset_plot"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setToolTip(QStringLiteral("A click takes the probe to the mouth, off by that much"));
  legend_->set_entries(legend_entries());
  drawn_->chart->SetTitle("angle of tilt, °");
}

OffsetPlot::~OffsetPlot() = default;

void OffsetPlot::set_map(OffsetMap map, const LengthUnit& unit) {
  map_ = std::move(map);
  chosen_.reset();
  drawn_->fill(map_);
  vtkAxis& offsets = *drawn_->chart->GetAxis(vtkAxis::BOTTOM);
  offsets.SetTitle(QStringLiteral("offset, %1").arg(unit.name()).toStdString());
  set_marks(offsets, marks_of(map_.at.offsets, map_.at.largest_offset / unit.metres()));
  set_marks(*drawn_->chart->GetAxis(vtkAxis::LEFT),
            marks_of(map_.at.tilts, map_.at.largest_tilt * to_degrees));
  redraw();
}

void OffsetPlot::choose(std::optional<MapPlace> place) {
  chosen_ = place;
  redraw();
}

QRectF OffsetPlot::area() const {
  return {map_left, map_head, std::max(width() - map_left - map_right, 1.0),
          std::max(height() - map_head - map_foot - legend_->room(), 1.0)};
}

/// Offsets to the right, tilts upwards.
QPointF OffsetPlot::place_of(const MapPlace& place) const {
  const QRectF all = area();
  return {all.left() + all.width() * (static_cast<double>(place.offset) + 0.5) /
                           static_cast<double>(map_.at.offsets),
          all.bottom() - all.height() * (static_cast<double>(place.tilt) + 0.5) /
                             static_cast<double>(map_.at.tilts)};
}

void OffsetPlot::arrange(double ratio) {
  legend_->arrange();
  const QRectF all = area();
  place_chart(*drawn_->chart, all, ratio);
  set_theme(*drawn_->chart, palette());
  set_pen(*drawn_->chosen->GetPen(), palette().color(QPalette::WindowText));
  drawn_->chosen->SetWidth(float(2 * ratio));
  drawn_->mark(chosen_, {static_cast<double>(map_.at.offsets) / all.width(),
                         static_cast<double>(map_.at.tilts) / all.height()});
  drawn_->chart->RecalculateBounds();
}

void OffsetPlot::mousePressEvent(QMouseEvent* event) {
  const QRectF all = area();
  if (event->button() != Qt::LeftButton || map_.free.empty() || !all.contains(event->localPos()))
    return;
  const auto at = [](double part, std::size_t count) {
    return std::min(count - 1,
                    static_cast<std::size_t>(std::max(0.0, part) * static_cast<double>(count)));
  };
  const QPointF from = event->localPos();
  emit asked({at((from.x() - all.left()) / all.width(), map_.at.offsets),
              at((all.bottom() - from.y()) / all.height(), map_.at.tilts)});
}

}  // namespace sonde::ui
