// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QPointF>
#include <QString>
#include <vector>

class QColor;
class QPalette;
class QRectF;
class vtkAxis;
class vtkChartXY;
class vtkPen;
class vtkPlot;

namespace sonde::ui {

/// Of what Qt writes in and beside a chart.
QFont chart_font(QFont of);
QColor axis_colour(const QPalette& palette);
void set_pen(vtkPen& pen, const QColor& colour);

/// A chart whose size is where its axes are. Nothing in it moves by itself or by the mouse.
void set_up(vtkChartXY& chart);
/// The colours of the axes and of what is written, for a theme.
void set_theme(vtkChartXY& chart, const QPalette& palette);

/// A place of an axis with what is written at it.
struct AxisMark {
  double at;
  QString text;
};
void set_marks(vtkAxis& axis, const std::vector<AxisMark>& marks);
/// Marks at round numbers, as many as find room, and one beside 0 at least. Each needs `each` of
/// the `room` pixels of Qt's along the axis.
std::vector<AxisMark> round_marks(double low, double high, double room, double each);
void set_ticks(vtkAxis& axis, double room, double each);
/// Marks of an axis that has decimal logarithms from `low` to `high`, along `room` pixels of Qt's:
/// with numbers as far as these find room.
std::vector<AxisMark> log_marks(double low, double high, double room);
/// The range of an upright axis of `room` pixels of Qt's, with its marks: the values from `low` to
/// `high` with a margin, and zero, which is always to be seen.
void set_values(vtkAxis& axis, double low, double high, double room);

/// A line without points; the chart owns it.
vtkPlot* add_line(vtkChartXY& chart);
/// Points without a line; the chart owns them.
vtkPlot* add_markers(vtkChartXY& chart);
/// In the units of the axes. One that is not a number breaks a line.
void set_points(vtkPlot& plot, const std::vector<QPointF>& points);
/// Filled boxes; the chart owns them.
vtkPlot* add_boxes(vtkChartXY& chart, const QColor& colour);
/// In the units of the axes.
void set_boxes(vtkPlot& boxes, const std::vector<QRectF>& rects);
/// From the foot of the chart to its head, at a place of the axis below.
void set_upright(vtkPlot& line, vtkChartXY& chart, double at);

}  // namespace sonde::ui
