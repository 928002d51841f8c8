// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QRadioButton>
#include <QSlider>
#include <QTest>

#include "engine/settings/settings.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/devices/device_control.hpp"
#include "ui/panels/readout_panel.hpp"
#include "ui/panels/typed_value.hpp"

namespace sonde::ui::test {
namespace {

class PanelTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (HasFatalFailure()) return;
    open_cubes();
  }
  double force() const { return shown().wrench.force.norm(); }
};

TEST_F(PanelTest, every_gain_has_a_slider_and_a_typed_value) {
  for (const Setting& setting : coupling_settings()) {
    EXPECT_TRUE(find<QSlider>((std::string(setting.key) + "_slider").c_str()));
    EXPECT_TRUE(find<TypedValue>((std::string(setting.key) + "_value").c_str()));
  }
}

TEST_F(PanelTest, a_slider_acts_on_the_force) {
  // The force comes in from zero.
  ASSERT_TRUE(wait_until([this] { return shown().hand.share >= 1; }));
  const double before = force(), k_before = window->session()->coupling().k;
  auto* slider = find<QSlider>("k_slider");
  slider->setValue(slider->value() - 80);
  const double ratio = window->session()->coupling().k / k_before;
  EXPECT_LT(ratio, 0.6);
  EXPECT_NEAR(find<TypedValue>("k_value")->value(), window->session()->coupling().k, 1e-6);
  EXPECT_TRUE(wait_until([&] {
    return std::abs(force() - ratio * before) < 0.02 * ratio * before;
  })) << force()
      << " N, not " << ratio * before;
}

TEST_F(PanelTest, a_typed_value_acts_and_can_be_undone) {
  auto* typed = find<TypedValue>("k_value");
  typed->setFocus();
  typed->selectAll();
  QTest::keyClicks(typed, "250,5");  // a decimal comma is as good as a point
  EXPECT_EQ(window->session()->coupling().k, 500) << "half a number is no gain";
  QTest::keyClick(typed, Qt::Key_Return);
  EXPECT_DOUBLE_EQ(window->session()->coupling().k, 250.5);
  act("undo");
  EXPECT_EQ(window->session()->coupling().k, 500);
  EXPECT_EQ(typed->value(), 500);
  act("redo");
  EXPECT_DOUBLE_EQ(window->session()->coupling().k, 250.5);
}

TEST_F(PanelTest, escape_takes_the_force_away_wherever_it_is_pressed) {
  auto* toggle = find<QAction>("force");
  for (QWidget* where :
       {static_cast<QWidget*>(find<TypedValue>("k_value")),
        static_cast<QWidget*>(find<QComboBox>("holder")), window->viewport().canvas()}) {
    ASSERT_TRUE(wait_until([this] { return force() > 0; }));
    QTest::keyClick(where, Qt::Key_Escape);
    EXPECT_FALSE(toggle->isChecked());
    EXPECT_TRUE(wait_until([this] { return force() == 0; }));
    auto* status = find<QLabel>("what_happens");
    EXPECT_TRUE(wait_until([&] { return status->text().contains("stopped"); }));
    toggle->trigger();
  }
  EXPECT_TRUE(wait_until([this] { return force() > 0; }));
}

TEST_F(PanelTest, escape_while_a_scene_comes_with_a_complaint_is_seen) {
  folder.write("path.csv", "t,px,py,pz,qw,qx,qy,qz\n0,0.3,0,0,1,0,0,0\n");
  folder.write("path.sonde.json", R"({"probe": {"mesh": "cube.off"}, "fixed": {"mesh": "cube.off"},
      "trajectory": "path.csv"})");
  open({path("path.sonde.json")});
  window->devices().choose(PathSource{});
  window->prompts().report_error = [this](const QString& text) {
    complaints.push_back(text);
    QTest::keyClick(window->viewport().canvas(), Qt::Key_Escape);
  };
  open_cubes();
  ASSERT_EQ(complaints.size(), 1u) << "it has no path";
  EXPECT_FALSE(window->session()->force_on());
  EXPECT_FALSE(find<QAction>("force")->isChecked());
}

TEST_F(PanelTest, the_mode_shows_its_own_gains) {
  EXPECT_TRUE(find<QWidget>("k_row")->isVisible());
  EXPECT_FALSE(find<QWidget>("b_t_row")->isVisible());
  find<QRadioButton>("mode_classic")->click();
  EXPECT_EQ(window->session()->coupling().mode, Coupling::Mode::classic);
  EXPECT_FALSE(find<QWidget>("k_row")->isVisible());
  EXPECT_TRUE(find<QWidget>("b_t_row")->isVisible());
}

TEST_F(PanelTest, every_number_is_there_with_its_unit) {
  const auto text = [this](const char* name) { return find<QLabel>(name)->text(); };
  ASSERT_TRUE(wait_until([&] { return text("depth_value").contains("mm</span> deep"); }))
      << text("depth_value").toStdString();
  ASSERT_TRUE(wait_until([&] { return text("pdt_value").contains("mm"); }))
      << text("pdt_value").toStdString();
  EXPECT_TRUE(text("bound_value").contains("mm"));
  EXPECT_TRUE(text("nearest_value").contains("mm"));
  EXPECT_TRUE(text("translation_value").contains("mm"));
  EXPECT_TRUE(text("screw_value").contains("slide"));
  EXPECT_TRUE(text("rotation_value").contains('%'));
  EXPECT_TRUE(text("force_value").contains(" N"));
  EXPECT_TRUE(text("torque_value").contains("N·m"));
  for (const char* parts : {"force_parts_value", "torque_parts_value"})
    EXPECT_EQ(text(parts).count(", "), 2) << text(parts).toStdString();
  EXPECT_TRUE(text("tick_value").contains("µs"));
  EXPECT_TRUE(text("rate_value").contains("Hz"));
  EXPECT_FALSE(text("depth_value").contains(','));
  EXPECT_TRUE(text("what_happens").contains("closed"));
  EXPECT_TRUE(text("rates").contains("Hz"));
}

TEST_F(PanelTest, a_probe_that_is_free_beyond_a_wall_is_not_shown_as_a_depth_of_nothing) {
  ASSERT_TRUE(wait_until([this] { return find<QLabel>("pdt_value")->text().contains("mm"); }));
  window->set_paused(true);
  ASSERT_TRUE(wait_until([this] { return shown().paused; }));
  Snapshot snapshot = shown();
  snapshot.separation.depth = 0.0118;
  snapshot.separation.status = Status::penetrating;
  const Pose hand = snapshot.separation.device;
  BackgroundResult free{.device = hand,
                        .nearest = FoundWay{.depth = 0, .separated = hand},
                        .pdt = FoundWay{.depth = 0, .separated = hand},
                        .lower_bound = 0.0};
  auto* readout = find<ReadoutPanel>("readout_panel");
  readout->show_numbers({snapshot, free});
  EXPECT_EQ(find<QLabel>("nearest_value")->text(), "free at the hand");
  EXPECT_EQ(find<QLabel>("pdt_value")->text(), "free at the hand");
  EXPECT_EQ(find<QLabel>("bound_value")->text(), "–");
  EXPECT_EQ(find<QLabel>("why_value")->text(), words(WayOut::free_blocked));
  EXPECT_TRUE(find<QLabel>("depth_value")->text().contains("11.800 mm"))
      << find<QLabel>("depth_value")->text().toStdString();
  free.device.p.x() += 1e-3;  // of a pose before: no judgement
  readout->show_numbers({snapshot, free});
  EXPECT_TRUE(find<QLabel>("pdt_value")->text().contains("mm"));
}

/// As in the picture, where the arrow tells which way along the axis.
TEST_F(PanelTest, a_slide_against_the_turn_is_a_length_like_any_other) {
  window->set_paused(true);
  wait(100);
  Snapshot held = shown();
  Separation& separation = held.separation;
  separation.status = Status::penetrating;
  separation.device = Pose{};
  const Vec3 com = window->session()->probe().mass.com;
  const Quat turn(Eigen::AngleAxisd(0.2, Vec3::UnitZ()));
  separation.separated = {turn, com - turn * com + Vec3(0, 0, -0.003)};
  find<ReadoutPanel>("readout_panel")->show_numbers({held, {}});
  const QString text = find<QLabel>("screw_value")->text();
  EXPECT_TRUE(text.endsWith("slide 3.000 mm")) << text.toStdString();
}

TEST_F(PanelTest, slow_numbers_are_computed_only_while_shown) {
  ASSERT_TRUE(wait_until([this] { return window->searched().has_value(); }));
  find<QDockWidget>("readout_panel")->hide();
  wait(300);
  const Pose last = window->searched()->device;
  Pose moved = window->session()->device_pose();
  moved.p.y() += 0.001;
  window->set_device_pose(moved);
  wait(300);
  EXPECT_EQ(window->searched()->device.p, last.p);
  find<QDockWidget>("readout_panel")->show();
  EXPECT_TRUE(wait_until([&] { return window->searched()->device.p == moved.p; }));
}

}  // namespace
}  // namespace sonde::ui::test
