// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/chart_canvas.hpp"

#include <gtest/gtest.h>
#include <vtkChartXY.h>
#include <vtkNew.h>

#include <QTest>

#include "tests/ui/window_fixture.hpp"
#include "ui/base/theme.hpp"

namespace sonde::ui::test {
namespace {

/// Counts how often it was arranged, and holds a chart about a place.
class CountedCanvas : public ChartCanvas {
 public:
  CountedCanvas() : ChartCanvas(nullptr) {}
  using ChartCanvas::place_chart;
  using ChartCanvas::redraw;
  int arranged = 0, presses = 0;

 protected:
  void arrange(double /*ratio*/) override { ++arranged; }
  void mousePressEvent(QMouseEvent* /*event*/) override { ++presses; }
};

class ChartCanvasTest : public testing::Test {
 protected:
  void SetUp() override {
    const char* display = std::getenv("DISPLAY");
    ASSERT_TRUE(display && *display) << "these tests open windows: set DISPLAY (Xvfb will do)";
    need_application();
    canvas = std::make_unique<CountedCanvas>();
    canvas->resize(300, 200);
  }
  void TearDown() override { darken(); }
  void show() {
    canvas->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(canvas.get()));
  }
  std::unique_ptr<CountedCanvas> canvas;
};

TEST_F(ChartCanvasTest, what_is_not_seen_is_not_drawn_until_it_is) {
  for (int i = 0; i < 5; ++i) canvas->redraw();
  EXPECT_EQ(canvas->arranged, 0);
  show();
  const int seen = canvas->arranged;
  EXPECT_GT(seen, 0);
  canvas->redraw();
  EXPECT_EQ(canvas->arranged, seen + 1);
  canvas->hide();
  canvas->redraw();
  EXPECT_EQ(canvas->arranged, seen + 1);
}

TEST_F(ChartCanvasTest, its_background_is_the_themes_and_fills_it_at_any_size) {
  show();
  for (const bool light : {false, true}) {
    if (light) QApplication::setPalette(QPalette(QColor(226, 230, 236), QColor(240, 242, 245)));
    canvas->resize(light ? QSize(400, 120) : QSize(260, 240));
    QApplication::processEvents();
    const QImage image = canvas->picture();
    EXPECT_EQ(image.size(), canvas->size() * canvas->devicePixelRatioF());
    const QColor back = plot_background(canvas->palette());
    for (const QPoint& at : {QPoint(0, 0), QPoint(image.width() - 1, image.height() - 1)}) {
      const QColor pixel = image.pixelColor(at);
      EXPECT_NEAR(pixel.red(), back.red(), 1) << light;
      EXPECT_NEAR(pixel.blue(), back.blue(), 1) << light;
    }
  }
}

TEST_F(ChartCanvasTest, the_mouse_is_its_own) {
  show();
  EXPECT_FALSE(canvas->childAt(150, 100)) << "what draws lets the mouse through";
  QTest::mouseClick(canvas->windowHandle(), Qt::LeftButton, Qt::NoModifier, QPoint(150, 100));
  EXPECT_EQ(canvas->presses, 1);
}

/// VTK counts device pixels from below. Of 200 pixels, 30 to 90 from above are 110 to 170 from
/// below, and twice that at twice the density.
TEST_F(ChartCanvasTest, a_place_from_above_is_one_from_below_in_device_pixels) {
  vtkNew<vtkChartXY> chart;
  canvas->place_chart(*chart, QRectF(20, 30, 100, 60), 2);
  const vtkRectf size = chart->GetSize();
  EXPECT_EQ(size.GetX(), 40);
  EXPECT_EQ(size.GetY(), 220);
  EXPECT_EQ(size.GetWidth(), 200);
  EXPECT_EQ(size.GetHeight(), 120);
}

}  // namespace
}  // namespace sonde::ui::test
