// SPDX-License-Identifier: GPL-3.0-or-later
// Reference: the pixels that a part of the whole has.
#include "ui/panels/bar.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

TEST(BarTest, each_part_has_its_share_of_the_width) {
  need_application();
  Bar bar(nullptr);
  bar.resize(200, 9);
  const QColor red(200, 0, 0), green(0, 200, 0);
  const auto count = [&](const QColor& colour) {
    const QImage picture = bar.grab().toImage();
    int pixels = 0;
    for (int x = 0; x < picture.width(); ++x)
      pixels += picture.pixelColor(x, picture.height() / 2) == colour;
    return double(pixels) / picture.width();
  };
  bar.set({{0.25, red}, {0.5, green}});
  EXPECT_NEAR(count(red), 0.25, 0.015);
  EXPECT_NEAR(count(green), 0.5, 0.015);
  bar.set({{std::numeric_limits<double>::quiet_NaN(), red}, {-1, red}, {7, green}});
  EXPECT_EQ(count(red), 0) << "what is no share has no room";
  EXPECT_NEAR(count(green), 1, 0.015);
  bar.set({});
  EXPECT_EQ(count(red) + count(green), 0);
}

}  // namespace
}  // namespace sonde::ui::test
