// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/time_charts.hpp"

#include <QVTKInteractor.h>
#include <QVTKOpenGLNativeWidget.h>
#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlot.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include <QImage>
#include <QMouseEvent>
#include <QPalette>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "ui/base/theme.hpp"

namespace sonde::ui {
namespace {

constexpr double left_room = 62, right_room = 14, room_above = 9;  // pixels
constexpr double room_for_times = 22, room_between = 4;            // pixels
constexpr double tick_room = 26;                                   // pixels
constexpr double line_width = 1.5;                                 // pixels
constexpr int least_drag = 4;                                      // pixels
constexpr double wheel_zoom = 1.25;
constexpr int text_size = 11;

void set_pen(vtkPen& pen, const QColor& c) {
  pen.SetColor(static_cast<unsigned char>(c.red()), static_cast<unsigned char>(c.green()),
               static_cast<unsigned char>(c.blue()));
}

void set_text(vtkTextProperty& text, const QPalette& palette) {
  const QColor faint = faint_text(palette);
  text.SetColor(faint.redF(), faint.greenF(), faint.blueF());
  text.SetFontSize(text_size);
  text.BoldOff();
  text.ShadowOff();
}

void set_axis(vtkAxis& axis, const QPalette& palette) {
  axis.SetBehavior(vtkAxis::FIXED);
  set_text(*axis.GetLabelProperties(), palette);
  set_text(*axis.GetTitleProperties(), palette);
  const bool light = is_light(palette);
  set_pen(*axis.GetPen(), light ? QColor(140, 148, 158) : QColor(90, 100, 112));
  set_pen(*axis.GetGridPen(), light ? QColor(222, 226, 232) : QColor(60, 68, 78));
}

/// The largest of 1, 2, 5 times a power of ten that is no larger.
double round_down(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  const double digit = value / power;
  return power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}

/// Round numbers, as many as find room, and one beside 0 at least.
void set_ticks(vtkAxis& axis, double low, double high, double room) {
  double step = round_down(high - low);
  for (double finer = round_down(0.6 * step); (high - low) / finer <= room / tick_room;
       finer = round_down(0.6 * step))
    step = finer;
  vtkNew<vtkDoubleArray> places;
  vtkNew<vtkStringArray> texts;
  for (double n = std::ceil(low / step); n <= std::floor(high / step); ++n) {
    places->InsertNextValue(n * step);
    texts->InsertNextValue(QString::number(n * step, 'g', 4).toStdString());
  }
  axis.SetCustomTickPositions(places, texts);
}

/// Columns of a table of two: time and value.
void fill(vtkTable& table, const std::vector<CurvePoint>& points, double scale) {
  auto* times = vtkDoubleArray::SafeDownCast(table.GetColumn(0));
  auto* values = vtkDoubleArray::SafeDownCast(table.GetColumn(1));
  times->SetNumberOfValues(static_cast<vtkIdType>(points.size()));
  values->SetNumberOfValues(static_cast<vtkIdType>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    times->SetValue(static_cast<vtkIdType>(i), points[i].time);
    values->SetValue(static_cast<vtkIdType>(i), scale * points[i].value);
  }
  times->Modified();
  values->Modified();
  table.Modified();
}

vtkSmartPointer<vtkTable> empty_table() {
  auto table = vtkSmartPointer<vtkTable>::New();
  for (const char* name : {"time", "value"}) {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    table->AddColumn(column);
  }
  return table;
}

/// A line in a chart, with its table.
struct DrawnLine {
  ChartLine line;
  vtkSmartPointer<vtkTable> table;
  vtkPlot* plot;
};

DrawnLine line_in(vtkChartXY& chart, const ChartLine& line, const CurveStyle& style,
                  const QPalette& palette) {
  DrawnLine drawn{line, empty_table(), chart.AddPlot(vtkChart::LINE)};
  drawn.plot->SetInputData(drawn.table, 0, 1);
  drawn.plot->SetLabel(
      (style.name +
       (line.stroke == ChartLine::Stroke::solid ? QString() : QStringLiteral(", run again")))
          .toStdString());
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
  explicit Scene(TimeCharts& owner) : widget(new QVTKOpenGLNativeWidget(&owner)) {}

  QVTKOpenGLNativeWidget* widget;
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkContextActor> actor;
  std::vector<Chart> charts;
  ChartView view;
  std::size_t points = 0;
  double plot_height = 0;     ///< of each chart, pixels of Qt's
  std::optional<bool> light;  ///< what the charts were made for

  /// The charts are made anew where other lines are wanted.
  void build(const std::vector<CurveStyle>& styles) {
    const QPalette palette = widget->palette();
    const QColor back = plot_background(palette);
    renderer->SetBackground(back.redF(), back.greenF(), back.blueF());
    for (const Chart& chart : charts) actor->GetScene()->RemoveItem(chart.chart);
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
    chart->SetAutoSize(false);
    chart->SetLayoutStrategy(vtkChart::AXES_TO_RECT);  // else each makes room for its own numbers
    chart->SetAutoAxes(false);
    chart->SetInteractive(false);
    chart->SetHiddenAxisBorder(0);
    for (const int place : {vtkAxis::BOTTOM, vtkAxis::LEFT})
      set_axis(*chart->GetAxis(place), palette);
    chart->GetAxis(vtkAxis::BOTTOM)->SetTitle("");
    chart->GetAxis(vtkAxis::LEFT)->SetTitle(unit.toStdString());
    actor->GetScene()->AddItem(chart);
    const CurveStyle style{Curve::held, {}, unit, 1, palette.color(QPalette::WindowText)};
    DrawnLine cursor = line_in(*chart, {nullptr, Curve::held}, style, palette);
    cursor.plot->SetLabel("");
    chart->SetShowLegend(false);  // the line of values above names the curves in their colours
    return {chart, unit, {}, cursor};
  }

  bool same_lines(const ChartView& other) const {
    return other.unit.name() == view.unit.name() &&
           std::ranges::equal(other.lines, view.lines, [](const ChartLine& a, const ChartLine& b) {
             return a.curve == b.curve && a.stroke == b.stroke;
           });
  }

  void fill_chart(Chart& chart, const std::vector<CurveStyle>& styles, std::size_t columns) {
    double low = 0, high = 0;  // zero is always to be seen
    for (DrawnLine& drawn : chart.lines) {
      const CurveStyle& style = styles[static_cast<std::size_t>(drawn.line.curve)];
      const auto outline = drawn.line.of->outline(drawn.line.curve, view.from, view.to, columns);
      fill(*drawn.table, outline, style.scale);
      drawn.plot->SetVisible(outline.size() > 1);
      points += outline.size();
      for (const CurvePoint& point : outline) {
        low = std::min(low, style.scale * point.value);
        high = std::max(high, style.scale * point.value);
      }
    }
    if (!(high > low)) high = low + 1;
    const double margin = 0.05 * (high - low);
    if (low < 0) low -= margin;
    high += margin;
    chart.chart->GetAxis(vtkAxis::LEFT)->SetRange(low, high);
    set_ticks(*chart.chart->GetAxis(vtkAxis::LEFT), low, high, plot_height);
    chart.chart->GetAxis(vtkAxis::BOTTOM)->SetRange(view.from, view.to);
    fill(*chart.cursor.table, {{view.cursor, low}, {view.cursor, high}}, 1);
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

TimeCharts::TimeCharts(QWidget* parent) : QWidget(parent), scene_(std::make_unique<Scene>(*this)) {
  setMinimumHeight(190);
  Scene& s = *scene_;
  s.widget->setObjectName(QStringLiteral("charts"));
  s.widget->setMouseTracking(true);
  s.widget->setAcceptDrops(false);
  s.window->SetMultiSamples(0);
  s.widget->setRenderWindow(s.window);
  s.widget->interactor()->SetInteractorStyle(nullptr);
  s.window->AddRenderer(s.renderer);
  s.renderer->AddActor(s.actor);
  s.actor->GetScene()->SetRenderer(s.renderer);
  s.widget->installEventFilter(this);
}

TimeCharts::~TimeCharts() { scene_->widget->removeEventFilter(this); }

void TimeCharts::draw(const ChartView& view) {
  Scene& s = *scene_;
  const std::vector<CurveStyle> styles = curve_styles(view.unit);
  const bool same = s.same_lines(view) && s.light == is_light(palette());
  s.light = is_light(palette());
  s.view = view;
  if (!same) s.build(styles);
  const double ratio = devicePixelRatioF();
  s.place(width() * ratio, height() * ratio, ratio);
  const auto columns =
      static_cast<std::size_t>(std::max(10.0, (width() - left_room - right_room) * ratio));
  s.points = 0;
  std::size_t next = 0;
  for (Chart& chart : s.charts) {
    for (DrawnLine& drawn : chart.lines) drawn.line.of = nullptr;
    for (const ChartLine& line : view.lines) {
      const auto drawn = std::ranges::find_if(chart.lines, [&](const DrawnLine& d) {
        return d.line.curve == line.curve && d.line.stroke == line.stroke;
      });
      if (drawn != chart.lines.end()) drawn->line.of = line.of;
    }
    s.fill_chart(chart, styles, columns);
    ++next;
  }
  s.window->Render();
}

std::size_t TimeCharts::points() const { return scene_->points; }

QWidget* TimeCharts::canvas() const { return scene_->widget; }

QImage TimeCharts::picture() const { return scene_->widget->grabFramebuffer(); }

double TimeCharts::time_at(double x) const {
  const double ratio = devicePixelRatioF();
  const double plot = (width() - left_room - right_room) * ratio;
  const double part = plot > 0 ? (x - left_room) * ratio / plot : 0;
  return scene_->view.from + part * (scene_->view.to - scene_->view.from);
}

void TimeCharts::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  scene_->widget->setGeometry(rect());
}

bool TimeCharts::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Wheel) {
    const auto* wheel = static_cast<QWheelEvent*>(event);
    const double notches = wheel->angleDelta().y() / 120.0;
    if (zoomed) zoomed(std::pow(wheel_zoom, -notches), time_at(wheel->position().x()));
    return true;
  }
  const auto* mouse = dynamic_cast<QMouseEvent*>(event);
  if (!mouse) return QWidget::eventFilter(watched, event);
  if (event->type() == QEvent::MouseButtonPress && mouse->button() == Qt::LeftButton) {
    pressed_ = last_ = mouse->localPos().x();
    moved_ = false;
    return true;
  }
  if (event->type() == QEvent::MouseMove) {
    const double x = mouse->localPos().x();
    if (pressed_ < 0) {
      if (hovered) hovered(time_at(x));
      return true;
    }
    moved_ = moved_ || std::abs(x - pressed_) >= least_drag;
    if (moved_ && dragged) dragged(time_at(last_) - time_at(x));
    if (moved_) last_ = x;
    return true;
  }
  if (event->type() == QEvent::MouseButtonRelease && mouse->button() == Qt::LeftButton) {
    if (pressed_ >= 0 && !moved_ && clicked) clicked(time_at(pressed_));
    pressed_ = -1;
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace sonde::ui
