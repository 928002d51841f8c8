// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/elided_label.hpp"

#include <QPainter>

namespace sonde::ui {

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent) { setTextFormat(Qt::PlainText); }

void ElidedLabel::show_text(const QString& text) {
  setText(text);
  setToolTip(text.toHtmlEscaped());
}

QString ElidedLabel::shown() const {
  return fontMetrics().elidedText(text(), Qt::ElideRight, contentsRect().width());
}

QSize ElidedLabel::minimumSizeHint() const { return {1, QLabel::minimumSizeHint().height()}; }

void ElidedLabel::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.drawText(contentsRect(), static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter), shown());
}

}  // namespace sonde::ui
