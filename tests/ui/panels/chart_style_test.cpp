// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/chart_style.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sonde::ui::test {
namespace {

/// What is written, from the left.
QStringList numbers(const std::vector<AxisMark>& marks) {
  QStringList texts;
  for (const AxisMark& mark : marks)
    if (!mark.text.isEmpty()) texts << mark.text;
  return texts;
}

TEST(ChartStyle, marks_of_logarithms_stand_at_what_is_written) {
  const auto marks = log_marks(std::log10(40), std::log10(20'000), 200);
  EXPECT_EQ(numbers(marks), QStringList({"100", "1000", "10000"}));
  EXPECT_EQ(marks.size(), 6u + 9 + 9 + 2) << "a mark at each digit";
  for (const AxisMark& mark : marks) {
    EXPECT_GE(mark.at, std::log10(40) - 1e-9);
    EXPECT_LE(mark.at, std::log10(20'000) + 1e-9);
    if (mark.text.isEmpty()) continue;
    EXPECT_NEAR(mark.at, std::log10(mark.text.toDouble()), 1e-9);
  }
}

TEST(ChartStyle, numbers_without_room_are_left_out_and_their_marks_stay) {
  const auto wide = log_marks(0, 2, 400), narrow = log_marks(0, 2, 60);
  EXPECT_EQ(numbers(wide), QStringList({"1", "2", "5", "10", "20", "50", "100"}));
  EXPECT_EQ(narrow.size(), wide.size());
  const QStringList left = numbers(narrow);
  EXPECT_LT(left.size(), 6);
  EXPECT_GE(left.size(), 3);
  EXPECT_EQ(left.first(), "1");
}

TEST(ChartStyle, round_marks_are_as_many_as_find_room) {
  EXPECT_EQ(numbers(round_marks(0, 10, 200, 20)),
            QStringList({"0", "1", "2", "3", "4", "5", "6", "7", "8", "9", "10"}));
  EXPECT_EQ(numbers(round_marks(0, 10, 60, 20)), QStringList({"0", "5", "10"}));
  EXPECT_EQ(numbers(round_marks(-0.3, 0.7, 60, 20)), QStringList({"0", "0.5"}));
}

}  // namespace
}  // namespace sonde::ui::test
