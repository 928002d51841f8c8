// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/study_chart.hpp"

#include <QLabel>
#include <QTest>

#include "engine/study/charts/svg_elements.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/base/format.hpp"
#include "ui/base/theme.hpp"

namespace sonde::ui::test {
namespace {

ChartAxis log_axis(const char* label) {
  ChartAxis axis;
  axis.label = label;
  axis.logarithmic = true;
  return axis;
}

/// A line from (1, 1) to (100, 10 000) on logarithmic axes, and a point at (10, 10).
ChartPanel panel() {
  ChartPanel out{"a square", log_axis("x, m"), log_axis("y, m²"), {}, {}, {}};
  out.series = {{"x squared", {1, 3, 10, 30, 100}, {1, 9, 100, 900, 1e4}}, {"a point", {10}, {10}}};
  out.series[1].form = ChartSeries::Form::points;
  return out;
}

class StudyChartTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* display = std::getenv("DISPLAY");
    ASSERT_TRUE(display && *display) << "these tests open windows: set DISPLAY (Xvfb will do)";
    need_application();
    chart = std::make_unique<StudyChart>(nullptr);
    chart->resize(500, 400);
    chart->set_panel(panel());
    chart->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(chart.get()));
  }
  void TearDown() override { darken(); }
  /// The pixels that are about of the colour of a series.
  std::vector<QPoint> pixels(std::size_t series) const {
    const QColor colour = readable(QColor(text(svg::series_color(series))), chart->palette());
    const QImage image = chart->picture().convertToFormat(QImage::Format_RGB32);
    std::vector<QPoint> out;
    for (int x = 0; x < image.width(); ++x)
      for (int y = 0; y < image.height(); ++y) {
        const QColor at(image.pixel(x, y));
        if (std::abs(at.red() - colour.red()) + std::abs(at.green() - colour.green()) +
                std::abs(at.blue() - colour.blue()) <
            60)
          out.emplace_back(x, y);
      }
    return out;
  }
  std::unique_ptr<StudyChart> chart;
};

/// A power is a straight line there. The reference is the picture.
TEST_F(StudyChartTest, a_power_is_a_straight_line_on_logarithmic_axes) {
  for (const bool light : {false, true}) {
    if (light) QApplication::setPalette(QPalette(QColor(226, 230, 236), QColor(240, 242, 245)));
    const std::vector<QPoint> line = pixels(0);
    ASSERT_GT(line.size(), 200U) << light;
    const auto [first, last] = std::minmax_element(
        line.begin(), line.end(), [](const QPoint& a, const QPoint& b) { return a.x() < b.x(); });
    const QPointF from(*first), way(*last - *first);
    EXPECT_GT(way.x(), 300);
    EXPECT_LT(way.y(), -200);
    for (const QPoint& at : line) {
      const double share = (at.x() - from.x()) / way.x();
      EXPECT_NEAR(at.y(), from.y() + share * way.y(), 4) << at.x();
    }
  }
}

TEST_F(StudyChartTest, a_point_stands_where_its_numbers_are) {
  const std::vector<QPoint> line = pixels(0), point = pixels(1);
  ASSERT_GT(point.size(), 20U);
  double x = 0, y = 0;
  for (const QPoint& at : point) {
    x += double(at.x()) / double(point.size());
    y += double(at.y()) / double(point.size());
  }
  const auto by_x = [](const QPoint& a, const QPoint& b) { return a.x() < b.x(); };
  const auto [first, last] = std::minmax_element(line.begin(), line.end(), by_x);
  EXPECT_NEAR(x, 0.5 * (first->x() + last->x()), 3) << "10 is halfway from 1 to 100";
  EXPECT_NEAR(y, first->y() + 0.25 * (last->y() - first->y()), 3) << "a quarter of the way to 10^4";
}

TEST_F(StudyChartTest, its_legend_names_what_is_drawn) {
  const auto* legend = chart->findChild<QLabel*>();
  ASSERT_TRUE(legend);
  EXPECT_TRUE(legend->text().contains(QStringLiteral("x&nbsp;squared")))
      << legend->text().toStdString();
  EXPECT_TRUE(legend->text().contains(QStringLiteral("a&nbsp;point")));
  chart->set_panel({"empty", {"x"}, {"y"}, {}, {}, {}});
  EXPECT_TRUE(pixels(0).empty());
}

}  // namespace
}  // namespace sonde::ui::test
