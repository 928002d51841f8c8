// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMouseEvent>
#include <QSlider>
#include <QStyle>
#include <QStyleOptionSlider>

namespace sonde::ui {

/// A horizontal slider that jumps to where one clicks, and goes on from there as its handle is
/// dragged. Qt's own goes a page in that direction.
class JumpSlider : public QSlider {
 public:
  explicit JumpSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {}

 protected:
  void mousePressEvent(QMouseEvent* event) override {
    QStyleOptionSlider option;
    initStyleOption(&option);
    const auto part = [&](QStyle::SubControl control) {
      return style()->subControlRect(QStyle::CC_Slider, &option, control, this);
    };
    const QRect handle = part(QStyle::SC_SliderHandle), groove = part(QStyle::SC_SliderGroove);
    if (event->button() == Qt::LeftButton && !handle.contains(event->pos()))
      setValue(QStyle::sliderValueFromPosition(minimum(), maximum(),
                                               event->x() - groove.x() - handle.width() / 2,
                                               groove.width() - handle.width()));
    QSlider::mousePressEvent(event);  // on the handle, which is there by now
  }
};

}  // namespace sonde::ui
