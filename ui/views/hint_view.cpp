// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/hint_view.hpp"

#include <QPainter>
#include <algorithm>
#include <utility>

#include "ui/theme.hpp"

namespace sonde::ui {
namespace {

constexpr int margin = 14;
const QColor plate(14, 17, 21, 165);

QFont small_font(const QWidget& widget) {
  QFont font = widget.font();
  font.setPointSizeF(9);
  return font;
}

void draw_plate(QPainter& painter, const QRectF& box) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(plate);
  painter.drawRoundedRect(box, 5, 5);
}

}  // namespace

HintView::HintView(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("hint_view"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setFont(small_font(*this));
}

const std::vector<std::pair<QString, QString>>& HintView::keys() {
  static const std::vector<std::pair<QString, QString>> list{
      {"Drag", "moves the probe"},
      {"Wheel", "in depth"},
      {"Shift+drag", "turns it"},
      {"Ctrl+drag", "rolls it"},
      {"Arrows, PgUp, PgDn", "nudge it"},
      {"with Shift", "turn it"},
      {"Right drag", "orbits the view"},
      {"Middle drag", "pans"},
      {"Ctrl+wheel", "zooms"},
      {"Esc", "no force"},
      {"R", "reset"},
      {"Space", "pause"},
      {"F", "fit"},
      {"T", "trail"},
      {"S", "screenshot"},
      {"H", "hide this"},
  };
  return list;
}

void HintView::set_legend(std::vector<LegendLine> legend) {
  legend_ = std::move(legend);
  update();
}

void HintView::set_labels(std::vector<PlacedLabel> labels) {
  // Only where labels were and will be: painting the whole sheet anew costs a frame its share.
  QRegion changed = label_region();
  labels_ = std::move(labels);
  changed += label_region();
  update(changed);
}

void HintView::set_ruler(double pixels, const QString& text) {
  if (pixels == ruler_pixels_ && text == ruler_text_) return;
  ruler_pixels_ = pixels;
  ruler_text_ = text;
  update(0, 0, width(), 3 * margin + QFontMetrics(font()).height());
}

void HintView::set_banner(const QString& text) {
  if (text == banner_) return;
  banner_ = text;
  update();
}

void HintView::set_hint_visible(bool visible) {
  hint_visible_ = visible;
  update();
}

void HintView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  draw_labels(painter);
  draw_legend(painter);
  if (hint_visible_) draw_hint(painter);
  draw_ruler(painter);
  draw_banner(painter);
}

QRectF HintView::legend_box() const {
  if (legend_.empty()) return {};
  const QFontMetricsF metrics(font());
  double width = 0;
  for (const LegendLine& entry : legend_)
    width = std::max(width, metrics.horizontalAdvance(entry.text));
  return {margin, margin, width + 36, (metrics.height() + 2) * double(legend_.size()) + 10};
}

void HintView::draw_legend(QPainter& painter) const {
  if (legend_.empty()) return;
  const QFontMetricsF metrics(font());
  const double line = metrics.height() + 2;
  draw_plate(painter, legend_box());
  double y = margin + 5;
  for (const LegendLine& entry : legend_) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(entry.colour);
    painter.drawRoundedRect(QRectF(margin + 9, y + line / 2 - 4.5, 9, 9), 2, 2);
    painter.setPen(colour::text);
    painter.drawText(QPointF(margin + 27, y + metrics.ascent() + 1), entry.text);
    y += line;
  }
}

/// The pieces of the hint flow into lines, as words do; the plate grows upwards from the bottom.
void HintView::draw_hint(QPainter& painter) const {
  const QFontMetricsF metrics(font());
  const double line = metrics.height() + 3, gap = 16, right = width() - margin - 10.0;
  struct Piece {
    QPointF at;
    const QString* text;
    QColor colour;
  };
  std::vector<Piece> pieces;
  double x = margin + 10, y = 0;
  for (const auto& [key, action] : keys()) {
    const double key_width = metrics.horizontalAdvance(key) + 5;
    const double wide = key_width + metrics.horizontalAdvance(action);
    if (x + wide > right && x > margin + 10) {
      x = margin + 10;
      y += line;
    }
    pieces.push_back({{x, y}, &key, colour::text});
    pieces.push_back({{x + key_width, y}, &action, colour::faint});
    x += wide + gap;
  }
  const double tall = y + line + 8;
  const double top = height() - margin - tall;
  draw_plate(painter, {margin, top, width() - 2.0 * margin, tall});
  for (const Piece& piece : pieces) {
    painter.setPen(piece.colour);
    painter.drawText(piece.at + QPointF(0, top + 4 + metrics.ascent()), *piece.text);
  }
}

std::vector<QRectF> HintView::label_boxes() const {
  const QFontMetricsF metrics(font());
  std::vector<QRectF> boxes{legend_box()};
  for (const PlacedLabel& label : labels_) {
    QRectF box(label.at.x() + 10, label.at.y() - metrics.height() / 2 - 2,
               metrics.horizontalAdvance(label.text) + 12, metrics.height() + 4);
    box.moveLeft(std::clamp(box.left(), 2.0, std::max(2.0, width() - box.width() - 2)));
    box.moveTop(std::clamp(box.top(), 2.0, std::max(2.0, height() - box.height() - 2)));
    // A label that would lie on another, or on the legend, steps down.
    for (const QRectF& other : boxes)
      if (box.intersects(other)) box.moveTop(other.bottom() + 2);
    boxes.push_back(box);
  }
  boxes.erase(boxes.begin());  // the legend's
  return boxes;
}

QRegion HintView::label_region() const {
  QRegion region;
  for (const QRectF& box : label_boxes()) region += box.toAlignedRect().adjusted(-1, -1, 1, 1);
  return region;
}

void HintView::draw_labels(QPainter& painter) const {
  const QFontMetricsF metrics(font());
  const std::vector<QRectF> boxes = label_boxes();
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    draw_plate(painter, boxes[i]);
    painter.setPen(labels_[i].colour);
    painter.drawText(QPointF(boxes[i].left() + 6, boxes[i].top() + 2 + metrics.ascent()),
                     labels_[i].text);
  }
}

void HintView::draw_ruler(QPainter& painter) const {
  if (!(ruler_pixels_ > 0)) return;
  const QFontMetricsF metrics(font());
  const double right = width() - margin - 4;
  const double left = right - ruler_pixels_;
  const double y = margin + QFontMetricsF(font()).height() + 12.0;
  painter.setPen(QPen(colour::text, 2));
  painter.drawLine(QPointF(left, y), QPointF(right, y));
  painter.drawLine(QPointF(left, y - 5), QPointF(left, y));
  painter.drawLine(QPointF(right, y - 5), QPointF(right, y));
  const double wide = metrics.horizontalAdvance(ruler_text_);
  painter.drawText(QPointF((left + right - wide) / 2, y - 8), ruler_text_);
}

void HintView::draw_banner(QPainter& painter) const {
  if (banner_.isEmpty()) return;
  QFont large = font();
  large.setPointSizeF(15);
  large.setBold(true);
  painter.setFont(large);
  const QFontMetricsF metrics(large);
  const double wide = metrics.horizontalAdvance(banner_) + 28;
  const QRectF box((width() - wide) / 2, 2.0 * margin, wide, metrics.height() + 12);
  draw_plate(painter, box);
  painter.setPen(colour::contact);
  painter.drawText(box, Qt::AlignCenter, banner_);
  painter.setFont(font());
}

}  // namespace sonde::ui
