// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/offset_plot.hpp"

#include <QLabel>
#include <QTest>

#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

const QColor goes_in(0x1b, 0x78, 0x37), binds(0xfd, 0xae, 0x61), overlaps(0xba, 0xba, 0xba);

/// A map of which one point alone goes in; all before it bind, and all after it overlap.
OffsetMap map_with(std::size_t offsets, std::size_t tilts, const MapPlace& in) {
  OffsetMap map;
  map.at.largest_offset = 5e-4;
  map.at.largest_tilt = 0.03;
  map.at.offsets = offsets;
  map.at.tilts = tilts;
  map.free.assign(offsets * tilts, 0.01);
  map.wanted = 0.02;
  const std::size_t at = in.offset * tilts + in.tilt;
  std::fill(map.free.begin() + std::ptrdiff_t(at), map.free.end(), -1);
  map.free[at] = map.wanted;
  return map;
}

class OffsetPlotTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* display = std::getenv("DISPLAY");
    ASSERT_TRUE(display && *display) << "these tests open windows: set DISPLAY (Xvfb will do)";
    need_application();
    plot = std::make_unique<OffsetPlot>(nullptr);
    QObject::connect(plot.get(), &OffsetPlot::asked,
                     [this](const MapPlace& place) { asked.push_back(place); });
    plot->resize(320, 250);
    plot->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(plot.get()));
  }
  void TearDown() override { darken(); }
  QColor colour_at(const MapPlace& place) const {
    const QImage seen = plot->grab().toImage();
    return seen.pixelColor((plot->place_of(place) * seen.devicePixelRatio()).toPoint());
  }
  std::unique_ptr<OffsetPlot> plot;
  std::vector<MapPlace> asked;
};

TEST_F(OffsetPlotTest, each_point_is_seen_where_a_click_asks_for_it) {
  constexpr std::size_t offsets = 4, tilts = 3;
  for (std::size_t i = 0; i < offsets; ++i)
    for (std::size_t j = 0; j < tilts; ++j) {
      plot->set_map(map_with(offsets, tilts, {i, j}), LengthUnit());
      EXPECT_EQ(colour_at({i, j}), goes_in) << i << ' ' << j;
      QTest::mouseClick(plot.get(), Qt::LeftButton, {}, plot->place_of({i, j}).toPoint());
      ASSERT_EQ(asked.size(), i * tilts + j + 1);
      EXPECT_EQ(asked.back().offset, i);
      EXPECT_EQ(asked.back().tilt, j);
      if (j > 0) {
        EXPECT_EQ(colour_at({i, j - 1}), binds);
      }
      if (i + 1 < offsets) {
        EXPECT_EQ(colour_at({i + 1, j}), overlaps);
      }
    }
}

TEST_F(OffsetPlotTest, a_click_beside_the_points_asks_for_none) {
  plot->set_map(map_with(3, 3, {1, 1}), LengthUnit());
  for (const QPoint& beside :
       {QPoint(4, 100), QPoint(160, 3), QPoint(plot->width() - 3, 100), QPoint(160, 245)})
    QTest::mouseClick(plot.get(), Qt::LeftButton, {}, beside);
  EXPECT_TRUE(asked.empty());
}

TEST_F(OffsetPlotTest, the_colours_of_the_points_are_those_of_the_legend_in_either_theme) {
  plot->set_map(map_with(3, 3, {1, 1}), LengthUnit());
  for (const bool light : {false, true}) {
    if (light) QApplication::setPalette(QPalette(QColor(226, 230, 236), QColor(240, 242, 245)));
    QApplication::processEvents();
    EXPECT_EQ(colour_at({1, 1}), goes_in) << light;
    EXPECT_EQ(colour_at({0, 0}), binds) << light;
    EXPECT_EQ(colour_at({2, 2}), overlaps) << light;
    const QString legend = plot->findChild<QLabel*>()->text();
    for (const QColor& colour : {goes_in, binds, overlaps})
      EXPECT_TRUE(legend.contains(colour.name())) << colour.name().toStdString();
  }
}

TEST_F(OffsetPlotTest, maps_of_one_point_and_of_none_are_drawn_too) {
  plot->set_map(map_with(1, 1, {0, 0}), LengthUnit());
  plot->choose(MapPlace{0, 0});
  EXPECT_EQ(colour_at({0, 0}), goes_in);
  plot->set_map({}, LengthUnit());
  QTest::mouseClick(plot.get(), Qt::LeftButton, {}, QPoint(160, 100));
  EXPECT_TRUE(asked.empty());
}

}  // namespace
}  // namespace sonde::ui::test
