// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFontMetricsF>
#include <QRectF>
#include <QString>
#include <QStringList>
#include <vector>

class QPainter;

namespace sonde::ui {

/// The meaning of colours over a range: the first at the first tick, the last at the last.
struct ColourScale {
  QString title;
  std::vector<QColor> colours;
  QStringList ticks;  ///< at even distances
};

/// Of a column of these colours with its title and ticks; empty where there are no colours.
QSizeF scale_size(const ColourScale& scale, const QFontMetricsF& metrics);

/// The column in a box of that size, in the painter's font and pen: the first colour at its foot.
void draw_scale(QPainter& painter, const QRectF& box, const ColourScale& scale);

}  // namespace sonde::ui
