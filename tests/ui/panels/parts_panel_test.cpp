// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/parts_panel.hpp"

#include <gtest/gtest.h>

#include <QPushButton>
#include <QTreeWidget>
#include <string>

#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

enum PartCell { name_cell, shown_cell, felt_cell, triangles_cell };

/// "plate.off", "bolt", and "plate.off:2", which is neither shown nor felt.
SceneBody three_parts() {
  SceneBody out;
  out.parts.resize(3);
  out.parts[0].mesh = "meshes/plate.off";
  out.parts[0].colour = "#102030";
  out.parts[1].mesh = "meshes/b.off";
  out.parts[1].name = "bolt";
  out.parts[2].mesh = "meshes/plate.off";
  out.parts[2].component = 2;
  out.parts[2].shown = out.parts[2].felt = false;
  return out;
}

class PartsPanelTest : public testing::Test {
 protected:
  void SetUp() override {
    need_application();
    panel = std::make_unique<PartsPanel>();
    const auto with = [this](const char* what) {
      return [this, what](std::size_t part) { tell(what + std::to_string(part)); };
    };
    QObject::connect(panel.get(), &PartsPanel::remove_wanted, with("remove "));
    QObject::connect(panel.get(), &PartsPanel::colour_wanted, with("colour "));
    QObject::connect(panel.get(), &PartsPanel::take_apart_wanted, with("take apart "));
    QObject::connect(panel.get(), &PartsPanel::add_wanted, [this] { tell("add"); });
    QObject::connect(panel.get(), &PartsPanel::swap_wanted, [this] { tell("swap"); });
    QObject::connect(panel.get(), &PartsPanel::rename_wanted,
                     [this](std::size_t part, const QString& name) {
                       tell("name " + std::to_string(part) + ' ' + name.toStdString());
                     });
    QObject::connect(panel.get(), &PartsPanel::shown_wanted, [this](std::size_t part, bool on) {
      tell((on ? "show " : "hide ") + std::to_string(part));
    });
    QObject::connect(panel.get(), &PartsPanel::felt_wanted, [this](std::size_t part, bool on) {
      tell((on ? "feel " : "leave ") + std::to_string(part));
    });
    QObject::connect(panel.get(), &PartsPanel::chosen_changed,
                     [this](std::optional<std::size_t> part) {
                       tell(part ? "choose " + std::to_string(*part) : "choose none");
                     });
  }
  void tell(const std::string& what) { told.push_back(what); }
  QTreeWidgetItem& row(int i) const {
    return *panel->findChild<QTreeWidget*>("part_rows")->topLevelItem(i);
  }
  QPushButton& button(const char* name) const { return *panel->findChild<QPushButton*>(name); }

  std::unique_ptr<PartsPanel> panel;
  std::vector<std::string> told;
};

TEST_F(PartsPanelTest, each_part_is_a_row_with_its_name_its_ticks_and_its_triangles) {
  panel->show_parts(three_parts(), {12, 340});
  EXPECT_EQ(row(0).text(name_cell), "plate.off");
  EXPECT_EQ(row(1).text(name_cell), "bolt");
  EXPECT_EQ(row(2).text(name_cell), "plate.off:2");
  EXPECT_EQ(row(0).icon(name_cell).pixmap(14, 14).toImage().pixelColor(7, 7), QColor(16, 32, 48));
  EXPECT_EQ(row(0).checkState(shown_cell), Qt::Checked);
  EXPECT_EQ(row(2).checkState(shown_cell), Qt::Unchecked);
  EXPECT_EQ(row(2).checkState(felt_cell), Qt::Unchecked);
  EXPECT_EQ(row(1).text(triangles_cell), "340");
  EXPECT_EQ(row(2).text(triangles_cell), "") << "not known";
  EXPECT_TRUE(row(2).toolTip(name_cell).contains("plate.off:2")) << "whole where it is cut off";
  SceneBody fewer = three_parts();
  fewer.parts.pop_back();
  panel->show_parts(fewer, {});
  EXPECT_EQ(row(0).treeWidget()->topLevelItemCount(), 2);
  EXPECT_TRUE(told.empty()) << "showing is no wish";
}

TEST_F(PartsPanelTest, ticks_and_names_of_the_user_are_told) {
  panel->show_parts(three_parts(), {});
  row(1).setCheckState(shown_cell, Qt::Unchecked);
  row(2).setCheckState(felt_cell, Qt::Checked);
  row(0).setText(name_cell, "lid");
  EXPECT_EQ(told, (std::vector<std::string>{"hide 1", "feel 2", "name 0 lid"}));
}

TEST_F(PartsPanelTest, buttons_are_about_the_chosen_part) {
  panel->show_parts(three_parts(), {});
  EXPECT_FALSE(button("remove_part").isEnabled() || button("part_colour").isEnabled());
  EXPECT_FALSE(button("take_apart").isEnabled());
  row(1).setSelected(true);
  for (const char* name : {"remove_part", "part_colour", "take_apart", "add_part", "swap_parts"})
    button(name).click();
  EXPECT_EQ(told, (std::vector<std::string>{"choose 1", "remove 1", "colour 1", "take apart 1",
                                            "add", "swap"}));
  panel->choose(2);
  EXPECT_EQ(panel->chosen(), std::optional<std::size_t>(2));
  EXPECT_EQ(told.size(), 6u) << "the view chose it";
  panel->choose({});
  EXPECT_FALSE(panel->chosen().has_value());
}

TEST_F(PartsPanelTest, a_body_of_one_mesh_cannot_be_emptied_and_need_not_be_chosen) {
  SceneBody one;
  one.mesh = "cube.off";
  panel->show_parts(one, {12});
  EXPECT_FALSE(row(0).flags() & (Qt::ItemIsUserCheckable | Qt::ItemIsEditable));
  button("take_apart").click();
  EXPECT_EQ(told, std::vector<std::string>{"take apart 0"});
  row(0).setSelected(true);
  EXPECT_FALSE(button("remove_part").isEnabled());
  panel->show_nothing();
  for (const char* name : {"remove_part", "part_colour", "take_apart", "add_part", "swap_parts"})
    EXPECT_FALSE(button(name).isEnabled()) << name;
}

}  // namespace
}  // namespace sonde::ui::test
