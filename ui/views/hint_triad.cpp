// SPDX-License-Identifier: GPL-3.0-or-later
// The axes in the corner of the view.

#include <QPainter>
#include <algorithm>

#include "ui/base/theme.hpp"
#include "ui/views/hint_view.hpp"

namespace sonde::ui {
namespace {

constexpr int triad_margin = 14;
constexpr double triad_size = 70;  // pixels

}  // namespace

/// In the lower left corner, above the hint; in the right one where the legend reaches down there.
QRectF HintView::triad_box() const {
  const double bottom = hint_top();
  const QRectF box(triad_margin, bottom - triad_margin - triad_size, triad_size, triad_size);
  if (!box.intersects(legend_box())) return box;
  return box.translated(width() - 2 * triad_margin - triad_size, 0);
}

/// The axis that is furthest from the eye first.
void HintView::draw_triad(QPainter& painter) const {
  struct Axis {
    Vec3 seen;
    QString name;
    QColor colour;
  };
  std::array<Axis, 3> axes{{{triad_[0], QStringLiteral("x"), QColor(235, 90, 90)},
                            {triad_[1], QStringLiteral("y"), QColor(110, 190, 90)},
                            {triad_[2], QStringLiteral("z"), QColor(100, 150, 245)}}};
  if (!(triad_[0].norm() > 0)) return;
  std::ranges::sort(axes, {}, [](const Axis& axis) { return axis.seen.z(); });
  const QRectF box = triad_box();
  const double length = 0.33 * triad_size;
  for (const Axis& axis : axes) {
    const QPointF along(axis.seen.x() * length, -axis.seen.y() * length);
    const QColor own = readable(axis.colour, palette());
    painter.setPen(QPen(own, 2));
    painter.drawLine(box.center(), box.center() + along);
    const QPointF at = box.center() + 1.38 * along;
    painter.drawText(QRectF(at.x() - 8, at.y() - 8, 16, 16), Qt::AlignCenter, axis.name);
  }
}

}  // namespace sonde::ui
