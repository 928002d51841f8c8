// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/force_log.hpp"

#include <gtest/gtest.h>

#include <QStringList>

namespace sonde::ui {
namespace {

QStringList force_log_lines;

struct ForceLogTest : testing::Test {
  ForceLog log;
  QtMessageHandler before = qInstallMessageHandler(
      [](QtMsgType, const QMessageLogContext&, const QString& text) { force_log_lines << text; });

  ForceLogTest() { force_log_lines.clear(); }
  ~ForceLogTest() override { qInstallMessageHandler(before); }

  void add(double time, Withheld why, double force = 0) {
    Snapshot tick;
    tick.wrench.force.x() = force;
    tick.time = time;
    tick.hand.withheld = why;
    log.add(tick);
  }
};

TEST_F(ForceLogTest, a_fault_of_one_tick_is_in_the_log_and_stays_to_be_read) {
  add(1, Withheld::nothing);
  EXPECT_TRUE(log.recent(1).isEmpty());
  add(1.001, Withheld::stalled);
  add(1.002, Withheld::nothing);
  ASSERT_EQ(force_log_lines.size(), 2);
  EXPECT_TRUE(force_log_lines[0].contains(QString::fromUtf8(words(Withheld::stalled))));
  EXPECT_TRUE(force_log_lines[0].contains(QStringLiteral("1.001 s")));
  EXPECT_TRUE(log.recent(3).contains(QString::fromUtf8(words(Withheld::stalled))));
  EXPECT_TRUE(log.recent(30).isEmpty());
}

TEST_F(ForceLogTest, a_pose_that_is_not_settled_is_worth_a_word_where_that_lasts) {
  for (int i = 0; i < 1000; ++i)
    add(1 + 0.001 * i, i % 20 < 10 ? Withheld::nothing : Withheld::unsettled);
  EXPECT_TRUE(force_log_lines.isEmpty()) << force_log_lines.join('\n').toStdString();
  EXPECT_TRUE(log.recent(2).isEmpty());
  for (int i = 0; i < 40; ++i) add(2 + 0.001 * i, Withheld::unsettled);
  add(2.04, Withheld::nothing);
  ASSERT_EQ(force_log_lines.size(), 2) << force_log_lines.join('\n').toStdString();
  EXPECT_TRUE(force_log_lines[0].contains(QString::fromUtf8(words(Withheld::unsettled))));
  EXPECT_TRUE(log.recent(3).contains(QString::fromUtf8(words(Withheld::unsettled))));
}

TEST_F(ForceLogTest, what_was_asked_for_is_logged_once_and_is_no_fault) {
  for (int i = 1; i < 100; ++i) add(0.001 * i, Withheld::stopped);
  EXPECT_EQ(force_log_lines.size(), 1);
  EXPECT_TRUE(log.recent(0.1).isEmpty());
}

TEST_F(ForceLogTest, every_reason_is_logged_in_its_own_words_and_the_end_too) {
  const Withheld reasons[] = {Withheld::stopped,    Withheld::paused, Withheld::let_go,
                              Withheld::untrusted,  Withheld::failed, Withheld::stalled,
                              Withheld::not_finite, Withheld::changed};
  double time = 0;
  add(time += 1, Withheld::nothing, 2);
  for (const Withheld why : reasons) {
    force_log_lines.clear();
    add(time += 1, why);
    ASSERT_EQ(force_log_lines.size(), 1);
    EXPECT_TRUE(force_log_lines[0].contains(QString::fromUtf8(words(why))))
        << force_log_lines[0].toStdString();
  }
  force_log_lines.clear();
  log.end();
  ASSERT_EQ(force_log_lines.size(), 1);
  EXPECT_TRUE(force_log_lines[0].contains(QString::fromUtf8(words(Withheld::shut_down))));
  log.end();
  EXPECT_EQ(force_log_lines.size(), 1) << "nothing has run since";
}

TEST_F(ForceLogTest, a_start_is_worth_no_word_and_another_hand_later_is) {
  for (int i = 1; i < 10; ++i) add(0.001 * i, Withheld::nothing);
  for (int i = 10; i < 20; ++i) add(0.001 * i, Withheld::changed);
  for (int i = 20; i < 30; ++i) add(0.001 * i, Withheld::nothing);
  EXPECT_TRUE(force_log_lines.isEmpty()) << force_log_lines.join('\n').toStdString();
  add(0.1, Withheld::nothing, 2);
  add(0.2, Withheld::changed);
  EXPECT_TRUE(force_log_lines.isEmpty()) << "where the probe begins in contact, too";
  add(0.5, Withheld::nothing, 2);
  add(1, Withheld::changed);
  add(1.001, Withheld::nothing);
  EXPECT_EQ(force_log_lines.size(), 2);
}

TEST_F(ForceLogTest, what_somebody_wanted_does_not_sound_like_a_fault) {
  add(1, Withheld::nothing);
  add(2, Withheld::paused);
  add(3, Withheld::stalled);
  log.end();
  ASSERT_EQ(force_log_lines.size(), 3);
  EXPECT_TRUE(force_log_lines[0].endsWith("paused, so no force"));
  EXPECT_TRUE(force_log_lines[1].contains("no force: "));
  EXPECT_TRUE(force_log_lines[2].endsWith("the loop has ended"));
}

TEST_F(ForceLogTest, another_run_begins_afresh) {
  add(5, Withheld::failed);
  add(0.001, Withheld::nothing);
  EXPECT_TRUE(log.recent(0.1).isEmpty());
}

}  // namespace
}  // namespace sonde::ui
