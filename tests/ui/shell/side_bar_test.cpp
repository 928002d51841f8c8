// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/side_bar.hpp"

#include <gtest/gtest.h>

#include <QDockWidget>
#include <QMainWindow>
#include <QTest>
#include <QToolButton>

#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

/// A window with two docks at its left side, of which the first is open, one at its right, and a
/// tab for each.
class SideBarTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { need_application(); }  // before the window is made
  void SetUp() override {
    window.setCentralWidget(new QWidget);
    bar = new SideBar(Qt::LeftToolBarArea, "Sides", "sides_bar", &window);
    window.addToolBar(Qt::LeftToolBarArea, bar);
    first = add("first", Qt::LeftDockWidgetArea);
    second = add("second", Qt::LeftDockWidgetArea);
    right = add("right", Qt::RightDockWidgetArea);
    second->hide();
    for (QDockWidget* dock : {first, second, right}) bar->add(*dock);
    window.resize(1200, 700);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  }
  QDockWidget* add(const char* name, Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(name, &window);
    dock->setObjectName(name);
    dock->setWidget(new QWidget(dock));
    window.addDockWidget(area, dock);
    return dock;
  }
  QToolButton& tab(const char* name) const {
    return *bar->findChild<QToolButton*>(QStringLiteral("tab_") + name);
  }
  void click(const char* name) { QTest::mouseClick(&tab(name), Qt::LeftButton); }

  QMainWindow window;
  SideBar* bar = nullptr;
  QDockWidget *first = nullptr, *second = nullptr, *right = nullptr;
};

TEST_F(SideBarTest, has_a_tab_for_each_dock_which_says_whether_it_is_open) {
  EXPECT_EQ(bar->docks(), (std::vector<QDockWidget*>{first, second, right}));
  EXPECT_EQ(tab("second").text(), "second");
  EXPECT_TRUE(tab("first").isChecked());
  EXPECT_FALSE(tab("second").isChecked());
  EXPECT_TRUE(tab("right").isChecked());
}

TEST_F(SideBarTest, a_tab_opens_its_dock_in_place_of_the_one_at_that_side) {
  click("second");
  EXPECT_TRUE(second->isVisible());
  EXPECT_FALSE(first->isVisible());
  EXPECT_FALSE(tab("first").isChecked());
  EXPECT_TRUE(right->isVisible()) << "the other side stays";
}

TEST_F(SideBarTest, the_tab_of_the_open_one_folds_it_away) {
  click("first");
  EXPECT_FALSE(first->isVisible());
  EXPECT_FALSE(second->isVisible());
  click("first");
  EXPECT_TRUE(first->isVisible());
}

TEST_F(SideBarTest, a_tab_follows_a_dock_that_is_closed_or_opened_elsewhere) {
  first->close();
  EXPECT_FALSE(tab("first").isChecked());
  second->show();
  EXPECT_TRUE(tab("second").isChecked());
  first->toggleViewAction()->trigger();
  EXPECT_TRUE(tab("first").isChecked());
  EXPECT_FALSE(second->isVisible());
}

TEST_F(SideBarTest, a_dock_that_floats_stays_and_takes_no_place) {
  first->setFloating(true);
  click("second");
  EXPECT_TRUE(first->isVisible());
  EXPECT_TRUE(second->isVisible());
  click("first");
  click("first");
  EXPECT_TRUE(second->isVisible()) << "nor does it fold another away";
}

TEST_F(SideBarTest, the_next_dock_is_as_wide_as_the_one_before_and_the_other_side_stays) {
  bar->hold_widths(false);
  window.resizeDocks({first, right}, {410, 350}, Qt::Horizontal);
  ASSERT_TRUE(wait_until([&] { return first->width() == 410 && right->width() == 350; }));
  click("second");
  EXPECT_TRUE(wait_until([&] { return second->width() == 410; })) << second->width();
  EXPECT_EQ(right->width(), 350);
}

TEST_F(SideBarTest, a_dock_below_the_view_does_not_make_the_next_one_at_a_side_as_wide) {
  QDockWidget* below = add("below", Qt::BottomDockWidgetArea);
  bar->add(*below);
  bar->hold_widths(false);
  window.resizeDocks({first, right}, {310, 350}, Qt::Horizontal);
  ASSERT_TRUE(wait_until([&] { return first->width() == 310 && below->width() > 400; }));
  click("first");
  ASSERT_TRUE(wait_until([&] { return first->isHidden(); }));
  click("below");
  ASSERT_TRUE(wait_until([&] { return below->isHidden(); }));
  click("first");
  EXPECT_TRUE(wait_until([&] { return first->isVisible() && first->width() == 310; }))
      << first->width();
}

/// What the user sees while the keyboard is elsewhere.
TEST_F(SideBarTest, a_click_leaves_the_keyboard_where_it_is) {
  window.activateWindow();
  ASSERT_TRUE(wait_until([&] { return window.isActiveWindow(); }));
  window.centralWidget()->setFocusPolicy(Qt::StrongFocus);
  window.centralWidget()->setFocus();
  click("first");
  EXPECT_EQ(QApplication::focusWidget(), window.centralWidget());
}

class SideBarInWindow : public WindowTest {};

TEST_F(SideBarInWindow, the_names_on_the_tabs_can_be_read_on_a_small_screen) {
  open_cubes();
  window->resize(1152, 720);
  settle();
  int tabs = 0;
  for (const QToolButton* tab : window->findChildren<QToolButton*>()) {
    if (!tab->objectName().startsWith("tab_")) continue;
    EXPECT_TRUE(tab->isVisible()) << tab->text().toStdString();
    EXPECT_GE(tab->height(), tab->fontMetrics().horizontalAdvance(tab->text()) + 8)
        << tab->text().toStdString();
    ++tabs;
  }
  EXPECT_GE(tabs, 12);
}

}  // namespace
}  // namespace sonde::ui::test
