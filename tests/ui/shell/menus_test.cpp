// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/menus.hpp"

#include <gtest/gtest.h>

#include <QAction>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QTest>
#include <QTimer>
#include <QToolBar>
#include <map>

#include "tests/ui/window_fixture.hpp"
#include "ui/actions/document_control.hpp"
#include "ui/document/recent_files.hpp"

namespace sonde::ui::test {
namespace {

class MenusTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (HasFatalFailure()) return;
    open_cubes();
    activate();
  }
  /// The menu of recent files, as it is when it opens.
  QStringList recent() {
    auto* menu = find<QMenu>("recent");
    emit menu->aboutToShow();
    QStringList out;
    for (const QAction* action : menu->actions()) out << action->text();
    return out;
  }
};

TEST_F(MenusTest, a_command_is_found_by_its_words) {
  ASSERT_FALSE(window->viewport().shown(Layer::trail));
  QTimer::singleShot(0, window.get(), [] {
    QWidget* palette = QApplication::activeModalWidget();
    ASSERT_TRUE(palette);
    auto* words = palette->findChild<QLineEdit*>("command_words");
    QTest::keyClicks(words, "trail vi");
    QTest::keyClick(words, Qt::Key_Return);
  });
  QTest::keyClick(window.get(), Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(wait_until([this] { return window->viewport().shown(Layer::trail); }));
}

TEST_F(MenusTest, every_command_of_a_menu_has_a_name_for_the_keyboard) {
  // Alt and a letter opens each menu; no two of the bar share one.
  QStringList letters;
  for (const QAction* menu : window->menuBar()->actions()) {
    const int at = menu->text().indexOf('&');
    ASSERT_GE(at, 0) << menu->text().toStdString();
    letters << menu->text().mid(at + 1, 1).toLower();
  }
  EXPECT_EQ(letters.removeDuplicates(), 0);
}

TEST_F(MenusTest, every_menu_fits_on_a_small_screen) {
  for (const QMenu* menu : window->findChildren<QMenu*>())
    EXPECT_LT(menu->sizeHint().height(), 700) << menu->title().toStdString();
}

TEST_F(MenusTest, no_key_is_of_two_commands) {
  std::map<QString, QString> of;
  for (const QAction* action : window->findChildren<QAction*>()) {
    const QString key = action->shortcut().toString();
    if (key.isEmpty()) continue;
    EXPECT_EQ(of.count(key), 0u) << key.toStdString() << ": " << action->text().toStdString()
                                 << " and " << of[key].toStdString();
    of[key] = action->text();
  }
  EXPECT_GT(of.size(), 40u);
}

TEST_F(MenusTest, recent_files_are_listed_as_they_are_named_and_open) {
  EXPECT_EQ(recent(), QStringList("cubes.sonde.json"));
  const QString other = path("nut&bolt.sonde.json");
  std::filesystem::copy_file(scene, other.toStdString());
  remember_recent({other});
  EXPECT_EQ(recent(), QStringList({"nut&&bolt.sonde.json", "cubes.sonde.json"}));
  find<QMenu>("recent")->actions()[0]->trigger();
  ASSERT_TRUE(wait_until([this] { return opened == 2 || failed > 0; }));
  EXPECT_EQ(window->documents().document().file(), other.toStdString());
}

TEST_F(MenusTest, without_any_the_menu_of_recent_files_says_so) {
  QSettings().remove("recent");
  EXPECT_EQ(recent(), QStringList("Nothing yet"));
  EXPECT_FALSE(find<QMenu>("recent")->actions()[0]->isEnabled());
}

TEST_F(MenusTest, a_layer_that_is_toggled_is_shown_or_not) {
  const std::pair<const char*, Layer> layers[] = {{"show_ghost", Layer::ghost},
                                                  {"show_screw", Layer::screw},
                                                  {"show_contacts", Layer::contacts},
                                                  {"show_wrench", Layer::wrench},
                                                  {"show_nearest", Layer::nearest},
                                                  {"show_straight", Layer::straight},
                                                  {"show_bound", Layer::bound},
                                                  {"show_clearance", Layer::clearance},
                                                  {"show_stiffness", Layer::stiffness},
                                                  {"show_defects", Layer::defects},
                                                  {"show_mended", Layer::mended},
                                                  {"show_handles", Layer::handles},
                                                  {"show_hint", Layer::hint},
                                                  {"show_grid", Layer::grid},
                                                  {"trail", Layer::trail}};
  for (const auto& [name, layer] : layers) {
    const bool before = window->viewport().shown(layer);
    EXPECT_EQ(find<QAction>(name)->isChecked(), before) << name;
    act(name);
    EXPECT_EQ(window->viewport().shown(layer), !before) << name;
    act(name);
    EXPECT_EQ(window->viewport().shown(layer), before) << name;
  }
}

TEST_F(MenusTest, pause_and_force_follow_what_happens_elsewhere) {
  auto *pause = find<QAction>("pause"), *force = find<QAction>("force");
  window->set_paused(true);
  EXPECT_TRUE(pause->isChecked());
  pause->trigger();
  EXPECT_FALSE(window->session()->paused());
  window->set_force(false);
  EXPECT_FALSE(force->isChecked());
  force->trigger();
  EXPECT_TRUE(window->session()->force_on());
}

TEST_F(MenusTest, the_bar_has_what_is_used_most) {
  QStringList names;
  for (const QAction* action : find<QToolBar>("actions_bar")->actions())
    if (!action->isSeparator()) names << action->objectName();
  EXPECT_EQ(names, QStringList({"open_scene", "open_meshes", "screenshot", "reset", "pause",
                                "force", "fit", "trail", "mended_notice"}));
}

}  // namespace
}  // namespace sonde::ui::test
