// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/travel_plot.hpp"

#include <QTest>

#include "tests/ui/lit_pixels.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/base/theme.hpp"

namespace sonde::ui::test {
namespace {

constexpr double longest = 0.03, binds_at = 0.02;  // m

/// Free for 20 mm, then deeper and harder with each.
TravelCurves curves_of(int steps) {
  TravelCurves curves;
  for (int i = 0; i <= steps; ++i) {
    const double travel = longest * i / steps;
    curves.travel.push_back(travel);
    curves.room.push_back(binds_at - travel);
    curves.force.push_back(std::max(0.0, 500 * (travel - binds_at)));
  }
  curves.first = binds_at;
  return curves;
}

class TravelPlotTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* display = std::getenv("DISPLAY");
    ASSERT_TRUE(display && *display) << "these tests open windows: set DISPLAY (Xvfb will do)";
    need_application();
    plot = std::make_unique<TravelPlot>(nullptr);
    QObject::connect(plot.get(), &TravelPlot::sought, [this](double travel) { sought = travel; });
    plot->resize(320, 250);
    plot->set_curves(curves_of(200), LengthUnit());
    plot->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(plot.get()));
  }
  void TearDown() override { darken(); }
  /// Columns of the picture in which at least so many pixels are about of that colour.
  std::vector<int> columns(const QColor& colour, int least) const {
    return test::lit_lines(plot->picture(), Qt::Vertical, colour, 60, least - 1);
  }
  std::unique_ptr<TravelPlot> plot;
  double sought = -1;
};

/// The reference is the picture.
TEST_F(TravelPlotTest, the_line_stands_where_a_click_means_that_travel) {
  for (const double travel : {0.004, 0.025}) {
    plot->show_at(travel);
    const auto line = columns(plot->palette().color(QPalette::WindowText), 120);
    ASSERT_FALSE(line.empty()) << travel;
    EXPECT_LE(line.back() - line.front(), 2) << "pixels";
    const double x = 0.5 * (line.front() + line.back()) / plot->devicePixelRatioF();
    QTest::mouseClick(plot.get(), Qt::LeftButton, {}, QPoint(qRound(x), 60));
    EXPECT_NEAR(sought, travel, 2.5e-4) << "two pixels";
  }
}

TEST_F(TravelPlotTest, a_click_beside_the_curves_goes_to_an_end) {
  QTest::mouseClick(plot.get(), Qt::LeftButton, {}, QPoint(2, 60));
  EXPECT_EQ(sought, 0);
  QTest::mouseClick(plot.get(), Qt::LeftButton, {}, QPoint(plot->width() - 2, 60));
  EXPECT_EQ(sought, longest);
}

TEST_F(TravelPlotTest, both_curves_and_where_it_binds_are_seen_in_either_theme) {
  for (const bool light : {false, true}) {
    if (light) QApplication::setPalette(QPalette(QColor(226, 230, 236), QColor(240, 242, 245)));
    QApplication::processEvents();
    const QPalette palette = plot->palette();
    ASSERT_EQ(is_light(palette), light);
    for (const QColor& colour : {colour::clearance, colour::force})
      EXPECT_GT(columns(readable(colour, palette), 1).size(), 200u) << light;
    EXPECT_FALSE(columns(readable(colour::contact, palette), 50).empty()) << light;
    EXPECT_GT(columns(plot_background(palette), 100).size(), 250u) << light;
  }
}

TEST_F(TravelPlotTest, many_steps_look_as_few_do) {
  const QImage few = plot->picture();
  plot->set_curves(curves_of(100'000), LengthUnit());
  EXPECT_LT(pixels_between(few, plot->picture()), 400);
}

TEST_F(TravelPlotTest, curves_set_while_it_is_hidden_are_drawn_when_it_is_seen) {
  const QImage before = plot->picture();
  plot->hide();
  TravelCurves other = curves_of(200);
  for (double& room : other.room) room *= -1;
  plot->set_curves(other, LengthUnit());
  plot->show();
  QApplication::processEvents();
  EXPECT_GT(pixels_between(before, plot->picture()), 400);
}

}  // namespace
}  // namespace sonde::ui::test
