// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/manual.hpp"

#include <gtest/gtest.h>

#include <QAction>
#include <QDir>
#include <QDirIterator>
#include <QLineEdit>
#include <QTest>
#include <QTextBlock>
#include <QTextBrowser>

#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

TEST_F(WindowTest, the_manual_opens_in_the_program_rendered) {
  auto* action = window->findChild<QAction*>("manual");
  action->trigger();
  auto* manual = window->findChild<QDialog*>("manual");
  ASSERT_TRUE(manual && manual->isVisible());
  const QString text = manual->findChild<QTextBrowser*>("manual_page")->toPlainText();
  EXPECT_TRUE(text.contains("Five-minute tour"));
  EXPECT_FALSE(text.contains("](")) << "a link, not its source";
  action->trigger();
  EXPECT_EQ(window->findChildren<QDialog*>("manual").size(), 1) << "one is enough";
}

TEST_F(WindowTest, the_manual_is_searched_through_all_its_pages) {
  Manual manual(QStringLiteral(SONDE_RESOURCES "/docs"), window.get());
  manual.show();
  // On one page alone: that of the mouse and keys.
  auto* search = manual.findChild<QLineEdit*>("manual_search");
  QTest::keyClicks(search, "rolls it about the line of sight");
  QTest::keyClick(search, Qt::Key_Return);
  EXPECT_TRUE(manual.isVisible()) << "Enter searches, and does not close";
  EXPECT_EQ(manual.browser().source().fileName(), "controls.md");
  EXPECT_EQ(manual.browser().textCursor().selectedText(), "rolls it about the line of sight");
  EXPECT_FALSE(manual.find_next("no page has these words"));
}

TEST_F(WindowTest, a_link_to_a_heading_of_the_manual_leads_there) {
  Manual manual(QStringLiteral(SONDE_RESOURCES "/docs"), window.get());
  manual.show();
  manual.open_page("understand/measurements.md");
  emit manual.browser().anchorClicked(QUrl("../use/compare.md#studies-in-parts"));
  EXPECT_EQ(manual.browser().source().fileName(), "compare.md");
  EXPECT_EQ(manual.browser().textCursor().block().text(), "Studies in parts");
}

TEST_F(WindowTest, no_picture_of_the_manual_is_wider_than_its_window) {
  Manual manual(QStringLiteral(SONDE_RESOURCES "/docs"), window.get());
  manual.open_page("use/seeing.md");
  manual.show();
  const auto widest = [&] { return manual.browser().document()->idealWidth(); };
  for (const int width : {820, 560, 900}) {
    manual.resize(width, 640);
    EXPECT_TRUE(wait_until([&] {
      const int room = manual.browser().viewport()->width();
      return room > width / 2 && room < width && widest() <= room;
    })) << width
        << ": " << widest();
  }
}

TEST_F(WindowTest, every_page_of_the_manual_has_text) {
  Manual manual(QStringLiteral(SONDE_RESOURCES "/docs"), window.get());
  const QDir folder(QStringLiteral(SONDE_RESOURCES "/docs"));
  QDirIterator pages(folder.path(), {"*.md"}, QDir::Files, QDirIterator::Subdirectories);
  int seen = 0;
  for (; pages.hasNext(); ++seen) {
    const QString page = folder.relativeFilePath(pages.next());
    manual.open_page(page);
    EXPECT_GT(manual.browser().toPlainText().size(), 200) << page.toStdString();
  }
  EXPECT_GT(seen, 20) << "those in the folders use, understand and develop as well";
}

}  // namespace
}  // namespace sonde::ui::test
