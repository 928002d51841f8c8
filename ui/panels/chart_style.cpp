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
#include <QRectF>
#include <algorithm>
#include <cmath>
#include <string>

#include "engine/study/charts/chart_scale.hpp"
#include "ui/base/format.hpp"
#include "ui/base/theme.hpp"

namespace sonde::ui {
namespace {

constexpr double upright_tick_room = 20;  // pixels
constexpr int text_size = 12;
constexpr double digit_width = 7;  // pixels

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
  set_pen(*axis.GetPen(), axis_colour(palette));
  set_pen(*axis.GetGridPen(), is_light(palette) ? QColor(222, 226, 232) : QColor(60, 68, 78));
}

vtkPlot* add_plot(vtkChartXY& chart, int kind, int columns) {
  vtkNew<vtkTable> table;
  for (int i = 0; i < columns; ++i) {
    vtkNew<vtkDoubleArray> column;
    column->SetName(std::to_string(i).c_str());
    table->AddColumn(column);
  }
  vtkPlot* plot = chart.AddPlot(kind);
  plot->SetInputData(table, 0, 1);
  return plot;
}

void set_columns(vtkPlot& plot, const std::vector<std::vector<double>>& columns) {
  vtkTable& table = *plot.GetInput();
  for (vtkIdType i = 0; const std::vector<double>& values : columns) {
    auto* column = vtkDoubleArray::SafeDownCast(table.GetColumn(i++));
    column->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
    std::ranges::copy(values, column->GetPointer(0));
    column->Modified();
  }
  table.Modified();
}

}  // namespace

QFont chart_font(QFont of) {
  of.setPointSizeF(8.5);
  return of;
}

QColor axis_colour(const QPalette& palette) {
  return is_light(palette) ? QColor(140, 148, 158) : QColor(90, 100, 112);
}

void set_pen(vtkPen& pen, const QColor& colour) {
  pen.SetColor(static_cast<unsigned char>(colour.red()), static_cast<unsigned char>(colour.green()),
               static_cast<unsigned char>(colour.blue()),
               static_cast<unsigned char>(colour.alpha()));
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

std::vector<AxisMark> round_marks(double low, double high, double room, double each) {
  double step = round_down_125(high - low);
  for (double finer = round_down_125(0.6 * step); (high - low) / finer <= room / each;
       finer = round_down_125(0.6 * step))
    step = finer;
  std::vector<AxisMark> marks;
  for (double n = std::ceil(low / step); n <= std::floor(high / step); ++n)
    marks.push_back({n * step, QString::number(n * step, 'g', 4)});
  return marks;
}

void set_ticks(vtkAxis& axis, double room, double each) {
  set_marks(axis, round_marks(axis.GetMinimum(), axis.GetMaximum(), room, each));
}

std::vector<AxisMark> log_marks(double low, double high, double room) {
  const ChartScale scale(
      {.label = {}, .logarithmic = true, .from = std::pow(10, low), .to = std::pow(10, high)}, {});
  std::vector<AxisMark> marks;
  double free = -room;  // pixels along the axis, where the next may begin
  for (const ChartScale::Tick& tick : scale.ticks()) {
    const double half = 0.5 * digit_width * static_cast<double>(tick.text.size());
    const bool fits = tick.place * room - half >= free;
    marks.push_back({low + tick.place * (high - low), fits ? text(tick.text) : QString()});
    if (fits && !tick.text.empty()) free = tick.place * room + half + digit_width;
  }
  return marks;
}

void set_values(vtkAxis& axis, double low, double high, double room) {
  low = std::min(low, 0.0);
  high = std::max(high, 0.0);
  if (!(high > low)) high = low + 1;
  const double margin = 0.05 * (high - low);
  axis.SetRange(low - margin, high + margin);
  set_ticks(axis, room, upright_tick_room);
}

vtkPlot* add_line(vtkChartXY& chart) { return add_plot(chart, vtkChart::LINE, 2); }

vtkPlot* add_markers(vtkChartXY& chart) { return add_plot(chart, vtkChart::POINTS, 2); }

vtkPlot* add_boxes(vtkChartXY& chart, const QColor& colour) {
  vtkPlot* boxes = add_plot(chart, vtkChart::AREA, 3);
  boxes->SetInputArray(2, "2");
  boxes->SetColor(colour.redF(), colour.greenF(), colour.blueF());
  return boxes;
}

void set_points(vtkPlot& plot, const std::vector<QPointF>& points) {
  std::vector<double> x, y;
  for (const QPointF& point : points) {
    x.push_back(point.x());
    y.push_back(point.y());
  }
  set_columns(plot, {x, y});
}

/// VTK fills between two lines. Between two boxes the lines are one, and enclose nothing.
void set_boxes(vtkPlot& boxes, const std::vector<QRectF>& rects) {
  std::vector<double> x, low, high;
  for (const QRectF& rect : rects) {
    const double middle = rect.center().y();
    x.insert(x.end(), {rect.left(), rect.left(), rect.right(), rect.right()});
    low.insert(low.end(), {middle, rect.top(), rect.top(), middle});
    high.insert(high.end(), {middle, rect.bottom(), rect.bottom(), middle});
  }
  set_columns(boxes, {x, low, high});
  boxes.SetVisible(!rects.empty());
}

void set_upright(vtkPlot& line, vtkChartXY& chart, double at) {
  vtkAxis& axis = *chart.GetAxis(vtkAxis::LEFT);
  set_points(line, {{at, axis.GetMinimum()}, {at, axis.GetMaximum()}});
}

}  // namespace sonde::ui
