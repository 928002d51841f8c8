// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/colour_scale.hpp"

#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>

#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

const QColor foot(250, 0, 0), head(0, 0, 250);

ColourScale red_to_blue() { return {"gap, mm", {foot, head}, {"0", "1", "2"}}; }

/// The rows in which the picture has any pixel that `wanted` takes.
template <class Wanted>
std::vector<int> rows_with(const QImage& image, int from, int to, const Wanted& wanted) {
  std::vector<int> out;
  for (int y = 0; y < image.height(); ++y)
    for (int x = from; x < to; ++x)
      if (wanted(image.pixelColor(x, y))) {
        out.push_back(y);
        break;
      }
  return out;
}

class ColourScaleTest : public testing::Test {
 protected:
  void SetUp() override {
    need_application();
    font = QApplication::font();  // of the application: before that there is none
  }
  /// In a box of its own size, 10 px from the picture's edges, in white on black.
  QImage drawn(const ColourScale& scale) const {
    const QSizeF size = scale_size(scale, QFontMetricsF(font));
    QImage image((size + QSizeF(20, 20)).toSize(), QImage::Format_RGB32);
    image.fill(Qt::black);
    QPainter painter(&image);
    painter.setFont(font);
    painter.setPen(Qt::white);
    draw_scale(painter, QRectF(QPointF(10, 10), size), scale);
    return image;
  }
  QFont font;
};

TEST_F(ColourScaleTest, the_colours_run_evenly_from_the_first_below_to_the_last_above) {
  const QImage image = drawn(red_to_blue());
  const int x = 10 + 9 + 7;
  const auto rows = rows_with(image, x, x + 1, [](const QColor& at) {
    return at.green() < 10 && at.red() + at.blue() > 200;
  });
  ASSERT_GT(rows.size(), 100u);
  EXPECT_GT(image.pixelColor(x, rows.back()).red(), 240);
  EXPECT_GT(image.pixelColor(x, rows.front()).blue(), 240);
  const QColor middle = image.pixelColor(x, (rows.front() + rows.back()) / 2);
  EXPECT_NEAR(middle.red(), 125, 5);
  EXPECT_NEAR(middle.blue(), 125, 5);
}

/// Strokes beside the column: at its foot, its middle and its head.
TEST_F(ColourScaleTest, a_tick_stands_at_each_of_even_distances) {
  const QImage image = drawn(red_to_blue());
  const int x = 10 + 9 + 14 + 2;
  const auto rows =
      rows_with(image, x, x + 1, [](const QColor& at) { return at.lightness() > 200; });
  const auto title_ends = 10 + static_cast<int>(QFontMetricsF(font).height()) + 10;
  std::vector<int> ticks;
  for (const int y : rows)
    if (y > title_ends) ticks.push_back(y);
  ASSERT_EQ(ticks.size(), 3u);
  EXPECT_NEAR(ticks[1] - ticks[0], ticks[2] - ticks[1], 1);
  EXPECT_GT(ticks[1] - ticks[0], 60);
}

TEST_F(ColourScaleTest, its_box_holds_all_that_is_drawn) {
  for (const QString& title : {QString("g"), QString("a title much wider than the ticks are")}) {
    ColourScale scale = red_to_blue();
    scale.title = title;
    scale.ticks[1] = "a tick";
    const QImage image = drawn(scale);
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        if (x < 10 || y < 10 || x >= image.width() - 10 || y >= image.height() - 10) {
          ASSERT_EQ(image.pixelColor(x, y), QColor(Qt::black)) << x << ", " << y;
        }
  }
}

TEST_F(ColourScaleTest, without_colours_there_is_none) {
  EXPECT_TRUE(scale_size({"gap", {}, {"0"}}, QFontMetricsF(font)).isEmpty());
  QImage image(40, 40, QImage::Format_RGB32);
  image.fill(Qt::black);
  QPainter painter(&image);
  painter.setPen(Qt::white);
  draw_scale(painter, QRectF(0, 0, 40, 40), {"gap", {}, {"0"}});
  EXPECT_TRUE(rows_with(image, 0, 40, [](const QColor& at) { return at != Qt::black; }).empty());
}

}  // namespace
}  // namespace sonde::ui::test
