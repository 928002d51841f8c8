// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/way_in_control.hpp"

#include <QLabel>
#include <QPushButton>

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
  way().seek(0.005);
  ASSERT_TRUE(test::wait_until([this] { return std::abs(height() - 0.115) < 1e-9; })) << height();
  EXPECT_TRUE(find<QLabel>("way_at")->text().contains("of room"));
  way().seek(0.025);
  ASSERT_TRUE(test::wait_until([this] { return std::abs(height() - 0.095) < 1e-9; })) << height();
  EXPECT_TRUE(find<QLabel>("way_at")->text().contains("deep"));
  ASSERT_TRUE(test::wait_until([this] {
    return std::abs(shown().separation.depth - 0.005) < 1e-4;
  })) << "the loop follows it there";
  way().seek(0);
  ASSERT_TRUE(test::wait_until([this] { return std::abs(height() - 0.12) < 1e-9; })) << height();
  way().play(true);
  ASSERT_TRUE(test::wait_until([this] { return height() < 0.11; }));
  way().play(false);
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
