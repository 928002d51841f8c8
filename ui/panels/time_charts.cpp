// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/time_charts.hpp"

#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkContextScene.h>
#include <vtkPen.h>
#include <vtkPlot.h>
#include <vtkSmartPointer.h>

#include <QMouseEvent>
#include <QPalette>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "ui/base/theme.hpp"
#include "ui/panels/chart_style.hpp"

namespace sonde::ui {
namespace {

constexpr double left_room = 62, right_room = 14, room_above = 9;  // pixels
constexpr double room_for_times = 22, room_between = 4;            // pixels
constexpr double line_width = 1.5;                                 // pixels
constexpr int least_drag = 4;                                      // pixels
constexpr double wheel_zoom = 1.25;

/// A line in a chart.
struct DrawnLine {
  ChartLine line;
  vtkPlot* plot;
};

DrawnLine line_in(vtkChartXY& chart, const ChartLine& line, const CurveStyle& style,
                  const QPalette& palette) {
  DrawnLine drawn{line, add_line(chart)};
  set_pen(*drawn.plot->GetPen(), readable(style.colour, palette));
  constexpr std::array pens{vtkPen::SOLID_LINE, vtkPen::DASH_LINE, vtkPen::DOT_LINE};
  drawn.plot->GetPen()->SetLineType(pens.at(static_cast<std::size_t>(line.stroke)));
  return drawn;
}

/// All curves of one unit.
struct Chart {
  vtkSmartPointer<vtkChartXY> chart;
  QString unit;
  std::vector<DrawnLine> lines;
  DrawnLine cursor;
};

}  // namespace

std::vector<CurveStyle> curve_styles(const LengthUnit& unit) {
  const QString newton = QStringLiteral("N");
  const QString& length = unit.name();
  const double scale = 1 / unit.metres();
  const QColor x(255, 170, 120), y(170, 220, 130), z(140, 180, 255);
  return {{Curve::held, QStringLiteral("held"), length, scale, colour::ghost},
          {Curve::nearest, QStringLiteral("nearest way out"), length, scale, colour::nearest},
          {Curve::straight, QStringLiteral("PD_t"), length, scale, colour::straight},
          {Curve::bound, QStringLiteral("at least"), length, scale, colour::faint},
          {Curve::force, QStringLiteral("|F|"), newton, 1, colour::force},
          {Curve::force_x, QStringLiteral("F_x"), newton, 1, x},
          {Curve::force_y, QStringLiteral("F_y"), newton, 1, y},
          {Curve::force_z, QStringLiteral("F_z"), newton, 1, z},
          {Curve::torque, QStringLiteral("|τ|"), QStringLiteral("N·m"), 1, colour::torque},
          {Curve::torque_x, QStringLiteral("τ_x"), QStringLiteral("N·m"), 1, x},
          {Curve::torque_y, QStringLiteral("τ_y"), QStringLiteral("N·m"), 1, y},
          {Curve::torque_z, QStringLiteral("τ_z"), QStringLiteral("N·m"), 1, z},
          {Curve::tick_us, QStringLiteral("tick time"), QStringLiteral("µs"), 1, colour::turn},
          {Curve::rows_us, QStringLiteral("time of the rows"), QStringLiteral("µs"), 1,
           colour::contact},
          {Curve::age, QStringLiteral("age of rows"), QStringLiteral("ms"), 1e3, colour::contact},
          {Curve::energy, QStringLiteral("energy"), QStringLiteral("mJ"), 1e3, colour::probe},
          {Curve::clearance, QStringLiteral("clearance, or minus the depth"), length, scale,
           colour::measure}};
}

struct TimeCharts::Scene {
  explicit Scene(vtkContextScene& of) : shown(of) {}

  vtkContextScene& shown;
  std::vector<Chart> charts;
  ChartView view;
  std::size_t points = 0;
  double plot_height = 0;     ///< of each chart, pixels of Qt's
  std::optional<bool> light;  ///< what the charts were made for

  /// The charts are made anew where other lines are wanted.
  void build(const std::vector<CurveStyle>& styles, const QPalette& palette) {
    for (const Chart& chart : charts) shown.RemoveItem(chart.chart);
    charts.clear();
    for (const ChartLine& line : view.lines) {
      const CurveStyle& style = styles[static_cast<std::size_t>(line.curve)];
      auto at = std::ranges::find(charts, style.unit, &Chart::unit);
      if (at == charts.end()) at = charts.insert(at, made(style.unit, palette));
      at->lines.push_back(line_in(*at->chart, line, style, palette));
    }
  }

  Chart made(const QString& unit, const QPalette& palette) {
    auto chart = vtkSmartPointer<vtkChartXY>::New();
    set_up(*chart);
    set_theme(*chart, palette);
    chart->GetAxis(vtkAxis::LEFT)->SetTitle(unit.toStdString());
    shown.AddItem(chart);
    const CurveStyle style{Curve::held, {}, unit, 1, palette.color(QPalette::WindowText)};
    DrawnLine cursor = line_in(*chart, {nullptr, Curve::held}, style, palette);
    return {chart, unit, {}, cursor};
  }

  bool same_lines(const ChartView& other) const {
    return other.unit.name() == view.unit.name() &&
           std::ranges::equal(other.lines, view.lines, [](const ChartLine& a, const ChartLine& b) {
             return a.curve == b.curve && a.stroke == b.stroke;
           });
  }

  void fill_chart(Chart& chart, const std::vector<CurveStyle>& styles, std::size_t columns) {
    double low = 0, high = 0;
    for (DrawnLine& drawn : chart.lines) {
      const CurveStyle& style = styles[static_cast<std::size_t>(drawn.line.curve)];
      const auto outline = drawn.line.of->outline(drawn.line.curve, view.from, view.to, columns);
      std::vector<QPointF> places;
      for (const CurvePoint& point : outline) {
        places.emplace_back(point.time, style.scale * point.value);
        if (std::isnan(point.value)) continue;  // a break
        low = std::min(low, places.back().y());
        high = std::max(high, places.back().y());
      }
      set_points(*drawn.plot, places);
      drawn.plot->SetVisible(outline.size() > 1);
      points += outline.size();
    }
    set_values(*chart.chart->GetAxis(vtkAxis::LEFT), low, high, plot_height);
    chart.chart->GetAxis(vtkAxis::BOTTOM)->SetRange(view.from, view.to);
    set_upright(*chart.cursor.plot, *chart.chart, view.cursor);
    chart.cursor.plot->SetVisible(view.cursor >= view.from && view.cursor <= view.to);
    chart.chart->RecalculateBounds();
  }

  /// All in device pixels: so many to one of Qt's.
  void place(double width, double height, double ratio) {
    const double times = (room_for_times - room_between) * ratio;  // below the lowest chart alone
    const double each = (height - times) / std::max<double>(1, double(charts.size()));
    plot_height = each / ratio - room_above - room_between;
    for (std::size_t i = 0; i < charts.size(); ++i) {
      vtkChartXY& chart = *charts[i].chart;
      const bool lowest = i + 1 == charts.size();
      const double bottom = height - each * double(i + 1);
      chart.SetSize(vtkRectf(float(left_room * ratio), float(bottom + room_between * ratio),
                             float(width - (left_room + right_room) * ratio),
                             float(plot_height * ratio)));
      chart.GetAxis(vtkAxis::BOTTOM)->SetLabelsVisible(lowest);
      const auto width_of = float(line_width * ratio);
      // What is held shows on both sides of a way out that is the same.
      for (const DrawnLine& line : charts[i].lines)
        line.plot->SetWidth(line.line.curve == Curve::held ? 2.5F * width_of : width_of);
      if (charts[i].cursor.plot) charts[i].cursor.plot->SetWidth(width_of);
    }
  }
};

TimeCharts::TimeCharts(QWidget* parent)
    : ChartCanvas(parent), scene_(std::make_unique<Scene>(scene())) {
  setObjectName(QStringLiteral("charts"));
  setMinimumHeight(190);
  setMouseTracking(true);
}

TimeCharts::~TimeCharts() = default;

void TimeCharts::arrange(double ratio) { scene_->place(width() * ratio, height() * ratio, ratio); }

void TimeCharts::draw(const ChartView& view) {
  Scene& s = *scene_;
  const std::vector<CurveStyle> styles = curve_styles(view.unit);
  const bool same = s.same_lines(view) && s.light == is_light(palette());
  s.light = is_light(palette());
  s.view = view;
  if (!same) s.build(styles, palette());
  const double ratio = devicePixelRatioF();
  arrange(ratio);  // how high the charts are decides how many marks they have
  const auto columns =
      static_cast<std::size_t>(std::max(10.0, (width() - left_room - right_room) * ratio));
  s.points = 0;
  for (Chart& chart : s.charts) {
    for (DrawnLine& drawn : chart.lines) drawn.line.of = nullptr;
    for (const ChartLine& line : view.lines) {
      const auto drawn = std::ranges::find_if(chart.lines, [&](const DrawnLine& d) {
        return d.line.curve == line.curve && d.line.stroke == line.stroke;
      });
      if (drawn != chart.lines.end()) drawn->line.of = line.of;
    }
    s.fill_chart(chart, styles, columns);
  }
  redraw();
}

std::size_t TimeCharts::points() const { return scene_->points; }

double TimeCharts::time_at(double x) const {
  const double plot = width() - left_room - right_room;
  const double part = plot > 0 ? (x - left_room) / plot : 0;
  return scene_->view.from + part * (scene_->view.to - scene_->view.from);
}

void TimeCharts::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0;
  emit zoomed(std::pow(wheel_zoom, -notches), time_at(event->position().x()));
  event->accept();
}

void TimeCharts::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  pressed_ = last_ = event->localPos().x();
  moved_ = false;
}

void TimeCharts::mouseMoveEvent(QMouseEvent* event) {
  const double x = event->localPos().x();
  if (pressed_ < 0) {
    emit hovered(time_at(x));
    return;
  }
  moved_ = moved_ || std::abs(x - pressed_) >= least_drag;
  if (moved_) emit dragged(time_at(last_) - time_at(x));
  if (moved_) last_ = x;
}

void TimeCharts::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  if (pressed_ >= 0 && !moved_) emit clicked(time_at(pressed_));
  pressed_ = -1;
}

}  // namespace sonde::ui
