// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/hint_view.hpp"

#include <QPainter>
#include <algorithm>
#include <utility>

#include "ui/theme.hpp"

namespace sonde::ui {
namespace {

constexpr int margin = 14;
const QColor plate(14, 17, 21, 185);

QFont small_font(const QWidget& widget) {
  QFont font = widget.font();
  font.setPointSizeF(9.5);
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
      {"Drag", "move the probe in the view plane"},
      {"Wheel", "move it in depth"},
      {"Shift + drag", "turn it"},
      {"Ctrl + drag", "roll it about the line of sight"},
      {"Arrows, PgUp, PgDn", "nudge it; with Shift, turn it"},
      {"Right drag", "orbit the camera"},
      {"Middle drag, Ctrl + wheel", "pan, zoom"},
      {"R, Space, F, S, H", "reset, pause, fit, screenshot, hide this"},
  };
  return list;
}

void HintView::set_legend(std::vector<LegendLine> legend) {
  legend_ = std::move(legend);
  update();
}

void HintView::set_labels(std::vector<PlacedLabel> labels) {
  labels_ = std::move(labels);
  update();
}

void HintView::set_ruler(double pixels, const QString& text) {
  ruler_pixels_ = pixels;
  ruler_text_ = text;
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

void HintView::draw_legend(QPainter& painter) const {
  if (legend_.empty()) return;
  const QFontMetricsF metrics(font());
  const double line = metrics.height() + 3;
  double width = 0;
  for (const LegendLine& entry : legend_)
    width = std::max(width, metrics.horizontalAdvance(entry.text));
  draw_plate(painter, {margin, margin, width + 38, line * double(legend_.size()) + 12});
  double y = margin + 6;
  for (const LegendLine& entry : legend_) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(entry.colour);
    painter.drawRoundedRect(QRectF(margin + 9, y + line / 2 - 5, 10, 10), 2, 2);
    painter.setPen(colour::text);
    painter.drawText(QPointF(margin + 28, y + metrics.ascent() + 1.5), entry.text);
    y += line;
  }
}

void HintView::draw_hint(QPainter& painter) const {
  const QFontMetricsF metrics(font());
  const double line = metrics.height() + 2;
  double first = 0, second = 0;
  for (const auto& [key, action] : keys()) {
    first = std::max(first, metrics.horizontalAdvance(key));
    second = std::max(second, metrics.horizontalAdvance(action));
  }
  const double tall = line * double(keys().size()) + 12;
  const QRectF box(margin, height() - margin - tall, first + second + 34, tall);
  draw_plate(painter, box);
  double y = box.top() + 6 + metrics.ascent();
  for (const auto& [key, action] : keys()) {
    painter.setPen(colour::text);
    painter.drawText(QPointF(box.left() + 10, y), key);
    painter.setPen(colour::faint);
    painter.drawText(QPointF(box.left() + 24 + first, y), action);
    y += line;
  }
}

void HintView::draw_labels(QPainter& painter) const {
  const QFontMetricsF metrics(font());
  std::vector<QRectF> taken;
  for (const PlacedLabel& label : labels_) {
    QRectF box(label.at.x() + 10, label.at.y() - metrics.height() / 2 - 2,
               metrics.horizontalAdvance(label.text) + 12, metrics.height() + 4);
    box.moveLeft(std::clamp(box.left(), 2.0, std::max(2.0, width() - box.width() - 2)));
    box.moveTop(std::clamp(box.top(), 2.0, std::max(2.0, height() - box.height() - 2)));
    // A label that would lie on another steps down.
    for (const QRectF& other : taken)
      if (box.intersects(other)) box.moveTop(other.bottom() + 2);
    taken.push_back(box);
    draw_plate(painter, box);
    painter.setPen(label.colour);
    painter.drawText(QPointF(box.left() + 6, box.top() + 2 + metrics.ascent()), label.text);
  }
}

void HintView::draw_ruler(QPainter& painter) const {
  if (!(ruler_pixels_ > 0)) return;
  const QFontMetricsF metrics(font());
  const double right = width() - margin - 4;
  const double left = right - ruler_pixels_;
  const double y = height() - margin - 4;
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
