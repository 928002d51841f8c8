// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/time_charts.hpp"

#include <gtest/gtest.h>

#include <QTest>
#include <QWheelEvent>
#include <algorithm>

#include "tests/ui/lit_pixels.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/base/theme.hpp"

namespace sonde::ui::test {
namespace {

/// Ten seconds at 100 Hz of 4 N and 2 mm.
Curves steady_curves() {
  Curves out;
  Snapshot tick;
  tick.separation.status = Status::penetrating;
  tick.separation.depth = 0.002;
  tick.wrench.force = Vec3(4, 0, 0);
  for (int i = 0; i <= 1000; ++i) out.add(tick, 0.01 * i, nullptr);
  return out;
}

class TimeChartsTest : public testing::Test {
 protected:
  void SetUp() override {
    const char* display = std::getenv("DISPLAY");
    ASSERT_TRUE(display && *display) << "these tests open windows: set DISPLAY (Xvfb will do)";
    need_application();
    charts = std::make_unique<TimeCharts>(nullptr);
    charts->resize(400, 300);
    charts->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(charts.get()));
    draw({Curve::held, Curve::force}, 2, 6, 100);
  }
  void draw(const std::vector<Curve>& shown, double from, double to, double cursor) {
    ChartView view{.lines = {}, .from = from, .to = to, .cursor = cursor, .unit = LengthUnit()};
    for (const Curve curve : shown) view.lines.push_back({&curves, curve});
    charts->draw(view);
  }
  /// Rows of the picture, in Qt's pixels from above, that are lit in about that colour.
  std::vector<double> rows_of(const QColor& colour) const {
    const QColor wanted = readable(colour, charts->palette());
    const QImage image = charts->picture();
    std::vector<double> out;
    for (const int y : test::lit_lines(image, Qt::Horizontal, wanted, 60, image.width() / 2))
      out.push_back(y / charts->devicePixelRatioF());
    return out;
  }
  void mouse(QEvent::Type type, double x, Qt::MouseButton button, Qt::MouseButtons held) {
    QMouseEvent event(type, QPointF(x, 50), button, held, Qt::NoModifier);
    QApplication::sendEvent(charts.get(), &event);
  }

  const Curves curves = steady_curves();
  std::unique_ptr<TimeCharts> charts;
};

TEST_F(TimeChartsTest, each_curve_has_a_name_and_the_unit_that_its_scale_is_of) {
  const auto styles = curve_styles(LengthUnit(0.05));
  ASSERT_EQ(styles.size(), curve_count);
  for (std::size_t i = 0; i < styles.size(); ++i) {
    const CurveStyle& style = styles[i];
    EXPECT_EQ(std::size_t(style.curve), i);
    EXPECT_FALSE(style.name.isEmpty());
    const double wanted = style.unit.startsWith('m') ? 1e3 : 1;  // mm, ms, mJ
    EXPECT_NEAR(style.scale, wanted, 1e-9) << style.name.toStdString();
  }
  EXPECT_EQ(curve_styles(LengthUnit(5))[0].unit, "m");
  EXPECT_EQ(curve_styles(LengthUnit(5))[0].scale, 1);
}

TEST_F(TimeChartsTest, curves_of_one_unit_share_a_chart_and_another_unit_lies_below) {
  const std::vector<double> held = rows_of(colour::ghost), force = rows_of(colour::force);
  ASSERT_FALSE(held.empty());
  ASSERT_FALSE(force.empty());
  EXPECT_LT(held.back(), 150) << "the upper half";
  EXPECT_GT(force.front(), 150);
  draw({Curve::force}, 2, 6, 100);
  EXPECT_TRUE(rows_of(colour::ghost).empty()) << "it is not wanted any more";
  ASSERT_FALSE(rows_of(colour::force).empty());
  EXPECT_LT(rows_of(colour::force).back(), 150) << "it has the whole height";
}

TEST_F(TimeChartsTest, a_line_ends_where_its_ticks_do) {
  draw({Curve::force}, 5, 15, 100);  // there are none in the second half
  const QColor wanted = readable(colour::force, charts->palette());
  const QImage image = charts->picture().convertToFormat(QImage::Format_RGB32);
  double last = 0;
  for (int x = 0; x < image.width(); ++x)
    for (int y = 0; y < image.height(); ++y) {
      const QColor at(image.pixel(x, y));
      if (std::abs(at.red() - wanted.red()) + std::abs(at.green() - wanted.green()) +
              std::abs(at.blue() - wanted.blue()) <
          60)
        last = x / charts->devicePixelRatioF();
    }
  EXPECT_NEAR(charts->time_at(last), 10, 0.1);
}

TEST_F(TimeChartsTest, a_click_asks_for_its_time_and_a_drag_for_as_much_as_it_moves) {
  std::vector<double> clicked, hovered;
  double dragged = 0;
  QObject::connect(charts.get(), &TimeCharts::clicked,
                   [&](double time) { clicked.push_back(time); });
  QObject::connect(charts.get(), &TimeCharts::hovered,
                   [&](double time) { hovered.push_back(time); });
  QObject::connect(charts.get(), &TimeCharts::dragged, [&](double seconds) { dragged += seconds; });
  mouse(QEvent::MouseMove, 120, Qt::NoButton, Qt::NoButton);
  EXPECT_EQ(hovered, std::vector<double>{charts->time_at(120)});
  mouse(QEvent::MouseButtonPress, 150, Qt::LeftButton, Qt::LeftButton);
  mouse(QEvent::MouseMove, 152, Qt::NoButton, Qt::LeftButton);  // a hand is not so still
  mouse(QEvent::MouseButtonRelease, 152, Qt::LeftButton, Qt::NoButton);
  EXPECT_EQ(clicked, std::vector<double>{charts->time_at(150)});
  EXPECT_EQ(dragged, 0);
  mouse(QEvent::MouseButtonPress, 150, Qt::LeftButton, Qt::LeftButton);
  for (const double x : {170, 200, 190}) mouse(QEvent::MouseMove, x, Qt::NoButton, Qt::LeftButton);
  mouse(QEvent::MouseButtonRelease, 190, Qt::LeftButton, Qt::NoButton);
  EXPECT_NEAR(dragged, charts->time_at(150) - charts->time_at(190), 1e-12);
  EXPECT_LT(dragged, 0) << "to the right: earlier times come in";
  EXPECT_EQ(clicked.size(), 1u) << "a drag is no click";
}

TEST_F(TimeChartsTest, a_notch_of_the_wheel_and_one_back_are_nothing) {
  double all = 1, about = 0;
  QObject::connect(charts.get(), &TimeCharts::zoomed, [&](double factor, double time) {
    all *= factor;
    about = time;
  });
  const auto turn = [&](int by) {
    QWheelEvent wheel(QPointF(300, 50), charts->mapToGlobal(QPoint(300, 50)), {}, {0, by},
                      Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(charts.get(), &wheel);
  };
  turn(120);
  EXPECT_LT(all, 1) << "away from oneself: less time is seen";
  EXPECT_EQ(about, charts->time_at(300)) << "what is under the cursor stays there";
  turn(-120);
  EXPECT_NEAR(all, 1, 1e-12);
}

}  // namespace
}  // namespace sonde::ui::test
