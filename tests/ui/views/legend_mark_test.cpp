// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/legend_mark.hpp"

#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>
#include <QPalette>

#include "ui/base/theme.hpp"

namespace sonde::ui::test {
namespace {

constexpr int size = 21;
const QColor ground(10, 10, 10);

QImage drawn(const LegendLine& entry) {
  QImage image(size, size, QImage::Format_RGB32);
  image.fill(ground);
  QPalette dark;
  dark.setColor(QPalette::Window, ground);
  QPainter painter(&image);
  draw_mark(painter, QRectF(2, 2, size - 4, size - 4), entry, dark);
  return image;
}

TEST(LegendMarkTest, a_body_has_its_own_colour_and_a_right_half_may_have_another) {
  const QImage one = drawn({colour::probe, {}, LegendMark::filled, {}});
  EXPECT_EQ(one.pixelColor(5, size / 2), colour::probe);
  EXPECT_EQ(one.pixelColor(size - 6, size / 2), colour::probe);
  const QImage two = drawn({colour::probe, {}, LegendMark::filled, colour::ghost_on_probe});
  EXPECT_EQ(two.pixelColor(5, size / 2), colour::probe);
  EXPECT_EQ(two.pixelColor(size - 6, size / 2), colour::ghost_on_probe);
}

TEST(LegendMarkTest, a_ring_is_open_and_what_is_clear_lets_the_ground_through) {
  EXPECT_EQ(drawn({colour::probe, {}, LegendMark::ring, {}}).pixelColor(size / 2, size / 2),
            ground);
  const QColor clear =
      drawn({colour::probe, {}, LegendMark::clear, {}}).pixelColor(size / 2, size / 2);
  EXPECT_NEAR(clear.red(), 0.4 * colour::probe.red() + 0.6 * ground.red(), 2);
  EXPECT_NEAR(clear.blue(), 0.4 * colour::probe.blue() + 0.6 * ground.blue(), 2);
}

}  // namespace
}  // namespace sonde::ui::test
