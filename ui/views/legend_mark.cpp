// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/legend_mark.hpp"

#include <QPainter>
#include <QPalette>

#include "ui/base/theme.hpp"

namespace sonde::ui {
namespace {

/// A body has its own colour on either background.
QColor mark_colour(const QColor& colour, const QPalette& palette) {
  const bool of_body = colour == colour::probe || colour == colour::fixed ||
                       colour == colour::ghost_on_probe || colour == colour::cap;
  return of_body ? colour : readable(colour, palette);
}

}  // namespace

void draw_mark(QPainter& painter, const QRectF& box, const LegendLine& entry,
               const QPalette& palette) {
  const LegendMark mark = entry.mark;
  const QColor colour = mark_colour(entry.colour, palette);
  QColor fill = colour;
  if (mark == LegendMark::clear || mark == LegendMark::mesh) fill.setAlphaF(0.4);
  const bool filled = mark != LegendMark::wires && mark != LegendMark::ring;
  painter.setBrush(filled ? QBrush(fill) : QBrush(Qt::NoBrush));
  painter.setPen(mark == LegendMark::filled || mark == LegendMark::clear ? QPen(Qt::NoPen)
                                                                         : QPen(colour, 1.2));
  if (mark == LegendMark::ring) return painter.drawEllipse(box);
  painter.drawRoundedRect(box, 2, 2);
  if (entry.right.isValid()) {
    const QRectF right(box.center().x(), box.top(), box.width() / 2, box.height());
    painter.fillRect(right, mark_colour(entry.right, palette));
  }
  if (mark != LegendMark::mesh && mark != LegendMark::wires) return;
  painter.drawLine(box.topLeft(), box.bottomRight());
  painter.drawLine(box.topRight(), box.bottomLeft());
}

}  // namespace sonde::ui
