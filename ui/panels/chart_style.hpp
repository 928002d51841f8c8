// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QString>
#include <vector>

class QColor;
class QPalette;
class vtkAxis;
class vtkChartXY;
class vtkPen;
class vtkPlot;

namespace sonde::ui {

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
void set_ticks(vtkAxis& axis, double room, double each);
/// The range of an upright axis of `room` pixels of Qt's, with its marks: the values from `low` to
/// `high` with a margin, and zero, which is always to be seen.
void set_values(vtkAxis& axis, double low, double high, double room);

/// A line without points; the chart owns it.
vtkPlot* add_line(vtkChartXY& chart);
/// In the units of the axes.
void set_points(vtkPlot& line, const std::vector<QPointF>& points);
/// From the foot of the chart to its head, at a place of the axis below.
void set_upright(vtkPlot& line, vtkChartXY& chart, double at);

}  // namespace sonde::ui
