// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/body_mark.hpp"

#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>

#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

TEST(BodyMark, is_a_small_box_of_the_colour_with_round_corners) {
  need_application();
  const QColor colour(40, 180, 90), behind(Qt::black);
  BodyMark mark(colour, nullptr);
  QImage image(mark.size() + QSize(2, 2), QImage::Format_RGB32);
  image.fill(behind);
  QPainter painter(&image);
  mark.render(&painter, QPoint(1, 1), QRegion(), QWidget::RenderFlags());
  painter.end();
  ASSERT_EQ(mark.size(), QSize(9, 9));
  EXPECT_EQ(image.pixelColor(5, 5), colour);
  EXPECT_EQ(image.pixelColor(1, 5), colour) << "up to its edge";
  EXPECT_NE(image.pixelColor(1, 1), colour) << "its corner is round";
  EXPECT_EQ(image.pixelColor(0, 5), behind);
}

}  // namespace
}  // namespace sonde::ui::test
