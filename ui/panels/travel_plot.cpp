// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/travel_plot.hpp"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/study/charts/chart_scale.hpp"
#include "ui/base/theme.hpp"

namespace sonde::ui {
namespace {

constexpr double plot_left = 46, plot_right = 10, plot_foot = 20;  // pixels

}  // namespace

/// One of the charts: its values over travel.
struct TravelPlot::Strip {
  QRectF box;
  QString title;
  QColor colour;
  std::vector<double> values;
};

TravelPlot::TravelPlot(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("travel_plot"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  QFont small = font();
  small.setPointSizeF(8.5);
  setFont(small);
}

void TravelPlot::set_curves(TravelCurves curves, const LengthUnit& unit) {
  curves_ = std::move(curves);
  unit_ = unit;
  at_.reset();
  update();
}

void TravelPlot::show_at(std::optional<double> travel) {
  at_ = travel;
  update();
}

double TravelPlot::x_of(double travel) const {
  const double all = curves_.travel.back();
  return plot_left + (width() - plot_left - plot_right) * (all > 0 ? travel / all : 0);
}

std::vector<TravelPlot::Strip> TravelPlot::strips() const {
  const double head = QFontMetricsF(font()).height() + 4;
  const double wide = width() - plot_left - plot_right, tall = height() - plot_foot;
  std::vector<double> room = curves_.room;
  for (double& x : room) x /= unit_.metres();
  return {{QRectF(plot_left, head, wide, 0.55 * tall - head),
           QStringLiteral("room, less than 0: depth, %1").arg(unit_.name()), colour::clearance,
           std::move(room)},
          {QRectF(plot_left, 0.55 * tall + head, wide, 0.45 * tall - head),
           QStringLiteral("force, N"), colour::force, curves_.force}};
}

void TravelPlot::draw(QPainter& painter, const Strip& strip) const {
  std::vector<double> held = strip.values;
  held.push_back(0);
  const ChartScale scale({.label = {}}, held);
  const auto y_of = [&](double value) {
    return strip.box.bottom() - scale.place(value).value_or(0) * strip.box.height();
  };
  painter.setPen(faint_text(palette()));
  painter.drawText(QPointF(plot_left, strip.box.top() - 6), strip.title);
  double above = strip.box.bottom() + 1e3;  // of the number below
  for (const ChartScale::Tick& tick : scale.ticks()) {
    const double y = strip.box.bottom() - tick.place * strip.box.height();
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawLine(QPointF(strip.box.left(), y), QPointF(strip.box.right(), y));
    if (tick.text.empty() || above - y < QFontMetricsF(font()).height()) continue;
    above = y;
    painter.setPen(faint_text(palette()));
    painter.drawText(QRectF(0, y - 8, plot_left - 5, 16), Qt::AlignRight | Qt::AlignVCenter,
                     QString::fromStdString(tick.text));
  }
  QPainterPath curve;
  for (std::size_t i = 0; i < strip.values.size(); ++i) {
    const QPointF at(x_of(curves_.travel[i]), y_of(strip.values[i]));
    i == 0 ? curve.moveTo(at) : curve.lineTo(at);
  }
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(readable(strip.colour, palette()), 1.5));
  painter.drawPath(curve);
  painter.setRenderHint(QPainter::Antialiasing, false);
}

void TravelPlot::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), plot_background(palette()));
  if (curves_.travel.size() < 2) return;
  for (const Strip& strip : strips()) draw(painter, strip);
  const double low = height() - plot_foot;
  const auto line_at = [&](double travel, const QColor& colour, Qt::PenStyle style) {
    painter.setPen(QPen(colour, 1, style));
    painter.drawLine(QPointF(x_of(travel), 4), QPointF(x_of(travel), low));
  };
  if (curves_.first) line_at(*curves_.first, readable(colour::contact, palette()), Qt::DashLine);
  if (at_) line_at(*at_, palette().color(QPalette::WindowText), Qt::SolidLine);
  painter.setPen(faint_text(palette()));
  const QRectF foot(plot_left, low + 2, width() - plot_left - plot_right, plot_foot - 2);
  painter.drawText(foot, Qt::AlignLeft, QStringLiteral("0"));
  painter.drawText(foot, Qt::AlignRight,
                   QStringLiteral("travel %1").arg(unit_.text(curves_.travel.back())));
}

void TravelPlot::seek(double x) {
  if (curves_.travel.size() < 2 || !sought) return;
  const double part = (x - plot_left) / std::max(width() - plot_left - plot_right, 1.0);
  sought(std::clamp(part, 0.0, 1.0) * curves_.travel.back());
}

void TravelPlot::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) seek(event->localPos().x());
}

void TravelPlot::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton) seek(event->localPos().x());
}

}  // namespace sonde::ui
