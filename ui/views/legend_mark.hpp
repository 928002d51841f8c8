// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>

class QPainter;
class QPalette;
class QRectF;

namespace sonde::ui {

/// The style of an item, besides its colour.
enum class LegendMark { filled, clear, mesh, wires, ring };

/// One line of the legend: a colour and a mark, and what they stand for.
struct LegendLine {
  QColor colour;
  QString text;
  LegendMark mark = LegendMark::filled;
  QColor right{};  ///< of the right half of the mark; none: as the left
};

/// Draws the mark of a line into the box. Colours that are no body's are made readable on the
/// palette's background.
void draw_mark(QPainter& painter, const QRectF& box, const LegendLine& entry,
               const QPalette& palette);

}  // namespace sonde::ui
