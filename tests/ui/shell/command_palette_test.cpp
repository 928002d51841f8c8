// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/command_palette.hpp"

#include <gtest/gtest.h>

#include <QAction>
#include <QLineEdit>
#include <QListWidget>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QTest>
#include <QTimer>

#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

/// A window with menus of its own.
class CommandPaletteTest : public testing::Test {
 protected:
  void SetUp() override {
    need_application();
    window = std::make_unique<QMainWindow>();
    QMenu* file = window->menuBar()->addMenu("&File");
    add(*file, "&Open…")->setShortcut(QKeySequence("Ctrl+O"));
    QMenu* exports = file->addMenu("&Export");
    add(*exports, "&Picture…");
    add(*exports, "Pictures of the &recording…");
    file->addSeparator();
    add(*file, "&Save")->setEnabled(false);
    add(*file, "nut && bolt.off");
    QMenu* view = window->menuBar()->addMenu("&View");
    QAction* trail = add(*view, "&Trail");
    trail->setCheckable(true);
    trail->setChecked(true);
    palette = std::make_unique<CommandPalette>(*window->menuBar(), window.get());
  }
  QAction* add(QMenu& menu, const QString& text) {
    QAction* action = menu.addAction(text);
    QObject::connect(action, &QAction::triggered, [this, text] { run << text; });
    return action;
  }
  QStringList offered() const {
    QStringList out;
    const auto* list = palette->findChild<QListWidget*>("commands_found");
    for (int i = 0; i < list->count(); ++i)
      if (!list->item(i)->isHidden()) out << list->item(i)->text();
    return out;
  }
  QLineEdit& words() const { return *palette->findChild<QLineEdit*>("command_words"); }

  std::unique_ptr<QMainWindow> window;
  std::unique_ptr<CommandPalette> palette;
  QStringList run;
};

TEST_F(CommandPaletteTest, lists_every_command_that_can_be_had_with_its_menus_and_key) {
  EXPECT_EQ(offered(), QStringList({"File › Open   (Ctrl+O)", "File › Export › Picture",
                                    "File › Export › Pictures of the recording",
                                    "File › nut & bolt.off", "✓ View › Trail"}));
}

TEST_F(CommandPaletteTest, finds_what_has_every_word_in_any_order_and_case) {
  words().setText("rec EXP");
  EXPECT_EQ(offered(), QStringList("File › Export › Pictures of the recording"));
  words().setText("picture");
  EXPECT_EQ(offered().size(), 2);
  words().setText("nut & bolt");
  EXPECT_EQ(offered(), QStringList("File › nut & bolt.off"));
  words().setText("  ");
  EXPECT_EQ(offered().size(), 5);
}

TEST_F(CommandPaletteTest, enter_takes_the_first_that_is_found) {
  words().setText("recording");
  QTest::keyClick(&words(), Qt::Key_Return);
  ASSERT_TRUE(palette->chosen());
  EXPECT_EQ(palette->chosen()->text(), "Pictures of the &recording…");
  EXPECT_EQ(palette->result(), QDialog::Accepted);
  EXPECT_TRUE(run.isEmpty()) << "it runs once the palette is closed";
}

TEST_F(CommandPaletteTest, arrows_choose_among_what_is_found_while_words_are_typed) {
  palette->show();
  words().setFocus();
  words().setText("picture");
  QTest::keyClick(&words(), Qt::Key_Down);
  QTest::keyClick(&words(), Qt::Key_Return);
  ASSERT_TRUE(palette->chosen());
  EXPECT_EQ(palette->chosen()->text(), "Pictures of the &recording…");
  EXPECT_EQ(words().text(), "picture");
}

TEST_F(CommandPaletteTest, where_nothing_is_found_enter_chooses_nothing) {
  palette->show();
  words().setText("no such command");
  EXPECT_TRUE(offered().isEmpty());
  QTest::keyClick(&words(), Qt::Key_Return);
  EXPECT_FALSE(palette->chosen());
  EXPECT_TRUE(palette->isVisible());
}

TEST_F(CommandPaletteTest, a_click_chooses) {
  palette->show();
  auto* list = palette->findChild<QListWidget*>("commands_found");
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                    list->visualItemRect(list->item(1)).center());
  ASSERT_TRUE(palette->chosen());
  EXPECT_EQ(palette->chosen()->text(), "&Picture…");
}

TEST_F(CommandPaletteTest, what_is_asked_for_runs_once_and_given_up_nothing_does) {
  const auto answer = [this](Qt::Key key) {
    QTimer::singleShot(0, window.get(), [key] {
      QWidget* asked = QApplication::activeModalWidget();
      ASSERT_TRUE(asked);
      auto* field = asked->findChild<QLineEdit*>("command_words");
      QTest::keyClicks(field, "open");
      QTest::keyClick(field, key);
      const bool waits = asked->isVisible();
      EXPECT_FALSE(waits);
      if (waits) static_cast<QDialog*>(asked)->reject();
    });
    find_command(*window->menuBar(), *window);
  };
  answer(Qt::Key_Escape);
  EXPECT_TRUE(run.isEmpty());
  answer(Qt::Key_Return);
  EXPECT_EQ(run, QStringList("&Open…"));
}

}  // namespace
}  // namespace sonde::ui::test
