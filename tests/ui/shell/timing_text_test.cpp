// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/timing_text.hpp"

#include <gtest/gtest.h>

#include <QStringList>

namespace sonde::ui::test {
namespace {

TEST(TimingText, tells_times_and_what_the_system_says) {
  ServoTiming timing;
  EXPECT_EQ(timing_text(timing), QStringLiteral("No tick yet."));
  for (int i = 0; i < 10; ++i) timing.tick.add(20);
  timing.ticks = 10;
  timing.late = 3;
  timing.real_time.scheduling = "not permitted";
  const QString text = timing_text(timing);
  EXPECT_TRUE(text.contains(QStringLiteral("tick: 20, 20, 20, 20 µs"))) << text.toStdString();
  EXPECT_TRUE(text.contains(QStringLiteral("late: 3 of 10")));
  EXPECT_TRUE(text.contains(QStringLiteral("not permitted")));
}

TEST(TimingText, each_histogram_has_its_own_line_and_the_longest_stands_last) {
  ServoTiming timing;
  timing.ticks = 1000;
  for (int i = 0; i < 999; ++i) {
    timing.period.add(1000);
    timing.geometry.add(300);
    timing.age.add(1500);
  }
  timing.period.add(4321);
  const QStringList lines = timing_text(timing).split('\n');
  ASSERT_GE(lines.size(), 5);
  EXPECT_TRUE(lines[0].contains("Median, p99, p99.9"));
  EXPECT_TRUE(lines[1].startsWith("period: ") && lines[1].endsWith(", 4321 µs"))
      << lines[1].toStdString();
  EXPECT_TRUE(lines[2].startsWith("tick: 0, 0, 0, 0"));
  EXPECT_TRUE(lines[3].startsWith("geometry: 300, 300")) << lines[3].toStdString();
  EXPECT_TRUE(lines[4].startsWith("age of the rows: 1500, 1500")) << lines[4].toStdString();
}

TEST(TimingText, ticks_that_were_in_step_are_a_share) {
  ServoTiming timing;
  timing.ticks = 3;
  timing.in_step = 2;
  EXPECT_TRUE(timing_text(timing).contains("in step: 66.7 %")) << timing_text(timing).toStdString();
}

TEST(TimingText, what_the_system_was_not_asked_for_has_no_line) {
  ServoTiming timing;
  timing.ticks = 1;
  const QString without = timing_text(timing);
  timing.real_time = {.scheduling = "a", .memory = "b", .processor = "c"};
  EXPECT_EQ(timing_text(timing), without + "\na\nb\nc");
}

}  // namespace
}  // namespace sonde::ui::test
