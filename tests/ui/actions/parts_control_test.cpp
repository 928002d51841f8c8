// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/parts_control.hpp"

#include <QMimeData>
#include <QPushButton>
#include <QTreeWidget>
#include <array>
#include <cmath>

#include "engine/queries/body_queries.hpp"
#include "engine/scene/scene.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/actions/document_control.hpp"
#include "ui/actions/seeing_control.hpp"
#include "ui/panels/parts_panel.hpp"
#include "ui/views/body_look.hpp"

namespace sonde::ui {
namespace {

/// Three cubes of 0.1 m side by side, with gaps of 0.1 m; the probe is the same cube, 20 mm above
/// the first.
class PartsControlTest : public test::WindowTest {
 protected:
  enum Column { name, shown, felt, triangles };

  void SetUp() override {
    WindowTest::SetUp();
    const auto row = folder.write("row.sonde.json", R"({"format": 1, "unit": "m",
        "probe": {"mesh": "cube.off", "pose": [0, 0, 0.12, 1, 0, 0, 0]},
        "fixed": [{"name": "left", "mesh": "cube.off"},
                  {"name": "middle", "mesh": "cube.off", "pose": [0.2, 0, 0, 1, 0, 0, 0]},
                  {"name": "right", "mesh": "cube.off", "pose": [0.4, 0, 0, 1, 0, 0, 0]}]})");
    open({QString::fromStdString(row.string())});
    ASSERT_EQ(failed, 0) << (complaints.empty() ? "" : complaints[0].toStdString());
    rows = find<QTreeWidget>("part_rows");
    window->parts().panel().show();
    window->parts().panel().raise();
  }
  Document& document() { return window->documents().document(); }
  const Body& fixed() { return window->session()->fixed(); }
  void tick(int row, int column, bool on) {
    rows->topLevelItem(row)->setCheckState(column, on ? Qt::Checked : Qt::Unchecked);
  }
  /// Waits for what is read anew.
  bool steps(int count) {
    return test::wait_until([&] { return document().stack().index() == count; }) &&
           test::wait_until([&] { return window->shown().has_value(); });
  }
  /// How many pixels of the picture are of that colour, but for shading: as red, as green and as
  /// blue, in proportion.
  int pixels_like(const QColor& colour) {
    const QImage seen = picture();
    int count = 0;
    for (int y = 0; y < seen.height(); ++y)
      for (int x = 0; x < seen.width(); ++x) {
        const QColor at = seen.pixelColor(x, y);
        const double light = at.value() / double(std::max(colour.value(), 1));
        count += light > 0.3 && std::abs(at.red() - light * colour.red()) < 6 &&
                 std::abs(at.green() - light * colour.green()) < 6 &&
                 std::abs(at.blue() - light * colour.blue()) < 6;
      }
    return count;
  }
  /// Two cubes of 0.1 m, 0.3 m apart, in one file.
  static std::string two_cubes() {
    std::string corners, faces;
    for (int k = 0; k < 2; ++k) {
      for (int i = 0; i < 8; ++i)
        corners += std::to_string(0.3 * k + ((i & 1) != 0 ? 0.05 : -0.05)) + " " +
                   ((i & 2) != 0 ? "0.05 " : "-0.05 ") + ((i & 4) != 0 ? "0.05\n" : "-0.05\n");
      for (const auto& f :
           {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
            std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}}) {
        faces += "4";
        for (const int corner : f) faces.append(" ").append(std::to_string(corner + 8 * k));
        faces += "\n";
      }
    }
    return "OFF\n16 12 0\n" + corners + faces;
  }
  Vec3 cut_normal() const { return window->viewport().seeing().cut.normal; }
  QTreeWidget* rows = nullptr;
};

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

TEST_F(PartsControlTest, parts_are_added_renamed_removed_and_kept_in_the_file) {
  const Pose before = window->session()->device_pose();
  window->prompts().ask_parts = [this] { return QStringList{path("cube.off"), path("cube.off")}; };
  find<QPushButton>("add_part")->click();
  ASSERT_TRUE(steps(1));
  ASSERT_EQ(rows->topLevelItemCount(), 5);
  EXPECT_EQ(rows->topLevelItem(3)->text(name), "cube.off");
  EXPECT_EQ(rows->topLevelItem(4)->text(name), "cube.off (2)");
  EXPECT_EQ(window->session()->device_pose().p, before.p);
  rows->topLevelItem(3)->setText(name, "lid");
  ASSERT_TRUE(steps(2));
  rows->topLevelItem(4)->setText(name, "lid");
  settle();
  EXPECT_EQ(document().stack().count(), 2) << "a name that is taken";
  EXPECT_EQ(rows->topLevelItem(4)->text(name), "cube.off (2)");
  tick(1, shown, false);
  tick(2, felt, false);
  ASSERT_TRUE(steps(4));
  window->parts().choose(4);
  find<QPushButton>("remove_part")->click();
  ASSERT_TRUE(steps(5));
  window->prompts().ask_save = [this](const QString&) { return path("kept.sonde.json"); };
  act("save_as");
  const Scene kept = read_scene(folder / "kept.sonde.json");
  EXPECT_EQ(kept.format, 1);
  ASSERT_EQ(kept.fixed.parts.size(), 4u);
  EXPECT_EQ(part_name(kept.fixed.parts[3]), "lid");
  EXPECT_FALSE(kept.fixed.parts[1].shown);
  EXPECT_FALSE(kept.fixed.parts[2].felt);
  EXPECT_TRUE(kept.fixed.parts[2].shown);
  open({path("kept.sonde.json")});
  ASSERT_EQ(rows->topLevelItemCount(), 4);
  EXPECT_EQ(rows->topLevelItem(2)->checkState(felt), Qt::Unchecked);
  EXPECT_EQ(fixed().parts.size(), 3u);
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

// Reference: where the two cubes of the file lie.
TEST_F(PartsControlTest, a_mesh_is_taken_apart_into_its_components) {
  const auto two = folder.write("two.off", two_cubes());
  const auto scene = folder.write("two.sonde.json", R"({"unit": "m",
      "probe": {"mesh": "cube.off", "pose": [0, 0, 0.12, 1, 0, 0, 0]},
      "fixed": {"mesh": "two.off", "pose": [0, 0, 0, 0, 0, 0, 1]}})");
  open({QString::fromStdString(scene.string())});
  ASSERT_EQ(rows->topLevelItemCount(), 1);
  find<QPushButton>("take_apart")->click();
  ASSERT_TRUE(steps(1)) << (complaints.empty() ? "" : complaints[0].toStdString());
  ASSERT_EQ(rows->topLevelItemCount(), 2);
  EXPECT_EQ(rows->topLevelItem(0)->text(name), "two.off:1");
  EXPECT_EQ(rows->topLevelItem(1)->text(name), "two.off:2");
  EXPECT_EQ(rows->topLevelItem(1)->text(triangles), "12");
  EXPECT_EQ(part_at(fixed(), {0.3, 0, 0}), "two.off:2");
  const QPointF at = window->viewport().on_screen({0.3, 0.0, 0.05});
  drag(Qt::LeftButton, at, {0, 0});
  EXPECT_EQ(window->parts().panel().chosen(), std::size_t{1});
  find<QPushButton>("take_apart")->click();
  settle();
  EXPECT_EQ(document().stack().count(), 1) << "it is one component";
  tick(1, felt, false);
  ASSERT_TRUE(steps(2));
  EXPECT_EQ(fixed().soup.triangles.size(), 12u);
  window->prompts().ask_save = [this](const QString&) { return path("kept.sonde.json"); };
  act("save_as");
  const Scene kept = read_scene(folder / "kept.sonde.json");
  ASSERT_EQ(kept.fixed.parts.size(), 2u);
  EXPECT_EQ(kept.fixed.parts[1].component, 2u);
  open({path("kept.sonde.json")});
  EXPECT_EQ(fixed().soup.triangles.size(), 12u);
  ASSERT_EQ(rows->topLevelItemCount(), 2);
  tick(1, felt, true);
  ASSERT_TRUE(test::wait_until([this] { return fixed().parts.size() == 2; }));
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

TEST_F(PartsControlTest, a_part_that_cannot_be_read_is_no_step) {
  folder.write("bad.off", "OFF\n1 1 0\n0 0\n");
  window->documents().add_parts({path("bad.off")});
  ASSERT_TRUE(test::wait_until([this] { return !complaints.empty(); }));
  EXPECT_TRUE(complaints[0].contains("bad.off")) << complaints[0].toStdString();
  EXPECT_EQ(document().stack().count(), 0);
  EXPECT_EQ(rows->topLevelItemCount(), 3);
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
