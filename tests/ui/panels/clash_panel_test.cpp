// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/clash_panel.hpp"

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>

#include "tests/support/shapes.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/panels/number_field.hpp"

namespace sonde::ui::test {
namespace {

/// Two cubes of 40 mm of which the second overlaps the first by 10 mm in x, and a third that is
/// clear of it by 5 mm.
class ClashPanelTest : public testing::Test {
 protected:
  void SetUp() override {
    need_application();
    panel = std::make_unique<ClashPanel>();
    const auto cube = sonde::test::body(sonde::test::box({0.04, 0.04, 0.04}));
    parts = {{"base", cube, {}},
             {"pin", cube, {Quat::Identity(), {0.03, 0, 0}}},
             {"lid", cube, {Quat::Identity(), {0.075, 0, 0}}}};
    Clash deep, near, failed;
    deep.parts = {0, 1};
    deep.kind = Clash::Kind::overlapping;
    deep.depth = 0.01;
    deep.lower_bound = 0.0095;
    deep.moved = 1;
    deep.separated = Pose{Quat::Identity(), {0.04, 0, 0}};
    near.parts = {1, 2};
    near.kind = Clash::Kind::clear;
    near.clearance = 0.005;
    failed.parts = {0, 2};
    failed.kind = Clash::Kind::failed;
    failed.reason = "too large";
    found = {deep, near, failed};
  }
  QString cell(int row, int column) const {
    return panel->findChild<QTreeWidget*>("clash_rows")->topLevelItem(row)->text(column);
  }
  QString summary() const { return panel->findChild<QLabel*>("clash_summary")->text(); }

  std::unique_ptr<ClashPanel> panel;
  std::vector<AssemblyPart> parts;
  std::vector<Clash> found;
};

TEST_F(ClashPanelTest, each_clash_is_a_row_with_its_length_and_the_way_out) {
  panel->show_clashes(parts, found);
  EXPECT_EQ(cell(0, 0), "base");
  EXPECT_EQ(cell(0, 1), "pin");
  EXPECT_EQ(cell(0, 2), "overlapping");
  EXPECT_EQ(cell(0, 3), "10.000 mm");
  EXPECT_EQ(cell(0, 4), "9.500 mm");
  EXPECT_EQ(cell(0, 5), "pin by 10.000, 0.000, 0.000 mm, 0°");
  EXPECT_EQ(cell(1, 2), "clear");
  EXPECT_EQ(cell(1, 3), "5.000 mm") << "the room between them";
  EXPECT_EQ(cell(1, 4) + cell(1, 5), "");
  EXPECT_EQ(cell(2, 5), "too large");
  EXPECT_TRUE(summary().startsWith("3 parts.") &&
              summary().contains("that touch: 0, that are near: 1."))
      << summary().toStdString();
  panel->take(0.05);
  EXPECT_EQ(panel->findChild<QTreeWidget*>("clash_rows")->topLevelItemCount(), 0)
      << "of another scene";
}

/// About the part's own centre: a turn by 90° about z moves no centre of mass.
TEST_F(ClashPanelTest, a_way_out_tells_the_centre_of_mass_and_the_turn) {
  Clash clash = found[0];
  clash.separated = Pose{Quat(Eigen::AngleAxisd(std::acos(0.0), Vec3::UnitZ())), parts[1].X_WM.p};
  EXPECT_EQ(way_out_text(clash, parts, LengthUnit(0.05)), "pin by 0.000, 0.000, 0.000 mm, 90.0°");
  clash.separated.reset();
  EXPECT_EQ(way_out_text(clash, parts, LengthUnit(0.05)), "");
}

TEST_F(ClashPanelTest, what_is_typed_is_in_the_unit_of_the_scene_and_nothing_below_zero) {
  panel->take(0.05);
  EXPECT_DOUBLE_EQ(panel->within(), 0.005) << "a tenth of the radius";
  EXPECT_EQ(panel->allowance(), 0);
  auto* within = panel->findChild<NumberField*>("clash_within");
  auto* allowance = panel->findChild<NumberField*>("clash_allowance");
  within->setText("2,5");
  allowance->setText("0.25");
  EXPECT_DOUBLE_EQ(panel->within(), 2.5e-3);
  EXPECT_DOUBLE_EQ(panel->allowance(), 2.5e-4);
  within->setText("-1");
  allowance->setText("a bit");
  EXPECT_EQ(panel->within(), 0);
  EXPECT_EQ(panel->allowance(), 0);
  panel->take(5);  // in metres now
  EXPECT_DOUBLE_EQ(panel->within(), 0.5);
}

TEST_F(ClashPanelTest, a_click_on_a_row_chooses_that_clash_and_the_button_finds_them) {
  std::vector<std::size_t> chosen;
  int wanted = 0, stopped = 0;
  QObject::connect(panel.get(), &ClashPanel::chosen,
                   [&](std::size_t clash) { chosen.push_back(clash); });
  QObject::connect(panel.get(), &ClashPanel::find_wanted, [&] { ++wanted; });
  QObject::connect(panel.get(), &ClashPanel::stop_wanted, [&] { ++stopped; });
  panel->show_clashes(parts, found);
  auto* rows = panel->findChild<QTreeWidget*>("clash_rows");
  emit rows->itemClicked(rows->topLevelItem(1), 3);
  emit rows->itemActivated(rows->topLevelItem(2), 0);
  EXPECT_EQ(chosen, (std::vector<std::size_t>{1, 2}));
  panel->findChild<QPushButton*>("clash_find")->click();
  panel->show_progress(0.5);
  panel->findChild<QPushButton*>("clash_find_stop")->click();
  EXPECT_EQ(wanted, 1);
  EXPECT_EQ(stopped, 1);
  panel->show_reason("there is one part");
  EXPECT_EQ(summary(), "there is one part");
}

}  // namespace
}  // namespace sonde::ui::test
