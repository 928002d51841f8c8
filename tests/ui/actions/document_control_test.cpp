// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/document_control.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QTest>
#include <QToolButton>
#include <cmath>
#include <csignal>
#include <filesystem>

#include "tests/ui/document/document_fixture.hpp"
#include "tests/ui/drop_files.hpp"
#include "ui/document/recent_files.hpp"
#include "ui/shell/start_page.hpp"

namespace sonde::ui::test {
namespace {

class DocumentControlTest : public DocumentTest {};

TEST_F(DocumentControlTest, it_is_saved_and_reads_the_same) {
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

TEST_F(DocumentControlTest, saved_as_another_it_finds_its_meshes_and_is_remembered) {
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

TEST_F(DocumentControlTest, where_it_cannot_be_saved_it_says_why_and_stays_as_it_was) {
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

TEST_F(DocumentControlTest, what_is_not_saved_is_asked_about_before_it_is_left) {
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

TEST_F(DocumentControlTest, what_is_saved_is_left_without_a_question) {
  drag(Qt::LeftButton, {500, 400}, {40, 10});
  window->close();
  EXPECT_EQ(asked_to_leave, 0);
  EXPECT_FALSE(window->isVisible());
}

TEST_F(DocumentControlTest, new_leads_to_the_start_page_and_that_to_a_scene) {
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
  // A page that was just presented is laid out by the event loop, before anybody can click.
  ASSERT_TRUE(wait_until([tile] { return tile->height() > tile->iconSize().height(); }));
  QTest::mouseClick(tile, Qt::LeftButton);
  ASSERT_TRUE(wait_until([this] { return opened == 2; }))
      << failed << " failed, " << (complaints.empty() ? "" : complaints[0].toStdString());
  EXPECT_FALSE(page->isVisible());
  EXPECT_TRUE(window->windowTitle().startsWith("linked-tori"));
}

/// Another document was opened over one with steps, and then what was to be opened is not there.
TEST_F(DocumentControlTest, what_cannot_be_opened_leaves_the_session_as_it_is) {
  window->prompts().ask_leaving = [](const QString&) { return Leaving::discard; };
  window->documents().place({Quat::Identity(), Vec3(0.3, 0.1, 0.2)}, "there");
  open({QString::fromStdString(scene.string())});
  Session* const session = window->session();
  QStringList said;
  QObject::connect(&window->documents(), &DocumentControl::say,
                   [&](const QString& what) { said << what; });
  window->documents().open({path("missing.off"), path("cube.off")}, 1.0);
  ASSERT_TRUE(wait_until([this] { return !complaints.empty(); }));
  wait(300);
  EXPECT_EQ(window->session(), session);
  EXPECT_TRUE(said.isEmpty()) << said.join('\n').toStdString();
}

class DropOnDocument : public DocumentTest {
 protected:
  void drop(const QStringList& files) { drop_files(*window, files); }
};

TEST_F(DropOnDocument, of_one_mesh_on_the_start_page_it_is_read_before_the_other_is_asked_for) {
  act("new");
  int asked = 0;
  window->prompts().ask_meshes = [&](const QString&) {
    ++asked;
    return std::optional<std::pair<QString, QString>>();
  };
  folder.write("bad.stl", "solid nothing\n");
  const int before = failed;
  drop({path("bad.stl")});
  ASSERT_TRUE(wait_until([&] { return failed > before; }));
  EXPECT_EQ(asked, 0);
  drop({path("cube.off")});
  EXPECT_TRUE(wait_until([&] { return asked == 1; }));
}

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

}  // namespace
}  // namespace sonde::ui::test
