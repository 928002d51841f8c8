// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/bar.hpp"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <utility>

namespace sonde::ui {

Bar::Bar(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void Bar::set(std::vector<Part> parts) {
  parts_ = std::move(parts);
  update();
}

void Bar::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath outline;
  outline.addRoundedRect(rect(), 3, 3);
  painter.setClipPath(outline);
  painter.fillRect(rect(), palette().base());
  double left = 0;
  for (const Part& part : parts_) {
    const double wide =
        std::isfinite(part.fraction) ? std::clamp(part.fraction, 0.0, 1.0) * width() : 0;
    painter.fillRect(QRectF(left, 0, wide, height()), part.colour);
    left += wide;
  }
}

}  // namespace sonde::ui
