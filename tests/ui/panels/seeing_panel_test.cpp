// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/seeing_panel.hpp"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QListWidget>
#include <QPushButton>
#include <QSlider>
#include <QTest>

#include "tests/ui/window_fixture.hpp"
#include "ui/panels/number_field.hpp"

namespace sonde::ui::test {
namespace {

/// Of bodies within 0.2 m of (1, 2, 3) m.
class SeeingPanelTest : public testing::Test {
 protected:
  void SetUp() override {
    need_application();
    panel = std::make_unique<SeeingPanel>();
    panel->set_extent(centre, 0.2);
    QObject::connect(panel.get(), &SeeingPanel::changed,
                     [this](const Seeing& seeing) { told.push_back(seeing); });
  }
  template <class T>
  T* find(const char* name) const {
    T* found = panel->findChild<T*>(name);
    EXPECT_TRUE(found) << name;
    return found;
  }
  void click(const char* button) { find<QPushButton>(button)->click(); }

  const Vec3 centre{1, 2, 3};
  std::unique_ptr<SeeingPanel> panel;
  std::vector<Seeing> told;
};

TEST_F(SeeingPanelTest, what_is_shown_is_not_told_and_what_is_chosen_is) {
  Seeing seeing;
  seeing.fixed = Look::xray;
  seeing.cut.on = seeing.cut.probe = true;
  seeing.cut.fixed = false;
  seeing.cut.point = centre + Vec3(0.1, 7, 0);  // half-way to the end, along x
  panel->show_seeing(seeing);
  EXPECT_EQ(find<QComboBox>("fixed_look")->currentText(), "x-ray");
  EXPECT_TRUE(find<QCheckBox>("cut_on")->isChecked() && find<QCheckBox>("cut_probe")->isChecked());
  EXPECT_FALSE(find<QCheckBox>("cut_fixed")->isChecked());
  EXPECT_EQ(find<QSlider>("cut_place")->value(), find<QSlider>("cut_place")->maximum() / 2);
  EXPECT_TRUE(told.empty());
  find<QComboBox>("probe_look")->setCurrentIndex(3);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].probe, Look::hidden);
  EXPECT_EQ(told[0].fixed, Look::xray);
  EXPECT_TRUE(told[0].cut.on);
}

TEST_F(SeeingPanelTest, the_slider_moves_the_cut_along_its_normal_alone) {
  Seeing seeing;
  seeing.cut.normal = Vec3::UnitY();
  seeing.cut.point = Vec3(5, 2, -1);
  panel->show_seeing(seeing);
  auto* place = find<QSlider>("cut_place");
  place->setValue(-place->maximum());
  EXPECT_NEAR((told.back().cut.point - Vec3(5, 1.8, -1)).norm(), 0, 1e-12);
  place->setValue(place->maximum() / 4);
  EXPECT_NEAR((told.back().cut.point - Vec3(5, 2.05, -1)).norm(), 0, 1e-12);
}

TEST_F(SeeingPanelTest, a_cut_goes_across_an_axis_through_the_middle_and_can_be_flipped) {
  click("cut_z");
  ASSERT_FALSE(told.empty());
  EXPECT_TRUE(told.back().cut.on);
  EXPECT_EQ(told.back().cut.normal, Vec3::UnitZ());
  EXPECT_EQ(told.back().cut.point, centre);
  click("cut_flip");
  EXPECT_EQ(told.back().cut.normal, -Vec3::UnitZ());
  EXPECT_EQ(told.back().cut.point, centre);
  int snapped = 0, faced = 0;
  QObject::connect(panel.get(), &SeeingPanel::snap_wanted, [&] { ++snapped; });
  QObject::connect(panel.get(), &SeeingPanel::face_wanted, [&] { ++faced; });
  click("cut_snap");
  EXPECT_EQ(std::pair(snapped, faced), std::pair(1, 0));
  click("cut_face");
  EXPECT_EQ(std::pair(snapped, faced), std::pair(1, 1));
}

TEST_F(SeeingPanelTest, the_reach_of_the_gap_is_in_the_unit_of_the_scene_and_above_zero) {
  std::vector<std::optional<double>> reaches;
  QObject::connect(panel.get(), &SeeingPanel::gap_reach_changed,
                   [&](std::optional<double> reach) { reaches.push_back(reach); });
  auto* field = find<NumberField>("gap_reach");
  const auto type = [&](const char* text) {
    field->selectAll();
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
  };
  type("1,5");
  ASSERT_EQ(reaches.size(), 1u);
  ASSERT_TRUE(reaches[0]);
  EXPECT_DOUBLE_EQ(*reaches[0], 1.5e-3);
  for (const char* none : {"-2", "0", "1e"}) {
    type(none);
    EXPECT_FALSE(reaches.back().has_value()) << none;
    EXPECT_EQ(field->text(), "") << none;
  }
}

TEST_F(SeeingPanelTest, saved_views_are_gone_to_and_forgotten) {
  std::vector<int> wanted, forgotten;
  int saved = 0;
  QObject::connect(panel.get(), &SeeingPanel::view_wanted,
                   [&](int view) { wanted.push_back(view); });
  QObject::connect(panel.get(), &SeeingPanel::forget_wanted,
                   [&](int view) { forgotten.push_back(view); });
  QObject::connect(panel.get(), &SeeingPanel::save_wanted, [&] { ++saved; });
  panel->show_saved({"front", "inside"});
  click("view_forget");
  EXPECT_TRUE(forgotten.empty()) << "none is chosen";
  auto* list = find<QListWidget>("saved_views");
  ASSERT_EQ(list->count(), 2);
  list->setCurrentRow(1);
  emit list->itemClicked(list->item(1));
  panel->show_saved({"front", "inside"});
  click("view_forget");
  click("view_save");
  EXPECT_EQ(wanted, std::vector<int>{1});
  EXPECT_EQ(forgotten, std::vector<int>{1}) << "the same names leave the choice";
  EXPECT_EQ(saved, 1);
}

}  // namespace
}  // namespace sonde::ui::test
