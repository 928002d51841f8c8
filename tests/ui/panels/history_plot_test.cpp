// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/history_plot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "tests/ui/window_fixture.hpp"
#include "ui/base/theme.hpp"

namespace sonde::ui::test {
namespace {

class HistoryPlotTest : public ::testing::Test {
 protected:
  void SetUp() override {
    need_application();
    plot = std::make_unique<HistoryPlot>(QStringLiteral("force"), colour::force, nullptr);
    plot->resize(200, 74);
  }
  void TearDown() override { darken(); }
  /// How high the curve is at a part of the width, pixels from above.
  std::optional<double> height_at(double part) const {
    const QImage seen = plot->grab().toImage();
    const QColor colour = readable(colour::force, plot->palette());
    const int x = qRound(part * seen.width());
    double sum = 0;
    int count = 0;
    for (int y = 0; y < seen.height(); ++y) {
      const QColor at = seen.pixelColor(x, y);
      const int apart = std::abs(at.red() - colour.red()) + std::abs(at.green() - colour.green()) +
                        std::abs(at.blue() - colour.blue());
      if (apart > 200) continue;
      sum += y;
      ++count;
    }
    return count > 0 ? std::optional(sum / count / seen.devicePixelRatio()) : std::nullopt;
  }
  /// At 5 for two seconds, at half of that for four, then at none.
  void add_steps(double from = 0) {
    for (int i = 0; i <= 100; ++i) plot->add(from + 0.1 * i, i < 20 ? 5 : i < 60 ? 2.5 : 0);
  }
  std::unique_ptr<HistoryPlot> plot;
};

TEST_F(HistoryPlotTest, the_curve_is_as_high_as_its_values_in_either_theme) {
  add_steps();
  for (const bool light : {false, true}) {
    if (light) QApplication::setPalette(QPalette(QColor(226, 230, 236), QColor(240, 242, 245)));
    ASSERT_EQ(is_light(plot->palette()), light);
    const auto largest = height_at(0.1), half = height_at(0.4), none = height_at(0.8);
    ASSERT_TRUE(largest && half && none) << light;
    EXPECT_NEAR(*half, (*largest + *none) / 2, 1) << light;
    EXPECT_LT(*largest, 30) << light;
    EXPECT_GT(*none, 66) << light;
  }
}

TEST_F(HistoryPlotTest, it_holds_ten_seconds_and_starts_over_when_time_falls) {
  add_steps(100);
  ASSERT_TRUE(height_at(0.1));
  for (int i = 1; i <= 50; ++i) plot->add(110 + 0.1 * i, 0);
  const auto before = height_at(0.05), after = height_at(0.3);  // the step at 106 s
  ASSERT_TRUE(before && after);
  EXPECT_LT(*before, *after - 15);
  add_steps(3);
  const auto largest = height_at(0.1);
  ASSERT_TRUE(largest) << "nothing of what was before";
  EXPECT_LT(*largest, 30);
  plot->clear();
  EXPECT_FALSE(height_at(0.1));
}

TEST_F(HistoryPlotTest, what_is_not_known_is_a_break_and_not_a_slope) {
  plot->show({{0, 5}, {3, 5}, {3, std::nan("")}, {7, 1}, {10, 1}}, 10);
  EXPECT_TRUE(height_at(0.1));
  EXPECT_FALSE(height_at(0.5)) << "nothing between 3 s and 7 s";
  EXPECT_TRUE(height_at(0.9));
  plot->clear();
  plot->add(0, 5);
  plot->add(1, 5);
  plot->add(8, 5);
  plot->add(10, 5);
  EXPECT_FALSE(height_at(0.5)) << "added one by one, too";
  EXPECT_TRUE(height_at(0.9));
}

TEST_F(HistoryPlotTest, it_ends_at_the_moment_that_is_looked_at) {
  plot->show({{2, 5}, {4, 5}}, 8);  // 4 s ago
  EXPECT_TRUE(height_at(0.5));
  EXPECT_FALSE(height_at(0.8));
}

TEST_F(HistoryPlotTest, it_says_so_where_nothing_was_before) {
  const QImage empty = plot->grab().toImage();
  plot->show({{8, 5}, {8.001, 5}}, 8);
  EXPECT_GT(pixels_between(empty, plot->grab().toImage()), 50);
}

}  // namespace
}  // namespace sonde::ui::test
