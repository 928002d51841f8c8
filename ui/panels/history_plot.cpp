// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/history_plot.hpp"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/base/numbers.hpp"
#include "ui/base/format.hpp"
#include "ui/base/theme.hpp"
#include "ui/panels/chart_style.hpp"

namespace sonde::ui {
namespace {

/// s: further apart, what was between two is not known.
constexpr double longest_added_line = 2;

constexpr double least_seen = 0.05;  // s, of a curve

/// The next 1, 2 or 5 above: the top of the scale, so that the curve does not breathe.
double round_up(double value) {
  const double below = round_down_125(value);
  for (const double factor : {1.0, 2.0, 2.5, 5.0})
    if (const double above = round_down_125(below * factor * 1.0001); above >= value) return above;
  return value;
}

}  // namespace

HistoryPlot::HistoryPlot(const QString& title, const QColor& colour, QWidget* parent)
    : QWidget(parent), title_(title), colour_(colour) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void HistoryPlot::add(double time, double value) {
  if (!samples_.empty() && time == samples_.back().time) return;  // a moment that stays on show
  if (!samples_.empty() && time < samples_.back().time) samples_.clear();
  if (!samples_.empty() && time - samples_.back().time > longest_added_line)
    samples_.push_back({samples_.back().time, no_number});
  samples_.push_back({time, value});
  until_ = time;
  while (samples_.front().time < time - span) samples_.pop_front();
}

void HistoryPlot::show(const std::vector<CurvePoint>& points, double until) {
  samples_.assign(points.begin(), points.end());
  until_ = until;
  update();
}

void HistoryPlot::clear() {
  samples_.clear();
  update();
}

void HistoryPlot::set_unit(double scale, const QString& name) {
  scale_ = scale;
  unit_ = name;
}

void HistoryPlot::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), plot_background(palette()));
  painter.setFont(chart_font(font()));
  const QFontMetrics metrics = painter.fontMetrics();
  double largest = 0;
  for (const CurvePoint& sample : samples_)
    if (!std::isnan(sample.value)) largest = std::max(largest, sample.value * scale_);
  const double top = largest > 1e-9 ? round_up(largest) : 1;
  const double head = metrics.height() + 4.0;
  const double tall = height() - head - 3;
  painter.setPen(axis_colour(palette()));
  painter.drawLine(QPointF(0, head), QPointF(width(), head));
  painter.setPen(faint_text(palette()));
  painter.drawText(QPointF(5, metrics.ascent() + 2),
                   QStringLiteral("%1, %2 %3").arg(title_, round_figure(top), unit_));
  const QString seconds = QStringLiteral("%1 s").arg(span);
  painter.drawText(QPointF(width() - metrics.horizontalAdvance(seconds) - 5, metrics.ascent() + 2),
                   seconds);
  if (samples_.empty()) return;
  if (until_ - samples_.front().time < least_seen) {
    painter.drawText(QRectF(0, head, width(), tall), Qt::AlignCenter,
                     QStringLiteral("nothing is kept from before"));
    return;
  }
  QPainterPath curve;
  bool broken = true;
  for (const CurvePoint& sample : samples_) {
    const QPointF at((1 - (until_ - sample.time) / span) * width(),
                     head + tall * (1 - sample.value * scale_ / top));
    if (std::isnan(sample.value))
      broken = true;
    else if (std::exchange(broken, false))
      curve.moveTo(at);
    else
      curve.lineTo(at);
  }
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(readable(colour_, palette()), 1.5));
  painter.drawPath(curve);
}

}  // namespace sonde::ui
