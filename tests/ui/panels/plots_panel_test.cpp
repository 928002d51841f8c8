// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/plots_panel.hpp"

#include <QLabel>
#include <QTest>
#include <QWheelEvent>

#include "tests/ui/lit_pixels.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/actions/history_control.hpp"

namespace sonde::ui::test {
namespace {

class PlotsTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    open_cubes();
    plots().show();
    plots().raise();
    ASSERT_TRUE(wait_until([this] { return plots().drawn() > 2; }));
  }
  PlotsPanel& plots() { return window->history().plots(); }
  QWidget* canvas() { return &plots().charts(); }
  /// Pixels of the picture that are lit in about that colour.
  int lit(const QColor& colour) {
    const QImage image = plots().charts().picture().convertToFormat(QImage::Format_RGB32);
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        const QColor at(image.pixel(x, y));
        count += std::abs(at.red() - colour.red()) + std::abs(at.green() - colour.green()) +
                     std::abs(at.blue() - colour.blue()) <
                 60;
      }
    return count;
  }
  void next_picture() {
    const std::size_t before = plots().drawn();
    ASSERT_TRUE(wait_until([&] { return plots().drawn() > before; }));
  }
};

TEST_F(PlotsTest, a_chosen_curve_is_drawn) {
  const QColor colour = curve_styles(LengthUnit())[std::size_t(Curve::torque)].colour;
  for (std::size_t i = 0; i < curve_count; ++i) plots().set_shown(static_cast<Curve>(i), false);
  plots().set_shown(Curve::force, true);
  next_picture();
  next_picture();
  EXPECT_EQ(lit(colour), 0);
  plots().set_shown(Curve::torque, true);
  wait(1000);  // a curve of some length
  next_picture();
  EXPECT_GT(lit(colour), 20);
}

TEST_F(PlotsTest, draws_no_more_points_than_there_are_pixels) {
  // Ten minutes at 1 kHz.
  Curves curves;
  Snapshot tick;
  for (int i = 0; i < 600'000; ++i) {
    tick.wrench.force.x() = i % 7;
    curves.add(tick, 1e-3 * i, nullptr);
  }
  TimeCharts& charts = plots().charts();
  ChartView view{.lines = {{&curves, Curve::force}},
                 .from = 0,
                 .to = 600,
                 .cursor = 300,
                 .unit = LengthUnit()};
  charts.draw(view);
  EXPECT_GT(charts.points(), 500u);
  EXPECT_LE(charts.points(), 2u * std::size_t(charts.width()) + 4);
}

TEST_F(PlotsTest, the_wheel_zooms_and_a_drag_pans) {
  const double span = plots().to() - plots().from();
  QWheelEvent wheel(QPointF(300, 50), canvas()->mapToGlobal(QPoint(300, 50)), {}, {0, 120},
                    Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
  QApplication::sendEvent(canvas(), &wheel);
  EXPECT_NEAR(plots().to() - plots().from(), span / 1.25, 1e-9);
  EXPECT_TRUE(plots().follows());
  const auto mouse = [&](QEvent::Type type, double x, Qt::MouseButton button,
                         Qt::MouseButtons held) {
    QMouseEvent event(type, QPointF(x, 50), button, held, Qt::NoModifier);
    QApplication::sendEvent(canvas(), &event);
  };
  const double from = plots().from();
  mouse(QEvent::MouseButtonPress, 300, Qt::LeftButton, Qt::LeftButton);
  mouse(QEvent::MouseMove, 350, Qt::NoButton, Qt::LeftButton);
  mouse(QEvent::MouseButtonRelease, 350, Qt::LeftButton, Qt::NoButton);
  EXPECT_LT(plots().from(), from) << "to the right: earlier times come in";
  EXPECT_FALSE(plots().follows());
  EXPECT_FALSE(window->history().looking_back()) << "a drag is no click";
}

TEST_F(PlotsTest, a_click_looks_back_at_that_time) {
  wait(500);
  const double time = window->history().recorder().ticks()->first_time() + 0.3;
  window->history().look_at(time + 0.1);
  next_picture();
  // Where that time is in the picture, found by halving.
  double low = 0, high = canvas()->width();
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (plots().charts().time_at(middle) < time ? low : high) = middle;
  }
  QTest::mouseClick(canvas(), Qt::LeftButton, Qt::NoModifier, QPoint(int(low), 40));
  EXPECT_TRUE(window->history().looking_back());
  EXPECT_NEAR(window->history().playback().time(), time, 0.05);
}

/// The reference is the picture: the cursor is the one line that goes through all charts.
TEST_F(PlotsTest, the_cursor_stands_in_every_chart_at_the_time_that_a_click_there_means) {
  wait(500);
  window->history().look_at(window->history().recorder().ticks()->first_time() + 0.3);
  next_picture();
  // The columns of pixels that are white for more than half of the height.
  std::vector<int> columns;
  const auto look = [&] {
    const QImage image = plots().charts().picture();
    columns = test::lit_lines(image, Qt::Vertical, canvas()->palette().color(QPalette::WindowText),
                              200, image.height() / 2);
    return !columns.empty();
  };
  ASSERT_TRUE(wait_until(look));
  EXPECT_LE(columns.back() - columns.front(), 3);  // pixels
  const double x = 0.5 * (columns.front() + columns.back()) / canvas()->devicePixelRatioF();
  const double pixel = plots().charts().time_at(1) - plots().charts().time_at(0);
  EXPECT_NEAR(plots().charts().time_at(x), window->history().playback().time(), 2 * pixel);
}

TEST_F(PlotsTest, the_values_under_the_cursor_are_written) {
  const auto* values = window->findChild<QLabel*>("plot_values");
  ASSERT_TRUE(wait_until([&] { return values->text().contains("|F|"); }));
  EXPECT_TRUE(values->text().contains(" N"));
  EXPECT_TRUE(values->text().contains("held"));
}

TEST_F(PlotsTest, what_is_not_seen_is_not_drawn) {
  plots().hide();
  const std::size_t before = plots().drawn();
  wait(500);
  EXPECT_EQ(plots().drawn(), before);
}

}  // namespace
}  // namespace sonde::ui::test
