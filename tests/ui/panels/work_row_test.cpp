// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/work_row.hpp"

#include <gtest/gtest.h>

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

TEST(WorkRowTest, work_that_goes_on_can_be_stopped_and_none_can_be_started) {
  need_application();
  WorkRow row("Study", "study", nullptr);
  int started = 0, stopped = 0;
  QObject::connect(&row, &WorkRow::start_wanted, [&] { ++started; });
  QObject::connect(&row, &WorkRow::stop_wanted, [&] { ++stopped; });
  auto* const start = row.findChild<QPushButton*>("study");
  auto* const stop = row.findChild<QPushButton*>("study_stop");
  auto* const bar = row.findChild<QProgressBar*>();
  row.show();
  EXPECT_TRUE(start->isVisible());
  EXPECT_FALSE(stop->isVisible());
  start->click();
  row.show_progress(0.25);
  EXPECT_FALSE(start->isVisible());
  EXPECT_TRUE(stop->isVisible());
  EXPECT_EQ(bar->value(), bar->maximum() / 4);
  EXPECT_EQ(bar->text(), "25%");
  EXPECT_TRUE(bar->isTextVisible());
  auto* const left = row.findChild<QLabel*>("study_left");
  EXPECT_FALSE(left->isVisible()) << "the first moments tell little";
  row.show_progress(0.1, 5);
  EXPECT_TRUE(left->isVisible());
  EXPECT_EQ(left->text(), "about 45 s left");
  row.show_progress(0, 12);
  EXPECT_EQ(left->text(), "12 s so far, how long it takes is not known yet");
  stop->click();
  row.show_progress({});
  EXPECT_TRUE(start->isVisible());
  EXPECT_FALSE(bar->isVisible());
  EXPECT_FALSE(left->isVisible());
  row.set_startable(false);
  start->click();
  EXPECT_EQ(started, 1);
  EXPECT_EQ(stopped, 1);
}

}  // namespace
}  // namespace sonde::ui::test
