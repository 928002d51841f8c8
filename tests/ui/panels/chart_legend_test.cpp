// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/chart_legend.hpp"

#include <gtest/gtest.h>

#include "tests/ui/window_fixture.hpp"
#include "ui/base/theme.hpp"

namespace sonde::ui::test {
namespace {

class ChartLegendTest : public ::testing::Test {
 protected:
  void SetUp() override {
    need_application();
    chart = std::make_unique<QWidget>();
    chart->resize(300, 200);
    legend = new ChartLegend(chart.get());
    legend->set_entries({{QStringLiteral("■"), mark, QStringLiteral("goes in")},
                         {QStringLiteral("——"), Qt::white, QStringLiteral("a long line"), behind},
                         {QStringLiteral("■"), Qt::black, QStringLiteral("of three")}});
  }
  void TearDown() override { darken(); }
  bool seen(const QColor& colour) const {
    const QImage image = legend->grab().toImage();
    for (int x = 0; x < image.width(); ++x)
      for (int y = 0; y < image.height(); ++y)
        if (image.pixelColor(x, y) == colour) return true;
    return false;
  }
  const QColor mark{0x1b, 0x78, 0x37}, behind{0x2c, 0x7a, 0x58};
  std::unique_ptr<QWidget> chart;
  ChartLegend* legend = nullptr;
};

TEST_F(ChartLegendTest, it_lies_at_the_foot_as_high_as_its_width_requires) {
  legend->arrange();
  const int high = legend->height();
  for (const int width : {300, 110}) {
    chart->resize(width, 200);
    legend->arrange();
    EXPECT_TRUE(chart->rect().contains(legend->geometry())) << width;
    EXPECT_GT(legend->geometry().bottom(), 190) << width;
    EXPECT_EQ(legend->y(), qRound(200 - legend->room())) << width;
    EXPECT_TRUE(seen(mark)) << width;
    EXPECT_TRUE(seen(behind)) << width;
  }
  EXPECT_GE(legend->height(), 2 * high) << "no entry has room beside another";
}

TEST_F(ChartLegendTest, its_words_follow_the_theme_and_its_marks_do_not) {
  for (const bool light : {false, true}) {
    if (light) QApplication::setPalette(QPalette(QColor(226, 230, 236), QColor(240, 242, 245)));
    legend->arrange();
    EXPECT_TRUE(legend->text().contains(faint_text(chart->palette()).name())) << light;
    EXPECT_TRUE(seen(mark)) << light;
  }
}

}  // namespace
}  // namespace sonde::ui::test
