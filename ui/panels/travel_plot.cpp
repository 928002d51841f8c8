// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/travel_plot.hpp"

#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlot.h>

#include <QMouseEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/base/theme.hpp"
#include "ui/panels/chart_style.hpp"

namespace sonde::ui {
namespace {

constexpr double plot_left = 46, plot_right = 14, plot_foot = 36;  // pixels
constexpr double title_room = 18;                                  // pixels, above a chart
constexpr double travel_tick_room = 44;                            // pixels
constexpr double room_share = 0.55;                                // of the height
constexpr std::size_t most_columns = 1000;                         // more than a dock has pixels

/// The lowest and the highest of each column, which look as all of them do.
std::vector<QPointF> outline(const std::vector<QPointF>& points) {
  if (points.size() <= 2 * most_columns) return points;
  const double from = points.front().x();
  const double column = (points.back().x() - from) / double(most_columns);
  const auto lower = [](const QPointF& a, const QPointF& b) { return a.y() < b.y(); };
  std::vector<QPointF> kept;
  for (auto first = points.begin(); first != points.end();) {
    const double end = from + column * (std::floor((first->x() - from) / column) + 1);
    const auto last = std::find_if(first + 1, points.end(),
                                   [end](const QPointF& point) { return point.x() >= end; });
    const auto [low, high] = std::minmax_element(first, last, lower);
    kept.push_back(*std::min(low, high));
    if (low != high) kept.push_back(*std::max(low, high));
    first = last;
  }
  return kept;
}

}  // namespace

/// One of the charts: its values over travel.
struct TravelPlot::Strip {
  Strip(vtkContextScene& scene, const QColor& of)
      : colour(of), curve(add_line(*chart)), first(add_line(*chart)), at(add_line(*chart)) {
    set_up(*chart);
    first->GetPen()->SetLineType(vtkPen::DASH_LINE);
    for (vtkPlot* line : {first, at}) line->SetVisible(false);
    chart->SetVisible(false);
    scene.AddItem(chart);
  }

  void dress(const QPalette& palette) {
    set_theme(*chart, palette);
    set_pen(*curve->GetPen(), readable(colour, palette));
    set_pen(*first->GetPen(), readable(colour::contact, palette));
    set_pen(*at->GetPen(), palette.color(QPalette::WindowText));
  }

  /// From that many pixels of Qt's above the foot of the plot, and so wide and high.
  void place(double foot, double wide, double high, double ratio) {
    chart->SetSize(vtkRectf(float(plot_left * ratio), float(foot * ratio), float(wide * ratio),
                            float(high * ratio)));
    curve->SetWidth(float(1.5 * ratio));
    for (vtkPlot* line : {first, at}) line->SetWidth(float(ratio));
    height = high;
  }

  void fill(const std::vector<double>& along, const std::vector<double>& values) {
    std::vector<QPointF> points;
    low = high = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!std::isfinite(values[i])) continue;
      points.emplace_back(along[i], values[i]);
      low = std::min(low, values[i]);
      high = std::max(high, values[i]);
    }
    set_points(*curve, outline(points));
    chart->SetVisible(points.size() > 1);
  }

  void set_ranges(double longest, double wide) {
    vtkAxis& below = *chart->GetAxis(vtkAxis::BOTTOM);
    below.SetRange(0, longest);
    set_ticks(below, wide, travel_tick_room);
    set_values(*chart->GetAxis(vtkAxis::LEFT), low, high, height);
    chart->RecalculateBounds();
  }

  void mark(vtkPlot& line, std::optional<double> along) {
    line.SetVisible(along.has_value());
    if (along) set_upright(line, *chart, *along);
  }

  vtkNew<vtkChartXY> chart;
  QColor colour;
  vtkPlot *curve, *first, *at;
  double height = 1;         ///< of the chart, pixels of Qt's
  double low = 0, high = 0;  ///< of its values
};

TravelPlot::TravelPlot(QWidget* parent)
    : ChartCanvas(parent),
      room_(std::make_unique<Strip>(scene(), colour::clearance)),
      force_(std::make_unique<Strip>(scene(), colour::force)) {
  setObjectName(QStringLiteral("travel_plot"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  room_->chart->GetAxis(vtkAxis::BOTTOM)->SetLabelsVisible(false);
  force_->chart->SetTitle("force, N");
}

TravelPlot::~TravelPlot() = default;

void TravelPlot::set_curves(TravelCurves curves, const LengthUnit& unit) {
  curves_ = std::move(curves);
  unit_ = unit;
  at_.reset();
  std::vector<double> along = curves_.travel, room = curves_.room;
  for (std::vector<double>* lengths : {&along, &room})
    for (double& x : *lengths) x /= unit.metres();
  room_->fill(along, room);
  force_->fill(along, curves_.force);
  room_->chart->SetTitle(QStringLiteral("room, below 0: depth, %1").arg(unit.name()).toStdString());
  force_->chart->GetAxis(vtkAxis::BOTTOM)
      ->SetTitle(QStringLiteral("travel, %1").arg(unit.name()).toStdString());
  redraw();
}

double TravelPlot::longest() const {
  return curves_.travel.empty() || !(curves_.travel.back() > 0) ? 0 : curves_.travel.back();
}

void TravelPlot::show_at(std::optional<double> travel) {
  at_ = travel;
  redraw();
}

void TravelPlot::arrange(double ratio) {
  const double wide = std::max(width() - plot_left - plot_right, 1.0);
  const double high = std::max(height() - plot_foot - 2 * title_room, 2.0);
  const double upper = room_share * high;
  force_->place(plot_foot, wide, high - upper, ratio);
  room_->place(plot_foot + high - upper + title_room, wide, upper, ratio);
  const double per_metre = 1 / unit_.metres();
  const auto in_unit = [&](std::optional<double> travel) {
    return travel ? std::optional(*travel * per_metre) : std::nullopt;
  };
  for (Strip* strip : {room_.get(), force_.get()}) {
    strip->dress(palette());
    strip->set_ranges(longest() > 0 ? longest() * per_metre : 1, wide);
    strip->mark(*strip->first, in_unit(curves_.first));
    strip->mark(*strip->at, in_unit(at_));
  }
}

void TravelPlot::seek(double x) {
  if (curves_.travel.size() < 2) return;
  const double part = (x - plot_left) / std::max(width() - plot_left - plot_right, 1.0);
  emit sought(std::clamp(part, 0.0, 1.0) * curves_.travel.back());
}

void TravelPlot::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) seek(event->localPos().x());
}

void TravelPlot::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton) seek(event->localPos().x());
}

}  // namespace sonde::ui
