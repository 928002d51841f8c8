// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/way_in_panel.hpp"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <cmath>
#include <numbers>

#include "tests/ui/window_fixture.hpp"
#include "ui/panels/number_field.hpp"

namespace sonde::ui::test {
namespace {

class WayInPanelTest : public testing::Test {
 protected:
  void SetUp() override {
    need_application();
    panel = std::make_unique<WayInPanel>();
    panel->take(0.06, true);
  }
  template <class T>
  T* find(const char* name) const {
    T* found = panel->findChild<T*>(name);
    EXPECT_TRUE(found) << name;
    return found;
  }
  QPushButton* button(const char* name) const { return find<QPushButton>(name); }
  void type(const char* field, const char* text) { find<NumberField>(field)->setText(text); }

  std::unique_ptr<WayInPanel> panel;
};

/// Twice the radius of 60 mm, and a fiftieth of it, rounded down to 1, 2 or 5.
TEST_F(WayInPanelTest, a_scene_begins_with_a_way_down_that_suits_its_size) {
  const WayWanted way = panel->wanted();
  EXPECT_FALSE(way.along_path);
  EXPECT_EQ(way.axis, -Vec3::UnitZ());
  EXPECT_DOUBLE_EQ(way.travel, 0.1);
  EXPECT_EQ(way.twist, 0);
  EXPECT_EQ(way.steps, 200);
  const MapWanted map = panel->map_wanted();
  EXPECT_DOUBLE_EQ(map.offset, 1e-3);
  EXPECT_DOUBLE_EQ(map.tilt, std::numbers::pi / 90);
  EXPECT_EQ(map.across, 21);
  EXPECT_FALSE(map.lateral.has_value());
  EXPECT_FALSE(button("way_play")->isEnabled() || button("way_first")->isEnabled());
}

TEST_F(WayInPanelTest, what_is_typed_is_in_millimetres_and_degrees_and_else_not_a_number) {
  type("way_travel", "12,5");
  type("way_twist", "-90");
  type("way_x", "1");
  type("map_offset", "0.5");
  type("map_tilt", "45");
  type("map_y", "2");
  type("map_x", "0");
  type("map_z", "0");
  EXPECT_DOUBLE_EQ(panel->wanted().travel, 0.0125);
  EXPECT_DOUBLE_EQ(panel->wanted().twist, -std::numbers::pi / 2);
  EXPECT_EQ(panel->wanted().axis, Vec3(1, 0, -1));
  EXPECT_DOUBLE_EQ(panel->map_wanted().offset, 5e-4);
  EXPECT_DOUBLE_EQ(panel->map_wanted().tilt, std::numbers::pi / 4);
  EXPECT_EQ(panel->map_wanted().lateral, std::optional(Vec3(0, 2, 0)));
  type("way_travel", "far");
  type("way_steps", "");
  EXPECT_TRUE(std::isnan(panel->wanted().travel));
  EXPECT_TRUE(std::isnan(panel->wanted().steps));
  button("way_flip")->click();
  EXPECT_EQ(panel->axis(), Vec3(-1, 0, 1));
}

TEST_F(WayInPanelTest, along_the_recorded_path_there_is_no_axis_to_choose) {
  auto* kind = find<QComboBox>("way_kind");
  EXPECT_TRUE(kind->isEnabled());
  kind->setCurrentIndex(1);
  EXPECT_TRUE(panel->wanted().along_path);
  for (const char* name : {"way_x", "way_travel", "way_twist", "way_face", "way_flip"})
    EXPECT_FALSE(find<QWidget>(name)->isEnabled()) << name;
  EXPECT_TRUE(find<QWidget>("way_steps")->isEnabled());
  panel->take(0.06, false);
  EXPECT_FALSE(kind->isEnabled()) << "there is none";
  EXPECT_FALSE(panel->wanted().along_path);
  EXPECT_TRUE(find<QWidget>("way_x")->isEnabled());
}

TEST_F(WayInPanelTest, one_button_at_a_time_waits_for_a_click_in_the_view) {
  std::vector<WayPick> picks;
  QObject::connect(panel.get(), &WayInPanel::pick_wanted, [&](WayPick what) {
    picks.push_back(what);
    panel->show_picking(what);
  });
  button("way_edge")->click();
  button("map_face")->click();
  EXPECT_FALSE(button("way_edge")->isChecked());
  EXPECT_TRUE(button("map_face")->isChecked());
  button("map_face")->click();
  EXPECT_FALSE(button("map_face")->isChecked());
  EXPECT_EQ(picks, (std::vector{WayPick::axis_edge, WayPick::side_face, WayPick::nothing}));
}

TEST_F(WayInPanelTest, a_result_can_be_played_and_its_first_contact_gone_to) {
  QStringList told;
  QObject::connect(panel.get(), &WayInPanel::play_wanted,
                   [&](bool on) { told << (on ? "play" : "hold"); });
  QObject::connect(panel.get(), &WayInPanel::first_wanted, [&] { told << "first"; });
  QObject::connect(panel.get(), &WayInPanel::compute_wanted, [&] { told << "compute"; });
  QObject::connect(panel.get(), &WayInPanel::map_asked, [&] { told << "map"; });
  TravelCurves curves{.travel = {0, 0.1}, .room = {0.01, -0.01}, .force = {0, 5}, .first = 0.05};
  panel->show_result("It binds at 50 mm.", curves);
  EXPECT_EQ(find<QLabel>("way_summary")->text(), "It binds at 50 mm.");
  for (const char* name : {"way_compute", "way_play", "way_first", "map_compute"})
    button(name)->click();
  EXPECT_EQ(told, QStringList({"compute", "play", "first", "map"}));
  panel->show_at(0.05, "at 50 mm: 0 N");
  EXPECT_EQ(find<QLabel>("way_at")->text(), "at 50 mm: 0 N");
  panel->show_playing(true);
  EXPECT_EQ(button("way_play")->text(), "❚❚ Hold");
  curves.first.reset();
  panel->show_result("It goes in.", curves);
  EXPECT_FALSE(button("way_first")->isEnabled()) << "it binds nowhere";
  EXPECT_TRUE(button("way_play")->isEnabled());
  panel->show_reason("The travel is no number.");
  EXPECT_FALSE(button("way_play")->isEnabled());
  EXPECT_EQ(find<QLabel>("way_at")->text(), "");
}

}  // namespace
}  // namespace sonde::ui::test
