// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/scrolled.hpp"

#include <gtest/gtest.h>

#include <QDockWidget>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QTest>
#include <QVBoxLayout>

#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

/// A dock of 300 × 400 pixels with something so high in it.
struct FilledDock {
  explicit FilledDock(int height) : column(scrolled(dock)) {
    auto* group = new QLabel(column.content);
    group->setFixedHeight(height);
    column.layout->addWidget(group);
    dock.resize(300, 400);
    dock.show();
  }
  QDockWidget dock;
  Scrolled column;
};

TEST(ScrolledTest, a_column_that_is_too_long_scrolls_to_its_end) {
  need_application();
  FilledDock filled(2000);
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&filled.dock));
  EXPECT_EQ(filled.dock.widget(), filled.column.scroll);
  const QScrollBar* bar = filled.column.scroll->verticalScrollBar();
  EXPECT_TRUE(bar->isVisible());
  EXPECT_EQ(bar->maximum() + filled.column.scroll->viewport()->height(),
            filled.column.content->height());
  EXPECT_GE(filled.column.content->height(), 2000);
  EXPECT_FALSE(filled.column.scroll->horizontalScrollBar()->isVisible());
}

TEST(ScrolledTest, a_short_column_is_as_wide_as_the_dock_and_has_no_bar) {
  need_application();
  FilledDock filled(50);
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&filled.dock));
  EXPECT_FALSE(filled.column.scroll->verticalScrollBar()->isVisible());
  EXPECT_EQ(filled.column.content->width(), filled.column.scroll->width());
  filled.dock.resize(500, 400);
  QApplication::processEvents();
  EXPECT_EQ(filled.column.content->width(), filled.column.scroll->width());
  EXPECT_GT(filled.column.content->width(), 400);
}

}  // namespace
}  // namespace sonde::ui::test
