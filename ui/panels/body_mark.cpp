// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/body_mark.hpp"

#include <QPainter>

namespace sonde::ui {

BodyMark::BodyMark(const QColor& colour, QWidget* parent) : QWidget(parent), colour_(colour) {
  setFixedSize(9, 9);
}

void BodyMark::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour_);
  painter.drawRoundedRect(rect(), 2, 2);
}

}  // namespace sonde::ui
