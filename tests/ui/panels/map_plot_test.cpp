// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/map_plot.hpp"

#include <QLabel>
#include <QTest>
#include <cmath>
#include <limits>

#include "tests/ui/window_fixture.hpp"
#include "ui/base/theme.hpp"
#include "ui/panels/chart_legend.hpp"

namespace sonde::ui::test {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();
const QColor passive(0x2c, 0x7a, 0x58), stable(0x6f, 0x94, 0x40), unstable(0xa1, 0x40, 0x3b);

/// Passive up to 100, then stable up to the boundary; theory sees no end.
MapRow row_of(double from, double to, double boundary) {
  MapRow row;
  row.from = from;
  row.to = to;
  row.damping = (from + to) / 2;
  row.stretches = {{10, 100, MapClass::passive},
                   {100, boundary, MapClass::stable},
                   {boundary, 1e4, MapClass::unstable}};
  row.stable = boundary;
  row.theory_stable = row.theory_passive = never;
  return row;
}

/// Bands of damping of unequal heights.
StabilityMap over_damping() {
  StabilityMap map;
  map.axis = GainAxis::translation;
  map.over_damping = true;
  map.low = 10;
  map.high = 1e4;
  map.rows = {row_of(0, 1, 400), row_of(1, 4, 1000), row_of(4, 10, 2500)};
  return map;
}

/// Two rows of flat contacts, one of edges above.
StabilityMap over_situations() {
  StabilityMap map;
  map.low = 10;
  map.high = 1e4;
  for (const auto& [kind, label] :
       {std::pair("flat", "flat, light"), std::pair("flat", "flat, firm"),
        std::pair("edge", "edge, light")}) {
    const auto row = static_cast<double>(map.rows.size());
    map.rows.push_back(row_of(row, row + 1, 400 * (row + 1)));
    map.rows.back().kind = kind;
    map.rows.back().label = QString::fromUtf8(label);
  }
  return map;
}

int apart(const QColor& a, const QColor& b) {
  return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) +
         std::abs(a.blue() - b.blue());
}

class MapPlotTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* display = std::getenv("DISPLAY");
    ASSERT_TRUE(display && *display) << "these tests open windows: set DISPLAY (Xvfb will do)";
    need_application();
    plot = std::make_unique<MapPlot>(nullptr);
    QObject::connect(plot.get(), &MapPlot::asked,
                     [this](const MapPoint& point) { asked.push_back(point); });
    plot->resize(330, 310);
    plot->set_map(over_damping());
    plot->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(plot.get()));
  }
  void TearDown() override { darken(); }
  QColor colour_at(const QPointF& place) const {
    const QImage seen = plot->grab().toImage();
    return seen.pixelColor((place * seen.devicePixelRatio()).toPoint());
  }
  /// Pixels about of that colour within so many of Qt's of a place.
  int count(const QColor& colour, const QPointF& place, double within = 4) const {
    const QImage seen = plot->grab().toImage();
    const double ratio = seen.devicePixelRatio();
    const QRect box =
        QRectF(ratio * (place - QPointF(within, within)), ratio * (place + QPointF(within, within)))
            .toRect();
    int count = 0;
    for (int x = box.left(); x <= box.right(); ++x)
      for (int y = box.top(); y <= box.bottom(); ++y)
        count += seen.valid(x, y) && apart(seen.pixelColor(x, y), colour) < 30;
    return count;
  }
  /// The middle of a row of situations, at that stiffness.
  QPointF in_row(std::size_t row, double stiffness) const {
    const QPointF lowest = plot->place({stiffness, 0});
    return lowest - QPointF(0, 2 * static_cast<double>(row) * (plot->bottom() - lowest.y()));
  }
  std::unique_ptr<MapPlot> plot;
  std::vector<MapPoint> asked;
};

TEST_F(MapPlotTest, says_what_the_map_says_at_a_point) {
  EXPECT_EQ(plot->map_class({450, 2}), MapClass::stable);
  EXPECT_EQ(plot->map_class({450, 0}), MapClass::unstable);
  EXPECT_FALSE(plot->map_class({450, 11})) << "off the map";
  plot->set_map(over_situations());
  EXPECT_EQ(plot->map_class({390, 0}), MapClass::stable);
  EXPECT_EQ(plot->map_class({450, 0}), MapClass::unstable) << "the worst";
}

/// The reference is the picture.
TEST_F(MapPlotTest, each_class_is_seen_where_its_gains_are) {
  StabilityMap map = over_damping();
  for (MapRow& row : map.rows) row.stable = never;  // no line over the cells
  plot->set_map(map);
  for (const bool light : {false, true}) {
    if (light) QApplication::setPalette(QPalette(QColor(226, 230, 236), QColor(240, 242, 245)));
    QApplication::processEvents();
    ASSERT_EQ(is_light(plot->palette()), light);
    for (const MapRow& row : over_damping().rows)
      for (const double damping : {row.from + 0.3, row.to - 0.3}) {
        const auto at = [&](double k) { return colour_at(plot->place({k, damping})); };
        EXPECT_EQ(at(94), passive) << damping;
        EXPECT_EQ(at(106), stable) << damping;
        EXPECT_EQ(at(row.stable / 1.06), stable) << damping;
        EXPECT_EQ(at(row.stable * 1.06), unstable) << damping;
      }
  }
}

TEST_F(MapPlotTest, so_is_each_row_of_situations) {
  plot->set_map(over_situations());
  for (std::size_t row = 0; row < 3; ++row) {
    const double boundary = plot->map().rows[row].stable;
    EXPECT_EQ(colour_at(in_row(row, 95)), passive) << row;
    EXPECT_EQ(colour_at(in_row(row, boundary / 1.1)), stable) << row;
    EXPECT_EQ(colour_at(in_row(row, boundary * 1.1)), unstable) << row;
    EXPECT_GT(count(QColor(240, 244, 248), in_row(row, boundary)), 5) << row << ": the limit";
  }
}

TEST_F(MapPlotTest, limits_are_drawn_where_they_are_and_none_that_are_off_the_map) {
  const QColor line(240, 244, 248);
  const auto lines = [&](const MapRow& row, double k) {
    return count(line, plot->place({k, row.damping}));
  };
  StabilityMap map = over_damping();
  for (const MapRow& row : map.rows) {
    EXPECT_GT(lines(row, row.stable), 5) << row.damping;
    EXPECT_EQ(lines(row, 60), 0) << row.damping;
  }
  for (MapRow& row : map.rows) row.theory_passive = 60;
  plot->set_map(map);
  for (const MapRow& row : map.rows) EXPECT_GT(lines(row, 60), 1) << row.damping;
  for (MapRow& row : map.rows) row.stable = 1e5;
  plot->set_map(map);
  for (const MapRow& row : over_damping().rows) EXPECT_EQ(lines(row, row.stable), 0) << row.damping;
  EXPECT_EQ(count(line, plot->place({1e5, 5}), 6), 0) << "at the edge";
}

TEST_F(MapPlotTest, a_click_or_a_drag_asks_for_the_gains_there) {
  for (const MapPoint& point : {MapPoint{30, 0.5}, MapPoint{456, 3}, MapPoint{7890, 9}}) {
    const QPoint at = plot->place(point).toPoint();
    QTest::mouseClick(plot.get(), Qt::LeftButton, {}, at);
    ASSERT_FALSE(asked.empty());
    EXPECT_NEAR(std::log10(asked.back().stiffness / point.stiffness), 0, 0.01) << "half a pixel";
    EXPECT_NEAR(asked.back().damping, point.damping, 0.05);
  }
  asked.clear();
  const auto send = [&](QEvent::Type type, const QPointF& at, Qt::MouseButton button) {
    QMouseEvent event(type, at, button, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(plot.get(), &event);
  };
  send(QEvent::MouseButtonPress, plot->place({100, 5}), Qt::LeftButton);
  send(QEvent::MouseMove, QPointF(5000, -100), Qt::NoButton);
  ASSERT_EQ(asked.size(), 2u);
  EXPECT_EQ(asked.back(), (MapPoint{1e4, 10})) << "beyond: at the edge";
}

TEST_F(MapPlotTest, a_click_beside_the_map_or_of_another_button_asks_for_nothing) {
  for (const QPoint& beside :
       {QPoint(4, 100), QPoint(160, 3), QPoint(plot->width() - 3, 100), QPoint(160, 300)}) {
    QTest::mouseClick(plot.get(), Qt::LeftButton, {}, beside);
    QTest::mouseMove(plot.get(), beside);
  }
  QTest::mouseClick(plot.get(), Qt::RightButton, {}, plot->place({100, 5}).toPoint());
  plot->set_map({});
  QTest::mouseClick(plot.get(), Qt::LeftButton, {}, QPoint(160, 100));
  EXPECT_TRUE(asked.empty());
}

TEST_F(MapPlotTest, the_gains_are_seen_where_they_are_and_at_the_edge_when_off_the_map) {
  const MapPoint here{250, 5}, there{40, 7.3};
  EXPECT_EQ(colour_at(plot->place(here)), stable);
  plot->set_now(here);
  plot->set_recommended(there);
  EXPECT_EQ(colour_at(plot->place(here)), QColor(Qt::white));
  EXPECT_EQ(colour_at(plot->place(there)), colour::ghost);
  EXPECT_EQ(count(Qt::white, plot->place({250, 9})), 0) << "no line: dampings differ";
  plot->set_now(MapPoint{1e9, 5});
  EXPECT_EQ(plot->place({1e9, 5}), plot->place({1e4, 5}));
  EXPECT_EQ(colour_at(plot->place(here)), stable);
  EXPECT_GT(count(Qt::white, plot->place({1e9, 5}), 6), 10);
  plot->set_now({});
  plot->set_recommended({});
  EXPECT_EQ(colour_at(plot->place(there)), passive);
  EXPECT_EQ(count(Qt::white, plot->place({1e9, 5}), 6), 0);
}

TEST_F(MapPlotTest, over_situations_the_gains_are_lines_across_all_rows) {
  plot->set_map(over_situations());
  plot->set_now(MapPoint{250, 0});
  plot->set_recommended(MapPoint{40, 0});
  for (std::size_t row = 0; row < 3; ++row) {
    EXPECT_GT(count(Qt::white, in_row(row, 250)), 5) << row;
    EXPECT_GT(count(colour::ghost, in_row(row, 40)), 5) << row;
  }
  EXPECT_EQ(colour_at(plot->place({250, 0})), QColor(Qt::white)) << "the lowest row";
}

TEST_F(MapPlotTest, the_present_contact_has_its_own_boundary_and_a_frame_about_its_rows) {
  StabilityMap own = over_damping();
  for (MapRow& row : own.rows) row.stable = 200;
  EXPECT_EQ(count(colour::contact, plot->place({200, 5})), 0);
  plot->set_contact("edge", own);
  EXPECT_GT(count(colour::contact, plot->place({200, 5})), 10);
  plot->set_map(over_situations());
  for (std::size_t row = 0; row < 3; ++row) {
    const double boundary = plot->map().rows[row].stable;
    EXPECT_EQ(count(colour::contact, in_row(row, boundary)) > 10, row == 2) << row;
    EXPECT_EQ(count(colour::contact, in_row(row, 1e4)) > 5, row == 2) << row << ": the frame";
    const QPointF name(8, in_row(row, 10).y());
    EXPECT_EQ(count(colour::contact, name) > 10, row == 2) << row;
  }
  plot->set_contact("edge", {});
  EXPECT_EQ(plot->contact(), "") << "which was not studied";
  EXPECT_EQ(count(colour::contact, in_row(2, 1200)), 0);
}

TEST_F(MapPlotTest, the_legend_has_the_colours_of_the_map_and_stays_within) {
  const auto* legend = plot->findChild<ChartLegend*>();
  for (const QColor& colour :
       {passive, stable, unstable, QColor(colour::contact), QColor(colour::ghost)})
    EXPECT_TRUE(legend->text().contains(colour.name())) << colour.name().toStdString();
  for (const int width : {270, 330, 600}) {
    plot->resize(width, 310);
    EXPECT_TRUE(plot->rect().contains(legend->geometry())) << width;
    EXPECT_GT(legend->y(), plot->bottom() + 30) << width << ": below the axis";
    EXPECT_GE(legend->height(), legend->heightForWidth(legend->width())) << width;
  }
}

TEST_F(MapPlotTest, a_map_set_while_it_is_hidden_is_drawn_when_it_is_seen) {
  const QImage before = plot->picture();
  plot->hide();
  plot->set_map(over_situations());
  plot->show();
  QApplication::processEvents();
  EXPECT_GT(pixels_between(before, plot->picture()), 400);
  EXPECT_EQ(colour_at(in_row(0, 95)), passive);
}

}  // namespace
}  // namespace sonde::ui::test
