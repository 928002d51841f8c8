// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/log_panel.hpp"

#include <gtest/gtest.h>

#include <QClipboard>
#include <QPushButton>

#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

TEST(LogPanelTest, keeps_each_message_once_in_a_row_and_copies_all) {
  need_application();
  LogPanel log;
  for (const char* message : {"one", "one", "", "two", "one"}) log.add(message);
  const QStringList lines = log.text().split('\n');
  ASSERT_EQ(lines.size(), 3);
  EXPECT_TRUE(lines[0].endsWith("  one"));
  EXPECT_TRUE(lines[1].endsWith("  two"));
  EXPECT_TRUE(QRegExp("\\d\\d:\\d\\d:\\d\\d  .*").exactMatch(lines[2])) << "with the time of day";
  log.findChild<QPushButton*>("log_copy")->click();
  EXPECT_EQ(QApplication::clipboard()->text(), log.text());
}

TEST(LogPanelTest, ten_thousand_messages_leave_the_last_ones) {
  need_application();
  LogPanel log;
  for (int i = 0; i < 10'000; ++i) log.add(QString::number(i));
  const QStringList lines = log.text().split('\n');
  EXPECT_EQ(lines.size(), 2000);
  EXPECT_TRUE(lines.back().endsWith("9999"));
}

}  // namespace
}  // namespace sonde::ui::test
