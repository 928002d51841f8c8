// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QPolygonF>
#include <QRectF>
#include <vector>

namespace sonde::ui {

/// A label to place beside its point, and off its line.
struct LabelToPlace {
  QPointF at;
  QSizeF size;
  QPolygonF stroke{};  ///< an arrow or an arc on screen; no label may lie on it
};

/// A box for each label, inside the view: beside its point, clear of taken parts, of all strokes,
/// and of the labels before it. Where there is no such place nearby, the one that covers least. An
/// empty box for what is not in the view, neither its point nor a part of its line.
std::vector<QRectF> place_labels(const std::vector<LabelToPlace>& labels,
                                 const std::vector<QRectF>& taken, const QSizeF& view);

}  // namespace sonde::ui
