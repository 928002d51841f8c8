// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/parts_control.hpp"

#include <QMimeData>
#include <QPushButton>
#include <QTreeWidget>
#include <cmath>

#include "engine/queries/body_queries.hpp"
#include "engine/scene/scene.hpp"
#include "tests/ui/actions/parts_fixture.hpp"
#include "tests/ui/drop_files.hpp"
#include "ui/actions/document_control.hpp"
#include "ui/actions/seeing_control.hpp"
#include "ui/panels/parts_panel.hpp"
#include "ui/views/body_look.hpp"

namespace sonde::ui {
namespace {

class PartsControlTest : public test::PartsTest {};

TEST_F(PartsControlTest, they_are_listed_and_a_tick_takes_one_from_the_picture) {
  ASSERT_EQ(rows->topLevelItemCount(), 3);
  EXPECT_EQ(rows->topLevelItem(1)->text(name), "middle");
  EXPECT_EQ(rows->topLevelItem(1)->text(triangles), "12");
  window->documents().set_part_colour(2, QStringLiteral("#20c020"));
  ASSERT_TRUE(steps(1));
  const QColor green(0x20, 0xc0, 0x20);
  EXPECT_GT(pixels_like(green), 500);
  const std::size_t felt_before = fixed().soup.triangles.size();
  tick(2, shown, false);
  EXPECT_EQ(document().stack().count(), 2);
  EXPECT_EQ(pixels_like(green), 0);
  EXPECT_EQ(fixed().soup.triangles.size(), felt_before) << "it is felt all the same";
  act("undo");
  EXPECT_GT(pixels_like(green), 500);
}

// Reference: the body of the parts that are left.
TEST_F(PartsControlTest, what_is_not_felt_is_not_in_the_loop_but_in_the_picture) {
  window->documents().set_part_colour(2, QStringLiteral("#20c020"));
  ASSERT_TRUE(steps(1));
  const QColor green(0x20, 0xc0, 0x20);
  const int before = pixels_like(green);
  tick(2, felt, false);
  ASSERT_TRUE(steps(2));
  EXPECT_EQ(fixed().soup.triangles.size(), 24u);
  EXPECT_NEAR(fixed().mass.measure, 2e-3, 1e-12);
  EXPECT_NEAR(pixels_like(green), before, 0.05 * before);
  tick(0, felt, false);
  ASSERT_TRUE(steps(3));
  EXPECT_EQ(part_at(fixed(), {0, 0, 0}), "middle");
  tick(1, felt, false);
  settle();
  EXPECT_EQ(document().stack().count(), 3) << "one stays";
  EXPECT_EQ(rows->topLevelItem(1)->checkState(felt), Qt::Checked);
  act("undo");
  act("undo");
  ASSERT_TRUE(test::wait_until([this] { return fixed().soup.triangles.size() == 36; }));
}

TEST_F(PartsControlTest, a_click_in_the_view_chooses_and_so_does_one_in_the_list) {
  for (int part = 0; part < 3; ++part) {
    const QPointF at = window->viewport().on_screen({0.2 * part + 0.05, 0.05, 0.1});
    const QPointF clear = part == 0 ? window->viewport().on_screen({0.05, 0.0, 0.03}) : at;
    drag(Qt::LeftButton, clear, {0, 0});
    EXPECT_EQ(window->parts().panel().chosen(), std::size_t(part));
  }
  const QImage with_box = picture();
  window->parts().choose({});
  EXPECT_GT(test::pixels_between(with_box, picture()), 100) << "a box round it";
  rows->topLevelItem(0)->setSelected(true);
  EXPECT_GT(test::pixels_between(with_box, picture()), 100);
}

TEST_F(PartsControlTest, meshes_that_are_dragged_here_become_parts_of_one_mesh_too) {
  open_cubes();
  ASSERT_EQ(rows->topLevelItemCount(), 1);
  EXPECT_FALSE(rows->topLevelItem(0)->flags() & Qt::ItemIsUserCheckable);
  int asked_for = 0;
  window->prompts().ask_role = [&](const QString&, int meshes) {
    asked_for = meshes;
    return std::optional(Role::parts);
  };
  folder.write("far.off", cube(0.02));
  window->documents().drop({path("far.off"), path("open.off")});
  ASSERT_TRUE(steps(1));
  EXPECT_EQ(asked_for, 2);
  ASSERT_EQ(rows->topLevelItemCount(), 3);
  EXPECT_EQ(fixed().parts.size(), 3u);
  EXPECT_EQ(fixed().parts[0].name, "cube.off");
  act("undo");
  ASSERT_TRUE(test::wait_until([this] { return rows->topLevelItemCount() == 1; }));
  act("redo");
  ASSERT_TRUE(test::wait_until([this] { return rows->topLevelItemCount() == 3; }));
  act("swap_bodies");
  ASSERT_TRUE(test::wait_until([this] { return window->session()->probe().parts.size() == 3; }));
  EXPECT_EQ(rows->topLevelItemCount(), 1);
  act("swap_bodies");
  ASSERT_TRUE(test::wait_until([this] { return fixed().parts.size() == 3; }));
}

TEST_F(PartsControlTest, files_that_are_dragged_here_are_parts_or_a_reason_and_what_is_open_stays) {
  int asked = 0, asked_for = 0;
  window->prompts().ask_role = [&](const QString&, int meshes) {
    ++asked;
    asked_for = meshes;
    return std::optional(Role::parts);
  };
  const auto names = [this] {
    QStringList out;
    for (int i = 0; i < rows->topLevelItemCount(); ++i) out << rows->topLevelItem(i)->text(name);
    return out.join('|');
  };
  test::drop_files(*window, {path("open.off"), path("open.off")});
  ASSERT_TRUE(steps(1));
  EXPECT_EQ(names(), "left|middle|right|open.off|open.off (2)") << "twice the same";
  test::drop_files(*window, {path("open.off"), path("cube.off"), path("large.off")});
  ASSERT_TRUE(steps(2));
  EXPECT_EQ(asked_for, 3);
  EXPECT_EQ(names(), "left|middle|right|open.off|open.off (2)|open.off (3)|cube.off|large.off");
  folder.write("bad.stl", "solid nothing\n");
  folder.write("no mesh.txt", "");
  for (const QStringList& bad :
       {QStringList{path("bad.stl")}, QStringList{path("gone.ply")},
        QStringList{path("no mesh.txt")}, QStringList{path("cube.off"), path("bad.stl")}}) {
    complaints.clear();
    test::drop_files(*window, bad);
    ASSERT_TRUE(test::wait_until([this] { return !complaints.empty(); })) << bad[0].toStdString();
    EXPECT_TRUE(complaints[0].contains(QFileInfo(bad.last()).fileName()));
    EXPECT_EQ(document().stack().count(), 2);
    EXPECT_EQ(rows->topLevelItemCount(), 8);
  }
  const int before = asked;
  complaints.clear();
  test::drop_files(*window, {"http://example.org/part.stl"});
  ASSERT_TRUE(test::wait_until([this] { return !complaints.empty(); }));
  EXPECT_TRUE(complaints[0].contains("example.org")) << complaints[0].toStdString();
  EXPECT_EQ(asked, before) << "nobody is asked what a link is to be";
}

// Reference: as many cubes as there are parts.
TEST_F(PartsControlTest, Full_as_many_as_there_may_be_are_opened_and_listed) {
  std::string parts;
  for (std::size_t i = 0; i < most_parts; ++i)
    parts += (i == 0 ? "[" : ",\n") + std::string(R"({"mesh": "cube.off", "name": ")") +
             std::to_string(i) + R"(", "pose": [)" + std::to_string(0.2 * double(i % 100)) + "," +
             std::to_string(0.2 * double(i / 100)) + ",0,1,0,0,0]}";
  const auto many = folder.write("many.sonde.json", R"({"unit": "m",
      "probe": {"mesh": "cube.off", "pose": [0, 0, 0.12, 1, 0, 0, 0]}, "fixed": )" +
                                                        parts + "]}");
  open({QString::fromStdString(many.string())});
  ASSERT_EQ(failed, 0) << (complaints.empty() ? "" : complaints[0].toStdString());
  ASSERT_EQ(rows->topLevelItemCount(), int(most_parts));
  EXPECT_EQ(fixed().soup.triangles.size(), 12 * most_parts);
  EXPECT_NEAR(fixed().mass.measure, 1e-3 * double(most_parts), 1e-9);
  EXPECT_EQ(rows->topLevelItem(9999)->text(name), "9999");
  EXPECT_EQ(rows->topLevelItem(9999)->text(triangles), "12");
  tick(9999, felt, false);
  ASSERT_TRUE(steps(1));
  EXPECT_EQ(fixed().soup.triangles.size(), 12 * (most_parts - 1));
  EXPECT_EQ(rows->topLevelItem(9999)->checkState(felt), Qt::Unchecked);
}

TEST_F(PartsControlTest,
       as_a_scene_opens_they_are_cut_in_their_colours_and_hidden_ones_not_chosen) {
  const auto row = folder.write("looks.sonde.json", R"({"unit": "m",
      "probe": {"mesh": "cube.off", "pose": [0, 0, 0.3, 1, 0, 0, 0]},
      "fixed": [{"name": "left", "mesh": "cube.off", "colour": "#20c020"},
                {"name": "right", "mesh": "cube.off", "pose": [0.2, 0, 0, 1, 0, 0, 0],
                 "shown": false}]})");
  open({QString::fromStdString(row.string())});
  const QPointF at_right = window->viewport().on_screen({0.25, 0.05, 0.1});
  drag(Qt::LeftButton, at_right, {0, 0});
  EXPECT_FALSE(window->parts().panel().chosen());
  find<QPushButton>("cut_y")->click();
  window->seeing().look_from(cut_normal(), Vec3::UnitZ());
  const QImage seen = picture();
  const QPoint middle = window->viewport().on_screen({0.05, 0.05, 0.05}).toPoint();
  const QColor found = seen.pixelColor(middle - QPoint(20, 20));
  const QColor expected = cut_colour(QColor(0x20, 0xc0, 0x20));
  EXPECT_NEAR(found.red(), expected.red(), 2);
  EXPECT_NEAR(found.green(), expected.green(), 2);
  EXPECT_NEAR(found.blue(), expected.blue(), 2);
}

TEST_F(PartsControlTest, contacts_and_clearance_name_the_part) {
  ASSERT_TRUE(test::wait_until([this] {
    return find<QLabel>("depth_value")->text().contains(QStringLiteral("of left"));
  })) << find<QLabel>("depth_value")->text().toStdString();
  auto* contacts = find<QTreeWidget>("contact_rows");
  find<QDockWidget>("contacts_panel")->show();
  find<QDockWidget>("contacts_panel")->raise();
  window->documents().place({Quat::Identity(), {0.41, 0, 0.095}}, QStringLiteral("there"));
  ASSERT_TRUE(test::wait_until([&] {
    return contacts->topLevelItemCount() > 0 && contacts->topLevelItem(0)->text(1) == "right";
  }));
}

}  // namespace
}  // namespace sonde::ui
