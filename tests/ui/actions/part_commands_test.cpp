// SPDX-License-Identifier: GPL-3.0-or-later
// The commands of DocumentControl about the parts of the fixed body.

#include <gtest/gtest.h>

#include <QPushButton>
#include <QTreeWidget>
#include <functional>
#include <string>
#include <vector>

#include "engine/queries/body_queries.hpp"
#include "engine/scene/scene.hpp"
#include "engine/scene/write_scene.hpp"
#include "tests/ui/actions/parts_fixture.hpp"
#include "ui/document/pose_text.hpp"

namespace sonde::ui::test {
namespace {

class PartCommandsTest : public PartsTest {
 protected:
  void SetUp() override {
    PartsTest::SetUp();
    QObject::connect(&window->documents(), &DocumentControl::say,
                     [this](const QString& what) { said << what; });
  }
  const SceneBody& part(std::size_t i) { return document().content().scene.fixed.parts.at(i); }
  QStringList said;
};

TEST_F(PartCommandsTest, parts_are_added_renamed_removed_and_kept_in_the_file) {
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

// Reference: where the two cubes of the file lie.
TEST_F(PartCommandsTest, a_mesh_is_taken_apart_into_its_components) {
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
  ASSERT_TRUE(wait_until([this] { return fixed().parts.size() == 2; }));
}

TEST_F(PartCommandsTest, a_part_that_cannot_be_read_is_no_step) {
  folder.write("bad.off", "OFF\n1 1 0\n0 0\n");
  window->documents().add_parts({path("bad.off")});
  ASSERT_TRUE(wait_until([this] { return !complaints.empty(); }));
  EXPECT_TRUE(complaints[0].contains("bad.off")) << complaints[0].toStdString();
  EXPECT_EQ(document().stack().count(), 0);
  EXPECT_EQ(rows->topLevelItemCount(), 3);
}

TEST_F(PartCommandsTest, what_changes_the_picture_alone_is_a_step_that_comes_back) {
  DocumentControl& documents = window->documents();
  documents.rename_part(0, " lid ");
  ASSERT_TRUE(steps(1));
  documents.set_part_colour(1, "#20c020");
  documents.set_part_shown(2, false);
  EXPECT_EQ(part(0).name, "lid");
  EXPECT_EQ(part(1).colour, "#20c020");
  EXPECT_FALSE(part(2).shown);
  EXPECT_EQ(document().stack().count(), 3);
  act("undo");
  EXPECT_TRUE(part(2).shown);
  act("undo");
  EXPECT_EQ(part(1).colour, "");
  act("undo");
  ASSERT_TRUE(steps(0));
  EXPECT_EQ(part(0).name, "left");
  EXPECT_FALSE(document().modified());
}

TEST_F(PartCommandsTest, a_part_has_a_name_that_no_other_has) {
  for (const char* name : {"middle", "  ", "left"}) window->documents().rename_part(0, name);
  EXPECT_EQ(document().stack().count(), 0);
  EXPECT_EQ(part(0).name, "left");
  ASSERT_EQ(said.size(), 2) << "its own name is no change";
  EXPECT_TRUE(said[0].contains("“middle” already")) << said[0].toStdString();
}

TEST_F(PartCommandsTest, one_part_is_felt_and_one_remains) {
  DocumentControl& documents = window->documents();
  documents.set_part_felt(0, false);
  ASSERT_TRUE(steps(1));
  documents.set_part_felt(1, false);
  ASSERT_TRUE(steps(2));
  documents.set_part_felt(2, false);
  documents.remove_part(2);
  EXPECT_EQ(document().stack().count(), 2);
  EXPECT_TRUE(part(2).felt);
  EXPECT_EQ(said.size(), 2) << said.join('\n').toStdString();
  documents.remove_part(0);
  ASSERT_TRUE(steps(3));
  documents.remove_part(0);
  ASSERT_TRUE(steps(4));
  said.clear();
  documents.remove_part(0);
  EXPECT_EQ(document().stack().count(), 4);
  ASSERT_EQ(said.size(), 1);
  EXPECT_TRUE(said[0].contains("no other part")) << said[0].toStdString();
  act("undo");
  act("undo");
  EXPECT_TRUE(wait_until([this] { return rows->topLevelItemCount() == 3; }));
  EXPECT_EQ(document().content().scene.fixed.parts.size(), 3u);
}

// Reference: the document as text, and the probe's pose, as they were before and after each.
TEST_F(PartCommandsTest, whatever_was_done_to_parts_comes_back_and_is_done_again) {
  DocumentControl& documents = window->documents();
  folder.write("two.off", two_cubes());
  const auto as_text = [this] {
    return scene_text(document().content().scene, "/") + pose_text(document().content().here);
  };
  const std::vector<std::function<void()>> actions{
      [&] { documents.add_parts({path("two.off")}); },
      [&] { documents.rename_part(3, QString::fromUtf8("дуга M3.5")); },
      [&] { documents.set_part_colour(3, "#20c020"); },
      [&] { documents.take_apart(3); },
      [&] { documents.set_part_shown(4, false); },
      [&] { documents.set_part_felt(1, false); },
      [&] {
        documents.place({Quat::Identity(), Vec3(0.3, 0.1, 0.2)}, "there");
      },
      [&] { documents.remove_part(0); },
      [&] { documents.swap_bodies(); },
      [&] { documents.set_part_colour(0, "#2020c0"); },
      [&] { documents.swap_bodies(); },
  };
  std::vector<std::string> texts{as_text()};
  for (const auto& action : actions) {
    action();
    ASSERT_TRUE(steps(int(texts.size()))) << texts.size();
    texts.push_back(as_text());
    EXPECT_NE(texts.back(), texts[texts.size() - 2]) << texts.size();
  }
  const auto expect_state = [&](std::size_t k) {
    ASSERT_TRUE(steps(int(k)));
    EXPECT_EQ(as_text(), texts[k]) << k;
  };
  for (int round = 0; round < 2; ++round) {
    for (std::size_t k = actions.size(); k-- > 0;) {
      act("undo");
      expect_state(k);
    }
    EXPECT_FALSE(document().modified());
    for (std::size_t k = 1; k <= actions.size(); ++k) {
      act("redo");
      expect_state(k);
    }
  }
  EXPECT_EQ(part(2).name, "дуга M3.5:1");
  EXPECT_TRUE(complaints.empty()) << complaints[0].toStdString();
}

TEST_F(PartCommandsTest, what_is_no_part_is_left_alone) {
  DocumentControl& documents = window->documents();
  documents.remove_part(3);
  documents.take_apart(3);
  documents.rename_part(3, "none");
  documents.set_part_felt(3, false);
  documents.add_parts({});
  EXPECT_EQ(document().stack().count(), 0);
  EXPECT_TRUE(said.isEmpty());
}

TEST_F(PartCommandsTest, without_a_document_nothing_happens) {
  act("new");
  DocumentControl& documents = window->documents();
  documents.add_parts({path("cube.off")});
  documents.remove_part(0);
  documents.take_apart(0);
  documents.rename_part(0, "lid");
  documents.set_part_colour(0, "#20c020");
  documents.set_part_shown(0, false);
  documents.set_part_felt(0, false);
  EXPECT_EQ(document().stack().count(), 0);
  EXPECT_TRUE(document().empty());
}

}  // namespace
}  // namespace sonde::ui::test
