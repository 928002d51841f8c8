// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/label_layout.hpp"

#include <QLineF>
#include <algorithm>
#include <array>
#include <limits>

namespace sonde::ui {
namespace {

constexpr double edge = 2;          // pixels kept clear along the view's edges
constexpr double sample = 3;        // along a stroke
constexpr int seen_samples = 64;    // of one piece of a stroke
constexpr double stroke_cost = 40;  // pixels covered, for each sample of a stroke: about its width

/// Beside the point first, as text is read; then above and below, then further off.
std::vector<QRectF> places_for(const LabelToPlace& label, const QSizeF& view) {
  // Where the middle of the box is, in halves of its size and gaps.
  constexpr std::array<QPointF, 8> sides{QPointF(1, 0), {-1, 0},  {0, -1}, {0, 1},
                                         {1, -1},       {-1, -1}, {1, 1},  {-1, 1}};
  std::vector<QRectF> places;
  for (const double gap : {10.0, 26.0, 50.0, 90.0})
    for (const QPointF& side : sides) {
      QRectF box({}, label.size);
      box.moveCenter(label.at + QPointF(side.x() * (label.size.width() / 2 + gap),
                                        side.y() * (label.size.height() / 2 + gap)));
      box.moveLeft(std::clamp(box.left(), edge, std::max(edge, view.width() - box.width() - edge)));
      box.moveTop(std::clamp(box.top(), edge, std::max(edge, view.height() - box.height() - edge)));
      places.push_back(box);
    }
  return places;
}

double area_in_common(const QRectF& a, const QRectF& b) {
  const QRectF common = a & b;
  return common.isEmpty() ? 0 : common.width() * common.height();
}

double covered(const QRectF& box, const QPolygonF& stroke) {
  double cost = 0;
  for (int i = 1; i < stroke.size(); ++i) {
    const QLineF piece(stroke[i - 1], stroke[i]);
    const int samples = std::min(1 + static_cast<int>(piece.length() / sample), 1000);
    for (int k = 0; k <= samples; ++k)
      if (box.contains(piece.pointAt(double(k) / samples))) cost += stroke_cost;
  }
  return cost;
}

/// Whether its point or a part of its stroke lies in the view.
bool is_seen(const LabelToPlace& label, const QRectF& view) {
  if (view.contains(label.at)) return true;
  for (int i = 1; i < label.stroke.size(); ++i) {
    const QLineF piece(label.stroke[i - 1], label.stroke[i]);
    for (int k = 0; k <= seen_samples; ++k)
      if (view.contains(piece.pointAt(double(k) / seen_samples))) return true;
  }
  return false;
}

}  // namespace

std::vector<QRectF> place_labels(const std::vector<LabelToPlace>& labels,
                                 const std::vector<QRectF>& taken, const QSizeF& view) {
  std::vector<QRectF> boxes;
  for (const LabelToPlace& label : labels) {
    QRectF best;
    if (!is_seen(label, QRectF({}, view))) {
      boxes.push_back(best);
      continue;
    }
    double least = std::numeric_limits<double>::infinity();
    for (const QRectF& place : places_for(label, view)) {
      double cost = 0;
      for (const QRectF& other : taken) cost += area_in_common(place, other);
      for (const QRectF& other : boxes) cost += area_in_common(place, other);
      for (const LabelToPlace& other : labels) cost += covered(place, other.stroke);
      if (cost < least) least = cost, best = place;
      if (least == 0) break;
    }
    boxes.push_back(best);
  }
  return boxes;
}

}  // namespace sonde::ui
