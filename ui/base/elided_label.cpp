// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/elided_label.hpp"

#include <QPainter>

#include "ui/base/format.hpp"

namespace sonde::ui {

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent) { setTextFormat(Qt::PlainText); }

void ElidedLabel::show_text(const QString& text) {
  setText(text);
  setToolTip(tooltip_of(text));
}

QString ElidedLabel::shown() const {
  const auto fitted = [this](const QString& line) {
    return fontMetrics().elidedText(line, Qt::ElideRight, contentsRect().width());
  };
  QString some = text();
  QStringList items = separator_.isEmpty() ? QStringList() : some.split(separator_);
  while (items.size() > 1 && fitted(some) != some) {
    items.removeLast();
    some = items.join(separator_) + separator_ + QStringLiteral("…");
  }
  return fitted(some);
}

QSize ElidedLabel::minimumSizeHint() const { return {1, QLabel::minimumSizeHint().height()}; }

void ElidedLabel::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.drawText(contentsRect(), static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter), shown());
}

}  // namespace sonde::ui
