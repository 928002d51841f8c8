// SPDX-License-Identifier: GPL-3.0-or-later
// The window as a whole: its size, its menus, its keys and its messages.

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScreen>
#include <QTest>
#include <QTimer>

#include "tests/ui/window_fixture.hpp"
#include "ui/actions/bodies_dialog.hpp"
#include "ui/panels/typed_value.hpp"

namespace sonde::ui::test {
namespace {

TEST_F(WindowTest, the_first_window_leaves_room_on_the_screen) {
  MainWindow first;
  first.show();
  ASSERT_TRUE(wait_until([&] { return first.isVisible(); }));
  const QSize room = QApplication::primaryScreen()->availableSize();
  // A frame and a desktop's bar take some 60 pixels together.
  EXPECT_LE(first.height(), room.height() - 60);
  EXPECT_LE(first.width(), room.width());
  EXPECT_LE(first.minimumSizeHint().width(), 800);
}

TEST_F(WindowTest, a_dock_that_was_closed_is_in_the_view_menu) {
  const auto* of_docks = find<QMenu>("docks_menu");
  ASSERT_TRUE(of_docks);
  const auto docks = window->findChildren<QDockWidget*>();
  EXPECT_GE(docks.size(), 8);
  for (QDockWidget* dock : docks) {
    dock->close();
    ASSERT_TRUE(of_docks->actions().contains(dock->toggleViewAction()))
        << dock->objectName().toStdString();
    dock->toggleViewAction()->trigger();
    EXPECT_FALSE(dock->isHidden());
  }
}

class KeysTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (HasFatalFailure()) return;
    open_cubes();
    activate();
  }
};

TEST_F(KeysTest, letters_work_while_a_value_is_typed_and_after) {
  auto* typed = window->findChild<TypedValue*>("k_value");
  auto* trail = window->findChild<QAction*>("trail");
  typed->setFocus();
  typed->selectAll();
  QTest::keyClicks(typed, "2e2");
  QTest::keyClick(typed, Qt::Key_T);
  EXPECT_TRUE(trail->isChecked());
  QTest::keyClick(typed, Qt::Key_Return);
  EXPECT_EQ(window->session()->coupling().k, 200) << "a letter of a number is not a command";
  ASSERT_EQ(QApplication::focusWidget(), window->viewport().canvas());
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_T);
  EXPECT_FALSE(trail->isChecked());
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_5);
  EXPECT_TRUE(window->viewport().shown(Layer::nearest));
}

TEST_F(KeysTest, the_list_of_keys_has_each_once) {
  QString text;
  QTimer::singleShot(0, window.get(), [&] {
    QWidget* box = QApplication::activeModalWidget();
    ASSERT_TRUE(box);
    text = box->findChild<QLabel*>("keys_table")->text();
    box->close();
  });
  act("keys");
  QStringList keys;
  for (const QString& row : text.split("<b>").mid(1)) keys << row.section("</b>", 0, 0);
  EXPECT_GT(keys.size(), 20);
  EXPECT_EQ(keys.removeDuplicates(), 0) << keys.join(", ").toStdString();
}

TEST_F(WindowTest, messages_are_kept_and_can_be_copied) {
  open_cubes();
  window->set_force(false);
  auto* lines = window->findChild<QPlainTextEdit*>("log_lines");
  ASSERT_TRUE(lines);
  EXPECT_TRUE(wait_until([&] { return lines->toPlainText().contains("no force"); }));
  EXPECT_FALSE(window->save_picture(path("no/such/folder.png")));
  open({path("no-such.sonde.json")});
  window->findChild<QPushButton*>("log_copy")->click();
  const QString copied = QApplication::clipboard()->text();
  for (const char* kept : {"Opened cubes", "closed", "folder.png", "no-such.sonde.json"})
    EXPECT_TRUE(copied.contains(kept)) << kept << "\n" << copied.toStdString();
}

TEST_F(WindowTest, both_sizes_in_the_question_for_the_unit_are_in_one_unit) {
  MeshPair pair;
  pair.probe_size = Vec3(0.5, 0.5, 0.5);
  pair.fixed_size = Vec3(5000, 5000, 5000);
  const BodiesDialog dialog(pair, same_unit(pair, 1), window.get());
  const QString probe = dialog.findChild<QLabel*>("probe_size")->text();
  const QString fixed = dialog.findChild<QLabel*>("fixed_size")->text();
  EXPECT_EQ(probe.section(' ', -1), fixed.section(' ', -1));
}

TEST_F(WindowTest, the_trail_shows_where_the_probe_has_been) {
  open_cubes();
  act("trail");
  Pose pose = window->session()->device_pose();
  for (int i = 0; i < 20; ++i) {
    pose.p.z() += 0.004;
    window->set_device_pose(pose);
    wait(20);
  }
  window->set_paused(true);
  settle();
  const QImage with = picture();
  act("trail");
  EXPECT_GT(pixels_between(with, picture()), 60);
}

TEST_F(WindowTest, frames_count_while_nothing_moves) {
  open_cubes();
  window->set_paused(true);
  EXPECT_TRUE(wait_until([this] { return window->frames_per_second() > 10; }));
}

}  // namespace
}  // namespace sonde::ui::test
