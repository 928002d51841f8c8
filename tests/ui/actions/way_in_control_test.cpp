// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/way_in_control.hpp"

#include <QLabel>
#include <QPushButton>
#include <QTest>

#include "tests/ui/window_fixture.hpp"
#include "ui/actions/seeing_control.hpp"
#include "ui/panels/way_in_panel.hpp"

namespace sonde::ui {
namespace {

/// Two cubes of 0.1 m, 0.02 m apart in z: the probe comes down on the other by that much.
class WayInTest : public test::WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    const auto above = folder.write("above.sonde.json", R"({"unit": "m",
        "probe": {"mesh": "cube.off", "pose": [0.01, 0, 0.12, 1, 0, 0, 0]},
        "fixed": {"mesh": "cube.off"}, "coupling": {"mode": "object", "k": 500}})");
    open({QString::fromStdString(above.string())});
    ASSERT_EQ(failed, 0);
    window->way_in().panel().show();
  }
  WayInControl& way() { return window->way_in(); }
  double height() const { return window->session()->device_pose().p.z(); }
  QString summary() const { return find<QLabel>("way_summary")->text(); }
  void compute(const char* z, const char* travel_mm) {
    type("way_z", z);
    type("way_travel", travel_mm);
    find<QPushButton>("way_compute")->click();
    ASSERT_TRUE(test::wait_until([this] { return !summary().isEmpty(); }));
  }
};

// Reference: by hand. It touches after 20 mm, and is held back by the rest of the way.
TEST_F(WayInTest, it_says_where_it_binds_and_goes_there) {
  compute("-1", "30");
  ASSERT_TRUE(way().found());
  ASSERT_TRUE(way().found()->first) << summary().toStdString();
  EXPECT_NEAR(way().found()->first->travel, 0.02, 1e-8);
  EXPECT_TRUE(summary().contains("It binds at 20.00")) << summary().toStdString();
  EXPECT_NEAR(way().found()->steps.back().held.depth, 0.01, 1e-5);
  find<QPushButton>("way_first")->click();
  ASSERT_TRUE(test::wait_until([this] { return std::abs(height() - 0.1) < 1e-7; })) << height();
  act("undo");
  EXPECT_NEAR(window->session()->device_pose().p.z(), 0.12, 1e-9);
}

TEST_F(WayInTest, it_is_sought_and_played_by_the_probe) {
  compute("-1", "30");
  way().seek(0.006);  // these are computed steps
  ASSERT_TRUE(test::wait_until([this] { return std::abs(height() - 0.114) < 1e-9; })) << height();
  EXPECT_TRUE(find<QLabel>("way_at")->text().contains("of room"));
  way().seek(0.024);
  ASSERT_TRUE(test::wait_until([this] { return std::abs(height() - 0.096) < 1e-9; })) << height();
  EXPECT_TRUE(find<QLabel>("way_at")->text().contains("deep"));
  ASSERT_TRUE(test::wait_until([this] {
    return std::abs(shown().separation.depth - 0.004) < 1e-4;
  })) << "the loop follows it there";
  way().seek(0);
  ASSERT_TRUE(test::wait_until([this] { return std::abs(height() - 0.12) < 1e-9; })) << height();
  way().play(true);
  ASSERT_TRUE(test::wait_until([this] { return height() < 0.11; }));
  way().play(false);
}

/// The numbers of the dock are of places that were computed: the probe goes to the nearest of them,
/// so that the Readout says the same of it.
TEST_F(WayInTest, what_is_said_of_a_place_is_what_holds_the_probe_there) {
  type("way_steps", "20");
  compute("-1", "30");
  way().seek(0.0272);  // between two steps
  ASSERT_TRUE(test::wait_until([this] { return find<QLabel>("way_at")->text().contains("deep"); }));
  ASSERT_TRUE(test::wait_until([this] { return std::abs(height() - 0.12 + 0.027) < 1e-9; }))
      << height();
  EXPECT_TRUE(find<QLabel>("way_at")->text().startsWith("Step at 27.0"))
      << find<QLabel>("way_at")->text().toStdString();
  EXPECT_TRUE(find<QLabel>("way_at")->text().contains("7.0"));
  EXPECT_TRUE(test::wait_until([this] {
    return std::abs(shown().separation.depth - 0.007) < 1e-5;
  })) << shown().separation.depth;
}

TEST_F(WayInTest, an_axis_comes_from_a_face_or_an_edge_that_is_clicked) {
  window->seeing().look_from(Vec3::UnitZ(), Vec3::UnitY());
  window->viewport().set_parallel(true);
  const QPointF on_top = window->viewport().on_screen({0.04, 0.03, 0.22});
  find<QPushButton>("way_face")->click();
  drag(Qt::LeftButton, on_top, {0, 0});
  EXPECT_LT((way().panel().wanted().axis + Vec3::UnitZ()).norm(), 1e-6) << "into the face";
  find<QPushButton>("way_flip")->click();
  EXPECT_LT((way().panel().wanted().axis - Vec3::UnitZ()).norm(), 1e-6);
  find<QPushButton>("way_edge")->click();
  const QPointF beside_edge = window->viewport().on_screen({0.06, 0.001, 0.22});
  drag(Qt::LeftButton, beside_edge, {0, 0});
  EXPECT_NEAR(std::abs(way().panel().wanted().axis.x()), 1, 1e-6) << "not along the diagonal";
  EXPECT_FALSE(find<QPushButton>("way_edge")->isChecked());
}

// Reference: by hand. The lateral direction is x; two cubes of 0.1 m, the probe 10 mm aside and
// 20 mm above: it goes 20 mm wherever it is over the other, and past it where it is 0.1 m aside.
TEST_F(WayInTest, the_map_says_what_goes_in_and_a_click_takes_the_probe_there) {
  type("way_travel", "30");
  type("map_offset", "100");
  type("map_tilt", "0");
  type("map_across", "5");
  find<QPushButton>("map_compute")->click();
  ASSERT_TRUE(test::wait_until([this] { return !way().map().free.empty(); }))
      << find<QLabel>("map_words")->text().toStdString();
  const OffsetMap& map = way().map();
  ASSERT_EQ(map.free.size(), 25u);
  EXPECT_LT((map.at.lateral - Vec3::UnitX()).norm(), 1e-12);
  for (std::size_t i = 0; i < 5; ++i)
    // At +100 mm the probe is 110 mm aside; at −100 mm 90 mm, over the other by 10 mm.
    EXPECT_NEAR(map.free[i * 5 + 2], i == 4 ? 0.03 : 0.02, 1e-7) << i;
  EXPECT_TRUE(find<QLabel>("map_words")->text().contains("5 of 25 go in"))
      << find<QLabel>("map_words")->text().toStdString();
  auto* plot = find<OffsetPlot>("offset_plot");
  window->way_in().panel().widget()->repaint();
  const QPointF at = plot->place_of({3, 2});
  QTest::mouseClick(plot, Qt::LeftButton, {}, at.toPoint());
  EXPECT_NEAR(window->session()->device_pose().p.x(), 0.06, 1e-12);
  EXPECT_NEAR(height(), 0.12, 1e-12);
  EXPECT_TRUE(find<QLabel>("map_words")->text().contains("Offset 50"))
      << find<QLabel>("map_words")->text().toStdString();
  EXPECT_TRUE(find<QLabel>("map_words")->text().contains("binds at 20.0"));
  const QImage seen = plot->grab().toImage();
  const auto colour_at = [&](const MapPlace& place) {
    return seen.pixelColor((plot->place_of(place) * seen.devicePixelRatio()).toPoint());
  };
  EXPECT_EQ(colour_at({4, 0}), QColor(0x1b, 0x78, 0x37));
  EXPECT_EQ(colour_at({0, 4}), QColor(0xfd, 0xae, 0x61));
  act("undo");
  EXPECT_NEAR(window->session()->device_pose().p.x(), 0.01, 1e-12);
  EXPECT_EQ(way().map().free.size(), 25u) << "it is about the bodies, wherever the probe is";
}

// Reference: by hand. The probe is 10 mm aside in x, and not in y: beside the other are the ends
// of offsets along y alike, and along x only one.
TEST_F(WayInTest, the_map_is_along_the_direction_that_is_wanted) {
  type("way_travel", "30");
  type("map_offset", "105");
  type("map_tilt", "0");
  type("map_across", "3");
  const auto ends = [this](const char* x, const char* y, const char* z) {
    type("map_x", x);
    type("map_y", y);
    type("map_z", z);
    find<QPushButton>("map_compute")->click();
    EXPECT_TRUE(test::wait_until([this] { return !way().map().free.empty(); }));
    const auto& free = way().map().free;
    return free.size() == 9 ? std::pair(free[1], free[7]) : std::pair(0.0, 0.0);
  };
  const auto along_y = ends("0", "2", "5");
  EXPECT_NEAR(along_y.first, 0.03, 1e-9);
  EXPECT_NEAR(along_y.second, 0.03, 1e-9);
  EXPECT_LT((way().map().at.lateral - Vec3::UnitY()).norm(), 1e-12);
  const auto along_x = ends("1", "0", "0");
  EXPECT_NEAR(along_x.first, 0.02, 1e-7);
  EXPECT_NEAR(along_x.second, 0.03, 1e-9);
  window->seeing().look_from(Vec3::UnitZ(), Vec3::UnitY());
  window->viewport().set_parallel(true);
  find<QPushButton>("map_edge")->click();
  drag(Qt::LeftButton, window->viewport().on_screen({0.06, 0.045, 0.22}), {0, 0});
  EXPECT_NEAR(std::abs(way().panel().map_wanted().lateral->x()), 1, 1e-6);
  EXPECT_FALSE(find<QPushButton>("map_edge")->isChecked());
  for (const char* number : {"0", "x"}) {
    type("map_x", "0");
    type("map_y", number);
    type("map_z", "1");
    find<QPushButton>("map_compute")->click();
    EXPECT_TRUE(test::wait_until([this] {
      return find<QLabel>("map_words")->text().contains("do not lie along it");
    })) << number;
  }
}

TEST_F(WayInTest, more_than_there_may_be_are_refused_with_the_most) {
  for (const char* number : {"502", "0", "2.5", "many", "inf"}) {
    type("map_across", number);
    find<QPushButton>("map_compute")->click();
    EXPECT_TRUE(test::wait_until([this] {
      return find<QLabel>("map_words")->text() == "“of each” takes a whole number from 1 to 501";
    })) << number
        << find<QLabel>("map_words")->text().toStdString();
    type("way_steps", number == std::string("502") ? "100001" : number);
    find<QPushButton>("way_compute")->click();
    EXPECT_TRUE(test::wait_until([this] {
      return summary() == "“steps” takes a whole number from 1 to 100000";
    })) << number
        << summary().toStdString();
  }
}

TEST_F(WayInTest, a_map_is_stopped_and_one_without_sense_is_refused) {
  type("map_across", "501");
  find<QPushButton>("map_compute")->click();
  ASSERT_TRUE(
      test::wait_until([this] { return find<QPushButton>("map_compute_stop")->isVisible(); }));
  find<QPushButton>("map_compute_stop")->click();
  ASSERT_TRUE(test::wait_until(
      [this] { return find<QLabel>("map_words")->text() == QStringLiteral("Stopped."); }));
  for (const char* range : {"-1", "none"}) {
    type("map_offset", range);
    find<QPushButton>("map_compute")->click();
    ASSERT_TRUE(test::wait_until([this] {
      return find<QLabel>("map_words")->text().contains("must be finite");
    })) << range
        << find<QLabel>("map_words")->text().toStdString();
  }
  type("map_offset", "1");
  type("way_z", "0");
  find<QPushButton>("map_compute")->click();
  EXPECT_TRUE(test::wait_until(
      [this] { return find<QLabel>("map_words")->text().contains("axis has no length"); }));
  EXPECT_TRUE(way().map().free.empty());
  EXPECT_TRUE(complaints.empty());
}

TEST_F(WayInTest, what_is_no_way_is_refused_in_words) {
  compute("0", "30");
  EXPECT_FALSE(way().found());
  EXPECT_TRUE(summary().contains("axis")) << summary().toStdString();
  compute("-1", "0");
  EXPECT_TRUE(summary().contains("travel")) << summary().toStdString();
  compute("-1", "none");
  EXPECT_TRUE(summary().contains("finite")) << summary().toStdString();
  open_cubes();
  compute("-1", "30");
  EXPECT_TRUE(summary().contains("overlap")) << summary().toStdString();
  EXPECT_TRUE(complaints.empty());
}

}  // namespace
}  // namespace sonde::ui
