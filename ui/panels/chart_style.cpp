// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/chart_style.hpp"

#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlot.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include <QColor>
#include <QPalette>
#include <algorithm>
#include <cmath>

#include "ui/base/format.hpp"
#include "ui/base/theme.hpp"

namespace sonde::ui {
namespace {

constexpr double upright_tick_room = 20;  // pixels
constexpr int text_size = 12;

void set_text(vtkTextProperty& text, const QPalette& palette) {
  const QColor faint = faint_text(palette);
  text.SetColor(faint.redF(), faint.greenF(), faint.blueF());
  text.SetFontSize(text_size);
  text.BoldOff();
  text.ShadowOff();
}

void set_axis(vtkAxis& axis, const QPalette& palette) {
  set_text(*axis.GetLabelProperties(), palette);
  set_text(*axis.GetTitleProperties(), palette);
  const bool light = is_light(palette);
  set_pen(*axis.GetPen(), light ? QColor(140, 148, 158) : QColor(90, 100, 112));
  set_pen(*axis.GetGridPen(), light ? QColor(222, 226, 232) : QColor(60, 68, 78));
}

}  // namespace

void set_pen(vtkPen& pen, const QColor& colour) {
  pen.SetColor(static_cast<unsigned char>(colour.red()), static_cast<unsigned char>(colour.green()),
               static_cast<unsigned char>(colour.blue()));
}

void set_up(vtkChartXY& chart) {
  chart.SetAutoSize(false);
  chart.SetLayoutStrategy(vtkChart::AXES_TO_RECT);  // else each makes room for its own numbers
  chart.SetAutoAxes(false);
  chart.SetInteractive(false);
  chart.SetHiddenAxisBorder(0);
  chart.SetShowLegend(false);
  chart.GetTitleProperties()->SetJustificationToLeft();
  for (const int place : {vtkAxis::BOTTOM, vtkAxis::LEFT}) {
    chart.GetAxis(place)->SetBehavior(vtkAxis::FIXED);
    chart.GetAxis(place)->SetTitle("");
  }
}

void set_theme(vtkChartXY& chart, const QPalette& palette) {
  set_text(*chart.GetTitleProperties(), palette);
  for (const int place : {vtkAxis::BOTTOM, vtkAxis::LEFT}) set_axis(*chart.GetAxis(place), palette);
}

void set_marks(vtkAxis& axis, const std::vector<AxisMark>& marks) {
  vtkNew<vtkDoubleArray> places;
  vtkNew<vtkStringArray> texts;
  for (const AxisMark& mark : marks) {
    places->InsertNextValue(mark.at);
    texts->InsertNextValue(mark.text.toStdString());
  }
  axis.SetCustomTickPositions(places, texts);
}

void set_ticks(vtkAxis& axis, double room, double each) {
  const double low = axis.GetMinimum(), high = axis.GetMaximum();
  double step = round_down_125(high - low);
  for (double finer = round_down_125(0.6 * step); (high - low) / finer <= room / each;
       finer = round_down_125(0.6 * step))
    step = finer;
  std::vector<AxisMark> marks;
  for (double n = std::ceil(low / step); n <= std::floor(high / step); ++n)
    marks.push_back({n * step, QString::number(n * step, 'g', 4)});
  set_marks(axis, marks);
}

void set_values(vtkAxis& axis, double low, double high, double room) {
  low = std::min(low, 0.0);
  high = std::max(high, 0.0);
  if (!(high > low)) high = low + 1;
  const double margin = 0.05 * (high - low);
  axis.SetRange(low - margin, high + margin);
  set_ticks(axis, room, upright_tick_room);
}

vtkPlot* add_line(vtkChartXY& chart) {
  vtkNew<vtkTable> table;
  for (const char* name : {"x", "y"}) {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    table->AddColumn(column);
  }
  vtkPlot* line = chart.AddPlot(vtkChart::LINE);
  line->SetInputData(table, 0, 1);
  return line;
}

void set_points(vtkPlot& line, const std::vector<QPointF>& points) {
  vtkTable& table = *line.GetInput();
  auto* x = vtkDoubleArray::SafeDownCast(table.GetColumn(0));
  auto* y = vtkDoubleArray::SafeDownCast(table.GetColumn(1));
  x->SetNumberOfValues(static_cast<vtkIdType>(points.size()));
  y->SetNumberOfValues(static_cast<vtkIdType>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    x->SetValue(static_cast<vtkIdType>(i), points[i].x());
    y->SetValue(static_cast<vtkIdType>(i), points[i].y());
  }
  x->Modified();
  y->Modified();
  table.Modified();
}

void set_upright(vtkPlot& line, vtkChartXY& chart, double at) {
  vtkAxis& axis = *chart.GetAxis(vtkAxis::LEFT);
  set_points(line, {{at, axis.GetMinimum()}, {at, axis.GetMaximum()}});
}

}  // namespace sonde::ui
