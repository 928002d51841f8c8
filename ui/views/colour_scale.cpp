// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/colour_scale.hpp"

#include <QLinearGradient>
#include <QPainter>
#include <algorithm>

namespace sonde::ui {
namespace {

// px
constexpr double column_tall = 170, column_wide = 14;
constexpr double scale_edge = 9;
constexpr double tick_length = 4;
constexpr double beside_ticks = 24;  // the column, the tick and the room between

}  // namespace

QSizeF scale_size(const ColourScale& scale, const QFontMetricsF& metrics) {
  if (scale.colours.empty()) return {};
  double wide = metrics.horizontalAdvance(scale.title);
  for (const QString& tick : scale.ticks)
    wide = std::max(wide, metrics.horizontalAdvance(tick) + beside_ticks);
  return {wide + 2 * scale_edge, column_tall + metrics.height() + 22};
}

void draw_scale(QPainter& painter, const QRectF& box, const ColourScale& scale) {
  if (scale.colours.empty()) return;
  const QFontMetricsF metrics(painter.font());
  painter.drawText(QPointF(box.left() + scale_edge, box.top() + 5 + metrics.ascent()), scale.title);
  const QRectF bar(box.left() + scale_edge, box.top() + metrics.height() + 14, column_wide,
                   box.height() - metrics.height() - 26);
  QLinearGradient gradient(bar.bottomLeft(), bar.topLeft());
  const double last = std::max(double(scale.colours.size()) - 1, 1.0);
  for (std::size_t i = 0; i < scale.colours.size(); ++i)
    gradient.setColorAt(double(i) / last, scale.colours[i]);
  painter.fillRect(bar, gradient);
  for (int i = 0; i < scale.ticks.size(); ++i) {
    const double y = bar.bottom() - bar.height() * i / std::max(scale.ticks.size() - 1, 1);
    painter.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + tick_length, y));
    painter.drawText(QPointF(bar.right() + 2 * tick_length, y + metrics.ascent() / 2 - 1),
                     scale.ticks[i]);
  }
}

}  // namespace sonde::ui
