// SPDX-License-Identifier: GPL-3.0-or-later
// The document in the window: what changes it, undone, saved, left.

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QTest>
#include <QToolButton>
#include <QUrl>
#include <csignal>

#include "tests/ui/document/document_fixture.hpp"
#include "ui/document/pose_text.hpp"
#include "ui/document/recent_files.hpp"
#include "ui/shell/start_page.hpp"

namespace sonde::ui::test {
namespace {

TEST_F(DocumentTest, a_drag_is_one_step_and_comes_back) {
  const Pose before = pose();
  drag(Qt::LeftButton, {500, 400}, {40, -25});
  const Pose after = pose();
  ASSERT_GT((after.p - before.p).norm(), 1e-4);
  EXPECT_EQ(document().stack().count(), 1);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(comes_to(before));
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(comes_to(after));
  EXPECT_FALSE(document().modified()) << "where the probe is, is no part of the file";
}

TEST_F(DocumentTest, a_drag_that_moves_nothing_is_no_step) {
  drag(Qt::LeftButton, {500, 400}, {0, 0});
  drag(Qt::RightButton, {500, 400}, {30, 0});
  EXPECT_EQ(document().stack().count(), 0);
}

TEST_F(DocumentTest, keys_held_down_are_one_step) {
  const Pose before = pose();
  for (int i = 0; i < 4; ++i) key(Qt::Key_Right);
  EXPECT_EQ(document().stack().count(), 1);
  act("undo");
  EXPECT_TRUE(comes_to(before));
}

TEST_F(DocumentTest, reset_can_be_undone) {
  drag(Qt::LeftButton, {500, 400}, {60, 0});
  const Pose dragged = pose();
  key(Qt::Key_R);
  EXPECT_TRUE(comes_to(window->session()->loaded().start));
  act("undo");
  EXPECT_TRUE(comes_to(dragged));
}

TEST_F(DocumentTest, gains_poses_and_starts_are_undone_in_their_order) {
  const Pose start = pose();
  drag(Qt::LeftButton, {500, 400}, {40, 0});
  const Pose dragged = pose();
  type("k_value", "700");
  act("start_from_here");
  EXPECT_TRUE(document().modified());
  EXPECT_LT((window->session()->loaded().start.p - dragged.p).norm(), 1e-12);
  act("undo");
  EXPECT_EQ(window->session()->loaded().start.p, start.p);
  EXPECT_EQ(window->session()->coupling().k, 700);
  act("undo");
  EXPECT_EQ(window->session()->coupling().k, 500);
  EXPECT_FALSE(document().modified()) << "as it was opened, by value";
  act("undo");
  EXPECT_TRUE(comes_to(start));
  for (int i = 0; i < 3; ++i) act("redo");
  EXPECT_TRUE(comes_to(dragged));
  EXPECT_EQ(window->session()->coupling().k, 700);
  EXPECT_LT((window->session()->loaded().start.p - dragged.p).norm(), 1e-12);
}

TEST_F(DocumentTest, it_is_saved_and_reads_the_same) {
  type("k_value", "650");
  drag(Qt::LeftButton, {500, 400}, {40, 10});
  act("start_from_here");
  EXPECT_TRUE(window->isWindowModified());
  key(Qt::Key_S, Qt::ControlModifier);
  EXPECT_FALSE(window->isWindowModified());
  EXPECT_TRUE(complaints.empty());
  const Scene saved = read_scene(scene);
  EXPECT_EQ(saved.coupling.k, 650);
  EXPECT_EQ(relative_pose(saved).p, window->session()->loaded().start.p);
  EXPECT_EQ(saved.probe.mesh, folder / "cube.off");
  wait(900);  // longer than the watch waits for a file to rest
  EXPECT_EQ(opened, 1) << "what we write ourselves is not read again";
  act("undo");
  EXPECT_TRUE(document().modified()) << "one step back is not what the file holds";
}

TEST_F(DocumentTest, saved_as_another_it_finds_its_meshes_and_is_remembered) {
  std::filesystem::create_directories(folder / "sub");
  window->prompts().ask_save = [this](const QString&) { return path("sub/copy.sonde.json"); };
  act("save_as");
  ASSERT_TRUE(complaints.empty()) << complaints[0].toStdString();
  EXPECT_EQ(read_scene(folder / "sub/copy.sonde.json").probe.mesh, folder / "cube.off");
  EXPECT_TRUE(window->windowTitle().startsWith("copy")) << window->windowTitle().toStdString();
  ASSERT_GE(recent_files().size(), 2u);
  EXPECT_EQ(recent_files()[0], QStringList(path("sub/copy.sonde.json")));
  EXPECT_EQ(recent_files()[1], QStringList(QString::fromStdString(scene.string())));
  auto* recent = window->findChild<QMenu*>("recent");
  emit recent->aboutToShow();
  ASSERT_EQ(recent->actions().size(), 2);
  const int before = opened;
  recent->actions()[1]->trigger();
  EXPECT_TRUE(wait_until([&] { return opened > before; }));
  EXPECT_TRUE(window->windowTitle().startsWith("cubes"));
}

TEST_F(DocumentTest, where_it_cannot_be_saved_it_says_why_and_stays_as_it_was) {
  const std::string before = sonde::test::text_of(scene);
  type("k_value", "650");
  window->prompts().ask_save = [this](const QString&) { return path("no/such/x.sonde.json"); };
  act("save_as");
  ASSERT_EQ(complaints.size(), 1u);
  EXPECT_TRUE(complaints[0].contains("no/such/x.sonde.json")) << complaints[0].toStdString();
  rlimit limit{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &limit), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit full{100, limit.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &full), 0);
  act("save");
  setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, handler);
  ASSERT_EQ(complaints.size(), 2u);
  EXPECT_TRUE(complaints[1].contains("cubes.sonde.json")) << complaints[1].toStdString();
  EXPECT_EQ(sonde::test::text_of(scene), before) << "nothing half-written";
  EXPECT_TRUE(document().modified());
  EXPECT_TRUE(window->windowTitle().startsWith("cubes"));
}

TEST_F(DocumentTest, what_is_not_saved_is_asked_about_before_it_is_left) {
  type("k_value", "650");
  leaving = Leaving::stay;
  window->close();
  EXPECT_TRUE(window->isVisible());
  window->open({path("cubes.sonde.json")});
  act("new");
  EXPECT_EQ(asked_to_leave, 3);
  EXPECT_EQ(opened, 1);
  EXPECT_EQ(window->session()->coupling().k, 650);
  leaving = Leaving::save;
  window->close();
  EXPECT_FALSE(window->isVisible());
  EXPECT_EQ(read_scene(scene).coupling.k, 650);
}

TEST_F(DocumentTest, what_is_saved_is_left_without_a_question) {
  drag(Qt::LeftButton, {500, 400}, {40, 10});
  window->close();
  EXPECT_EQ(asked_to_leave, 0);
  EXPECT_FALSE(window->isVisible());
}

TEST_F(DocumentTest, swapped_bodies_stay_where_they_were_and_come_back) {
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

TEST_F(DocumentTest, undone_before_it_was_on_show_it_never_is) {
  act("swap_bodies");
  ASSERT_TRUE(wait_until([&] { return document().stack().count() == 1; }));
  Session* const swapped = window->session();
  act("undo");
  act("redo");
  wait(300);
  EXPECT_EQ(window->session(), swapped);
  EXPECT_EQ(document().stack().index(), 1);
}

TEST_F(DocumentTest, units_change_and_come_back) {
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

TEST_F(DocumentTest, an_allowance_is_set_saved_and_undone) {
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

TEST_F(DocumentTest, a_pose_is_copied_and_pasted_as_text) {
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

TEST_F(DocumentTest, numbers_place_the_probe) {
  auto* dock = window->findChild<QDockWidget*>("pose_panel");
  dock->show();
  dock->raise();
  const Pose before = pose();
  window->findChild<QComboBox*>("pose_unit")->setCurrentText("mm");
  type("pose_2", "150");
  Pose wanted = before;
  wanted.p.z() = 0.15;
  EXPECT_TRUE(comes_to(wanted));
  EXPECT_EQ(QApplication::focusWidget(), window->viewport().canvas());
  type("pose_5", "90");
  wanted.q = Quat(Eigen::AngleAxisd(std::acos(0.0), Vec3::UnitZ()));
  EXPECT_TRUE(comes_to(wanted));
  window->findChild<QComboBox*>("pose_turn")->setCurrentIndex(1);
  auto* angle = window->findChild<QLineEdit*>("pose_6");
  EXPECT_TRUE(wait_until([&] { return angle->text() == "90"; })) << angle->text().toStdString();
  type("pose_6", "1e999");
  EXPECT_TRUE(comes_to(wanted));
  act("undo");
  act("undo");
  EXPECT_TRUE(comes_to(before));
}

class DropOnDocument : public DocumentTest {
 protected:
  void drop(const QStringList& files) {
    QMimeData data;
    QList<QUrl> urls;
    for (const QString& file : files) urls.push_back(QUrl::fromLocalFile(file));
    data.setUrls(urls);
    QDragEnterEvent enter({200, 200}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window.get(), &enter);
    QDropEvent drop({200, 200}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window.get(), &drop);
  }
};

TEST_F(DropOnDocument, one_mesh_takes_the_place_of_a_body) {
  folder.write("other.off", cube(0.05));
  window->prompts().ask_role = [](const QString&, int) { return std::optional(Role::fixed); };
  drop({path("other.off")});
  ASSERT_TRUE(wait_until([this] { return document().stack().count() == 1; }));
  EXPECT_NEAR(window->session()->fixed().mass.radius, 0.025 * std::sqrt(3.0), 1e-9);
  EXPECT_EQ(opened, 2);
  folder.write("bad.off", "OFF\n1 1 0\n0 0\n");
  drop({path("bad.off")});
  ASSERT_TRUE(wait_until([this] { return failed == 1; }));
  EXPECT_EQ(document().stack().count(), 1) << "what cannot be read is no step";
  act("undo");
  EXPECT_TRUE(wait_until(
      [this] { return std::abs(window->session()->fixed().mass.radius - 0.0866) < 1e-3; }));
}

TEST_F(DocumentTest, new_leads_to_the_start_page_and_that_to_a_scene) {
  act("new");
  EXPECT_FALSE(window->session());
  auto* page = window->findChild<StartPage*>("start_page");
  ASSERT_TRUE(page->isVisible());
  EXPECT_FALSE(window->findChild<QAction*>("undo")->isEnabled());
  for (const char* dead : {"reset", "pause", "save", "swap_bodies", "bodies", "copy_pose", "fit"})
    act(dead);
  auto* tile = window->findChild<QToolButton*>("gallery_linked-tori");
  ASSERT_TRUE(tile);
  EXPECT_FALSE(tile->icon().isNull());
  QTest::mouseClick(tile, Qt::LeftButton);
  ASSERT_TRUE(wait_until([this] { return opened == 2; }));
  EXPECT_FALSE(page->isVisible());
  EXPECT_TRUE(window->windowTitle().startsWith("linked-tori"));
}

}  // namespace
}  // namespace sonde::ui::test
