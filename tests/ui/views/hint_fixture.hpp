// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <QImage>
#include <memory>
#include <vector>

#include "tests/ui/window_fixture.hpp"
#include "ui/views/hint_view.hpp"

namespace sonde::ui::test {

/// The sheet of text alone, of 800 × 600 pixels, on black.
class HintViewTest : public testing::Test {
 protected:
  void SetUp() override {
    need_application();
    darken();
    hints = std::make_unique<HintView>(nullptr);
    hints->resize(800, 600);
  }
  QImage sheet() const {
    QImage out(hints->size(), QImage::Format_RGB32);
    out.fill(Qt::black);
    hints->render(&out, QPoint(), QRegion(), QWidget::DrawChildren);
    return out;
  }
  /// The pixels of about that colour.
  std::vector<QPoint> pixels(const QColor& colour, int within = 60) const {
    const QImage image = sheet();
    std::vector<QPoint> out;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        const QColor at(image.pixel(x, y));
        if (std::abs(at.red() - colour.red()) + std::abs(at.green() - colour.green()) +
                std::abs(at.blue() - colour.blue()) <
            within)
          out.emplace_back(x, y);
      }
    return out;
  }
  static QRect around(const std::vector<QPoint>& points) {
    QRect out;
    for (const QPoint& at : points) out |= QRect(at, QSize(1, 1));
    return out;
  }

  std::unique_ptr<HintView> hints;
};

}  // namespace sonde::ui::test
