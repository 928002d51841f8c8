// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/clash_control.hpp"

#include <QPushButton>
#include <QTreeWidget>

#include "tests/ui/window_fixture.hpp"
#include "ui/panels/clash_panel.hpp"

namespace sonde::ui {
namespace {

using ClashControlTest = test::WindowTest;

// Cubes of 0.1 m. Reference: by hand. The probe overlaps the left one by 10 mm in z; the middle one
// touches the left one; the right one is 2 mm from the middle one.
TEST_F(ClashControlTest, pairs_are_listed_the_deepest_first_and_a_click_goes_there) {
  const auto row = folder.write("row.sonde.json", R"({"unit": "m",
      "probe": {"mesh": "cube.off", "pose": [0, 0, 0.09, 1, 0, 0, 0]},
      "fixed": [{"name": "left", "mesh": "cube.off"},
                {"name": "middle", "mesh": "cube.off", "pose": [0.1, 0, 0, 1, 0, 0, 0]},
                {"name": "right", "mesh": "cube.off", "pose": [0.202, 0, 0, 1, 0, 0, 0],
                 "felt": false}]})");
  open({QString::fromStdString(row.string())});
  ASSERT_EQ(failed, 0);
  window->clash().panel().show();
  find<QPushButton>("clash_find")->click();
  auto* rows = find<QTreeWidget>("clash_rows");
  ASSERT_TRUE(test::wait_until([&] { return rows->topLevelItemCount() > 0; }));
  const std::vector<Clash>& found = window->clash().found();
  ASSERT_GE(found.size(), 3u);
  EXPECT_EQ(rows->topLevelItem(0)->text(0), "probe");
  EXPECT_EQ(rows->topLevelItem(0)->text(1), "left");
  EXPECT_EQ(rows->topLevelItem(0)->text(2), "overlapping");
  EXPECT_NEAR(found[0].depth.value_or(0), 0.01, 1e-7);
  EXPECT_TRUE(rows->topLevelItem(0)->text(5).contains("by")) << "the motion that parts them";
  EXPECT_EQ(found.back().kind, Clash::Kind::clear);
  EXPECT_NEAR(found.back().clearance.value_or(0), 0.002, 1e-12);
  EXPECT_EQ(rows->topLevelItem(rows->topLevelItemCount() - 1)->text(1), "right");
  const CameraPlace before = window->viewport().place();
  emit rows->itemClicked(rows->topLevelItem(0), 0);
  ASSERT_TRUE(test::wait_until(
      [&] { return (window->viewport().place().target - *found[0].place).norm() < 1e-6; }));
  EXPECT_GT((window->viewport().place().position - before.position).norm(), 0.01);
}

TEST_F(ClashControlTest, what_is_open_next_has_no_clashes_of_before) {
  open_cubes();
  window->clash().find();
  ASSERT_TRUE(test::wait_until([&] { return !window->clash().found().empty(); }));
  open_cubes();
  EXPECT_TRUE(window->clash().found().empty());
  EXPECT_EQ(find<QTreeWidget>("clash_rows")->topLevelItemCount(), 0);
}

}  // namespace
}  // namespace sonde::ui
