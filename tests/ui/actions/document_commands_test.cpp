// SPDX-License-Identifier: GPL-3.0-or-later
// The commands of DocumentControl about both bodies and their poses.

#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <cmath>

#include "tests/ui/document/document_fixture.hpp"

namespace sonde::ui::test {
namespace {

class DocumentCommandsTest : public DocumentTest {};

TEST_F(DocumentCommandsTest, swapped_bodies_stay_where_they_were_and_come_back) {
  folder.write("long.off", cube(0.2));
  folder.write("two.sonde.json", R"({"probe": {"mesh": "cube.off", "pose": [0.3, 0, 0, 1, 0, 0, 0]},
      "fixed": {"mesh": "long.off", "pose": [0, 0.1, 0, 0.6, 0, 0, 0.8]}})");
  open({path("two.sonde.json")});
  const Pose before = pose();
  act("swap_bodies");
  ASSERT_TRUE(wait_until(
      [this] { return window->session()->probe().name.find("long") != std::string::npos; }));
  EXPECT_TRUE(comes_to(inverse(before)));
  EXPECT_LT((relative_pose(document().content().scene).p - inverse(before).p).norm(), 1e-15);
  EXPECT_TRUE(document().modified());
  type("k_value", "800");
  act("undo");
  act("undo");
  ASSERT_TRUE(wait_until(
      [this] { return window->session()->probe().name.find("cube") != std::string::npos; }));
  EXPECT_TRUE(comes_to(before));
  EXPECT_FALSE(document().modified());
  act("redo");
  act("redo");
  ASSERT_TRUE(wait_until(
      [this] { return window->session()->probe().name.find("long") != std::string::npos; }));
  EXPECT_EQ(window->session()->coupling().k, 800);
}

TEST_F(DocumentCommandsTest, undone_before_it_was_on_show_it_never_is) {
  act("swap_bodies");
  ASSERT_TRUE(wait_until([&] { return document().stack().count() == 1; }));
  Session* const swapped = window->session();
  act("undo");
  act("redo");
  wait(300);
  EXPECT_EQ(window->session(), swapped);
  EXPECT_EQ(document().stack().index(), 1);
}

TEST_F(DocumentCommandsTest, units_change_and_come_back) {
  window->prompts().ask_bodies = [](const MeshPair& pair, const PairSetup& now) {
    EXPECT_NEAR(pair.probe_size.x(), 0.1, 1e-12);
    PairSetup said = now;
    said.probe.unit = said.fixed.unit = 1e-2;
    return std::optional(said);
  };
  const double radius = window->session()->probe().mass.radius;
  act("bodies");
  ASSERT_TRUE(wait_until([&] { return window->session()->probe().mass.radius < radius / 2; }));
  EXPECT_NEAR(window->session()->probe().mass.radius, radius / 100, 1e-9);
  EXPECT_NEAR(pose().p.x(), 0.0009, 1e-12) << "as far for its size";
  EXPECT_EQ(document().content().scene.unit, 1e-2);
  act("undo");
  ASSERT_TRUE(wait_until([&] { return window->session()->probe().mass.radius > radius / 2; }));
  EXPECT_FALSE(document().modified());
}

TEST_F(DocumentCommandsTest, an_allowance_is_set_saved_and_undone) {
  window->prompts().ask_bodies = [](const MeshPair& pair, const PairSetup& now) {
    EXPECT_NEAR(pair.probe_size.x(), 0.1, 1e-12) << "of the mesh";
    PairSetup said = now;
    said.probe.offset = now.probe.offset - 1e-3;
    return std::optional(said);
  };
  const double radius = window->session()->probe().mass.radius;
  const auto by = [this] { return window->session()->probe().offset.by; };
  act("bodies");
  ASSERT_TRUE(wait_until([&] { return by() == -1e-3; }));
  EXPECT_NEAR(window->session()->probe().mass.radius, radius - std::sqrt(3) * 1e-3, 1e-12);
  EXPECT_TRUE(document().modified());
  EXPECT_NE(document().text().find("\"allowance\""), std::string::npos);
  act("bodies");
  ASSERT_TRUE(wait_until([&] { return by() == -2e-3; }));
  act("undo");
  ASSERT_TRUE(wait_until([&] { return by() == -1e-3; }));
  act("undo");
  ASSERT_TRUE(wait_until([&] { return by() == 0; }));
  EXPECT_FALSE(document().modified());
}

TEST_F(DocumentCommandsTest, a_pose_is_copied_and_pasted_as_text) {
  drag(Qt::LeftButton, {500, 400}, {40, 10});
  const Pose copied = pose();
  key(Qt::Key_C, Qt::ControlModifier);
  drag(Qt::LeftButton, {500, 400}, {-80, 10}, Qt::ShiftModifier);
  key(Qt::Key_V, Qt::ControlModifier);
  EXPECT_TRUE(comes_to(copied));
  QApplication::clipboard()->setText("nothing of the kind");
  key(Qt::Key_V, Qt::ControlModifier);
  ASSERT_EQ(complaints.size(), 1u);
  EXPECT_TRUE(complaints[0].contains("\"nothing\" is no number")) << complaints[0].toStdString();
  EXPECT_TRUE(comes_to(copied));
}

/// Each of the two steps has other bodies, and the second undo comes before those of the first.
TEST_F(DocumentCommandsTest, steps_that_are_undone_quickly_end_where_the_history_is) {
  folder.write("long.off", cube(0.2));
  folder.write("two.sonde.json", R"({"probe": {"mesh": "cube.off", "pose": [0.3, 0, 0, 1, 0, 0, 0]},
      "fixed": {"mesh": "long.off"}})");
  open({path("two.sonde.json")});
  window->prompts().ask_bodies = [](const MeshPair&, const PairSetup& now) {
    PairSetup said = now;
    said.probe.offset = now.probe.offset - 1e-3;
    return std::optional(said);
  };
  const auto probe = [this] { return window->session()->probe().name; };
  const auto offset = [this] { return window->session()->probe().offset.by; };
  act("swap_bodies");
  ASSERT_TRUE(wait_until([&] { return probe().find("long") != std::string::npos; }));
  act("bodies");
  ASSERT_TRUE(wait_until([&] { return offset() == -1e-3; }));
  act("undo");
  act("undo");
  EXPECT_TRUE(wait_until([&] { return probe().find("cube") != std::string::npos; }));
  EXPECT_EQ(document().stack().index(), 0);
  EXPECT_EQ(offset(), 0);
  EXPECT_FALSE(document().modified());
  act("redo");
  act("redo");
  EXPECT_TRUE(wait_until([&] { return offset() == -1e-3; }));
  EXPECT_EQ(document().stack().index(), 2);
  EXPECT_NE(probe().find("long"), std::string::npos);
}

/// After an undo, a change takes the place of the step whose bodies are still on show, so there is
/// no way back to them where the setting up of those undone to is given up.
TEST_F(DocumentCommandsTest, changed_since_the_undo_the_bodies_are_set_up_all_the_same) {
  folder.write("long.off", cube(0.2));
  folder.write("two.sonde.json", R"({"probe": {"mesh": "cube.off", "pose": [0.3, 0, 0, 1, 0, 0, 0]},
      "fixed": {"mesh": "long.off"}})");
  open({path("two.sonde.json")});
  const auto probe = [this] { return window->session()->probe().name; };
  act("swap_bodies");
  ASSERT_TRUE(wait_until([&] { return probe().find("long") != std::string::npos; }));
  window->prompts().ask_leaving = [](const QString&) { return Leaving::discard; };
  act("undo");
  const Pose there{Quat::Identity(), Vec3(0.3, 0.1, 0.2)};
  window->documents().place(there, "there");
  window->documents().open({path("missing.off"), path("cube.off")}, 1.0);
  ASSERT_TRUE(wait_until([&] { return probe().find("cube") != std::string::npos; }));
  ASSERT_EQ(complaints.size(), 1u);
  EXPECT_TRUE(complaints[0].contains("missing.off")) << complaints[0].toStdString();
  EXPECT_TRUE(comes_to(there));
  EXPECT_EQ(document().stack().index(), 1);
  EXPECT_EQ(document().stack().count(), 1);
}

TEST_F(DocumentCommandsTest, a_pose_is_copied_as_a_matrix_that_numpy_reads_and_pasted_from_it) {
  window->documents().place({Quat::Identity(), Vec3(0.3, 0.1, 0.2)}, "there");
  const Pose copied = pose();
  act("copy_matrix");
  const QString text = QApplication::clipboard()->text();
  EXPECT_EQ(text.count('['), 5) << "four rows in a list";
  window->documents().place({Quat::Identity(), Vec3(0.4, 0, 0)}, "elsewhere");
  act("paste_pose");
  EXPECT_TRUE(comes_to(copied)) << text.toStdString();
}

TEST_F(DocumentCommandsTest, places_in_quick_succession_are_one_step_where_they_may_merge) {
  const Pose before = pose();
  for (const double x : {0.3, 0.31, 0.32})
    window->documents().place({Quat::Identity(), Vec3(x, 0, 0)}, "slid", true);
  EXPECT_EQ(document().stack().count(), 1);
  for (const double x : {0.33, 0.34})
    window->documents().place({Quat::Identity(), Vec3(x, 0, 0)}, "typed");
  EXPECT_EQ(document().stack().count(), 3);
  for (int i = 0; i < 3; ++i) act("undo");
  EXPECT_TRUE(comes_to(before));
}

}  // namespace
}  // namespace sonde::ui::test
