// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/map_chart.hpp"

#include <gtest/gtest.h>
#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkContextScene.h>

#include <QTest>
#include <cmath>
#include <limits>

#include "tests/ui/window_fixture.hpp"
#include "ui/base/theme.hpp"
#include "ui/panels/chart_canvas.hpp"

namespace sonde::ui::test {
namespace {

/// A chart from 10 to 1000 N/m and of two rows, in a place of 200 x 100 pixels.
class CanvasOfMap : public ChartCanvas {
 public:
  CanvasOfMap() : ChartCanvas(nullptr), chart(std::make_unique<MapChart>(scene())) {}
  QColor at(double stiffness, double row) {
    redraw();
    const QPointF place(20 + 100 * std::log10(stiffness / 10), 120 - 50 * row);
    return picture().pixelColor((place * devicePixelRatioF()).toPoint());
  }
  std::unique_ptr<MapChart> chart;

 protected:
  void arrange(double ratio) override {
    place_chart(chart->chart(), QRectF(20, 20, 200, 100), ratio);
    chart->set_axis(vtkAxis::BOTTOM, 1, 3, {});
    chart->set_axis(vtkAxis::LEFT, 0, 2, {});
    chart->widen(ratio);
    chart->chart().RecalculateBounds();
  }
};

/// Passive up to 100 N/m; beyond, unstable in the lower row and chattering in the upper one.
StabilityMap two_rows() {
  StabilityMap map;
  map.low = 10;
  map.high = 1000;
  for (const double from : {0.0, 1.0}) {
    MapRow row;
    row.from = from;
    row.to = from + 1;
    row.stretches = {{10, 100, MapClass::passive},
                     {100, 1000, from == 0 ? MapClass::unstable : MapClass::chattering}};
    map.rows.push_back(row);
  }
  return map;
}

/// What the legend shows for these words.
QColor colour_beside(const char* words) {
  for (const LegendEntry& entry : map_legend())
    if (entry.words == QLatin1String(words)) return entry.colour;
  ADD_FAILURE() << words << " is not in the legend";
  return {};
}

class MapChartTest : public testing::Test {
 protected:
  void SetUp() override {
    const char* display = std::getenv("DISPLAY");
    ASSERT_TRUE(display && *display) << "these tests open windows: set DISPLAY (Xvfb will do)";
    need_application();
    canvas = std::make_unique<CanvasOfMap>();
    canvas->resize(240, 140);
    canvas->chart->fill_cells(two_rows());
    canvas->chart->show(true);
    canvas->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(canvas.get()));
  }
  static bool near(const QColor& a, const QColor& b) {
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) +
               std::abs(a.blue() - b.blue()) <
           30;
  }
  std::unique_ptr<CanvasOfMap> canvas;
};

TEST_F(MapChartTest, cells_have_the_colours_that_the_legend_gives_their_classes) {
  for (const double row : {0.5, 1.5})
    EXPECT_TRUE(near(canvas->at(30, row), colour_beside(name_of(MapClass::passive))));
  EXPECT_TRUE(near(canvas->at(300, 0.5), colour_beside(name_of(MapClass::unstable))));
  EXPECT_TRUE(near(canvas->at(300, 1.5), colour_beside(name_of(MapClass::chattering))));
  canvas->chart->show(false);
  EXPECT_FALSE(near(canvas->at(30, 0.5), colour_beside(name_of(MapClass::passive))));
}

TEST_F(MapChartTest, every_class_is_told_from_every_other) {
  std::vector<QColor> seen;
  for (const MapClass each : {MapClass::unstable, MapClass::saturated, MapClass::chattering,
                              MapClass::stable, MapClass::passive})
    seen.push_back(colour_beside(name_of(each)));
  for (std::size_t i = 0; i < seen.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(near(seen[i], seen[j])) << i << ", " << j;
}

TEST_F(MapChartTest, a_mark_lies_over_the_cells_and_goes_without_points) {
  const QColor cell = canvas->at(30, 1);
  canvas->chart->draw(MapMark::contact_stable, {{1, 1}, {3, 1}});
  EXPECT_TRUE(near(canvas->at(30, 1), colour::contact));
  canvas->chart->draw(MapMark::now_at, {{std::log10(30), 1}});
  EXPECT_TRUE(near(canvas->at(30, 1), Qt::white)) << "the point of the gains is above all";
  EXPECT_TRUE(near(canvas->at(60, 1), colour::contact));
  canvas->chart->draw(MapMark::now_at, {});
  canvas->chart->draw(MapMark::contact_stable, {});
  EXPECT_TRUE(near(canvas->at(30, 1), cell));
}

TEST_F(MapChartTest, a_line_is_broken_where_a_number_is_none) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  canvas->chart->draw(MapMark::contact_stable,
                      {{1, 0.5}, {1.5, 0.5}, {none, none}, {2.5, 0.5}, {3, 0.5}});
  EXPECT_TRUE(near(canvas->at(20, 0.5), colour::contact));
  EXPECT_FALSE(near(canvas->at(100, 0.5), colour::contact));
  EXPECT_TRUE(near(canvas->at(600, 0.5), colour::contact));
}

}  // namespace
}  // namespace sonde::ui::test
