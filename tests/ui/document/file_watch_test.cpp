// SPDX-License-Identifier: GPL-3.0-or-later
// Files of the open document that change on the disk.

#include <QPlainTextEdit>
#include <filesystem>

#include "tests/ui/document/document_fixture.hpp"

namespace sonde::ui::test {
namespace {

using FileWatchTest = DocumentTest;

TEST_F(FileWatchTest, a_scene_that_changes_on_the_disk_is_read_again) {
  drag(Qt::LeftButton, {500, 400}, {40, 10});
  const Pose here = pose();
  std::string text = sonde::test::text_of(scene);
  text.replace(text.find("500"), 3, "900");
  folder.write("new.json", text);
  std::filesystem::rename(folder / "new.json", scene);  // as editors do
  ASSERT_TRUE(wait_until([this] { return window->session()->coupling().k == 900; }));
  EXPECT_TRUE(comes_to(here)) << "the probe stays";
  folder.write("cubes.sonde.json", "{ half written");
  ASSERT_TRUE(wait_until([this] { return failed == 1; }));
  EXPECT_TRUE(complaints.back().contains("cubes.sonde.json"));
  EXPECT_EQ(window->session()->coupling().k, 900) << "what was open stays";
}

TEST_F(FileWatchTest, with_changes_that_are_not_saved_it_asks) {
  int asked = 0;
  bool answer = false;
  window->prompts().ask_reload = [&](const QString&) {
    ++asked;
    return answer;
  };
  type("k_value", "650");
  std::string text = sonde::test::text_of(scene);
  text.replace(text.find("500"), 3, "900");
  folder.write("cubes.sonde.json", text);
  ASSERT_TRUE(wait_until([&] { return asked == 1; }));
  EXPECT_EQ(window->session()->coupling().k, 650);
  answer = true;
  folder.write("cubes.sonde.json", text + "\n");
  ASSERT_TRUE(wait_until([this] { return window->session()->coupling().k == 900; }));
}

/// Another window saves while this one holds changes: it is told of, kept or overwritten as the
/// user says, and what is on the disk is whole at any time.
TEST_F(FileWatchTest, what_another_window_saves_is_not_overwritten_unasked) {
  const QString file = QString::fromStdString(scene.string());
  MainWindow other;
  other.open({file}, std::nullopt);
  ASSERT_TRUE(wait_until([&] { return other.shown().has_value(); }));
  const auto change_k = [](MainWindow& of, double k) {
    Content changed = of.documents().document().content();
    changed.scene.coupling.k = k;
    of.documents().document().change("k", changed);
  };
  const auto saved_k = [&] { return read_scene(scene).coupling.k; };
  int asked_to_reload = 0, asked_to_overwrite = 0;
  bool overwrite = false;
  window->prompts().ask_reload = [&](const QString&) { return ++asked_to_reload > 99; };
  window->prompts().ask_overwrite = [&](const QString&) {
    return ++asked_to_overwrite && overwrite;
  };
  change_k(*window, 650);
  change_k(other, 750);
  ASSERT_TRUE(other.documents().save());
  EXPECT_FALSE(window->documents().save()) << "it has not been told of yet";
  EXPECT_EQ(asked_to_overwrite, 1);
  EXPECT_EQ(saved_k(), 750);
  ASSERT_TRUE(wait_until([&] { return asked_to_reload == 1; }));
  EXPECT_TRUE(window->documents().save()) << "the user has been told, and keeps what is open";
  EXPECT_EQ(asked_to_overwrite, 1);
  EXPECT_EQ(saved_k(), 650);
  change_k(other, 800);
  other.prompts().ask_reload = [](const QString&) { return false; };
  other.prompts().ask_overwrite = [](const QString&) { return true; };
  ASSERT_TRUE(other.documents().save());
  change_k(*window, 600);
  overwrite = true;
  EXPECT_TRUE(window->documents().save());
  EXPECT_EQ(asked_to_overwrite, 2);
  EXPECT_EQ(saved_k(), 600);
}

TEST_F(FileWatchTest, a_mesh_that_changes_is_read_again_and_one_that_goes_is_named) {
  type("k_value", "650");
  folder.write("cube.off", cube(0.12));
  ASSERT_TRUE(wait_until([this] { return window->session()->probe().mass.radius > 0.1; }));
  EXPECT_EQ(window->session()->coupling().k, 650);
  EXPECT_TRUE(document().modified()) << "as before";
  std::filesystem::remove(folder / "cube.off");
  auto* lines = window->findChild<QPlainTextEdit*>("log_lines");
  EXPECT_TRUE(wait_until([&] { return lines->toPlainText().contains("no longer on the disk"); }));
  const std::uint64_t tick = shown().tick;
  EXPECT_TRUE(wait_until([&] { return shown().tick > tick + 10; })) << "what was open stays";
}

}  // namespace
}  // namespace sonde::ui::test
