// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/time_left.hpp"

#include <gtest/gtest.h>

#include <QLabel>

#include "tests/ui/window_fixture.hpp"
#include "ui/base/progress_dialog.hpp"

namespace sonde::ui::test {
namespace {

TEST(TimeLeftOfWork, is_told_from_the_part_that_is_done) {
  EXPECT_EQ(time_left_text(5, 0.1), "about 45 s left");
  EXPECT_EQ(time_left_text(60, 0.25), "about 3 min left");
  EXPECT_EQ(time_left_text(9, 1), "about 1 s left");
  EXPECT_EQ(time_left_text(1, 0.5), "") << "the first moments tell little";
}

TEST(TimeLeftOfWork, says_something_after_ten_seconds_whatever_is_known) {
  EXPECT_EQ(time_left_text(9, 0), "");
  EXPECT_EQ(time_left_text(11.5, 0), "11 s so far, how long it takes is not known yet");
  for (double part = 0; part <= 1; part += 1e-3)
    EXPECT_FALSE(time_left_text(10.01, part).isEmpty()) << part;
}

TEST(TimeLeftOfWork, stands_in_the_progress_dialog_which_is_named_after_its_work) {
  need_application();
  ProgressDialog dialog("Reading camel.off", nullptr);
  EXPECT_EQ(dialog.windowTitle(), "Reading camel.off");
  dialog.show_progress(0.1, 5);
  EXPECT_EQ(dialog.findChild<QLabel*>("time_left")->text(), "about 45 s left");
}

}  // namespace
}  // namespace sonde::ui::test
