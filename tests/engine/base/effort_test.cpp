// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/base/effort.hpp"

#include <gtest/gtest.h>

namespace sonde {
namespace {

/// Spends one unit after the other; how many until it was told to stop.
int spend_all(Effort& effort, int most) {
  int spent = 0;
  while (spent < most && effort.spend(1)) ++spent;
  return spent;
}

TEST(Effort, at_most_stops_the_part_and_charges_the_whole) {
  Effort effort(1000, 0);
  const int spent = effort.at_most(100, [](Effort& part) { return spend_all(part, 500); });
  EXPECT_EQ(spent, 99);
  EXPECT_EQ(effort.left(), 900);
  EXPECT_FALSE(effort.is_spent());
}

TEST(Effort, at_most_charges_only_what_was_spent) {
  Effort effort(1000, 0);
  effort.at_most(100, [](Effort& part) { return spend_all(part, 30); });
  EXPECT_EQ(effort.left(), 970);
}

TEST(Effort, at_most_gives_no_more_than_there_is) {
  Effort effort(50, 0);
  const int spent = effort.at_most(100, [](Effort& part) { return spend_all(part, 500); });
  EXPECT_EQ(spent, 49);
  EXPECT_TRUE(effort.is_spent());
}

TEST(Effort, at_most_limits_what_is_unlimited) {
  Effort effort;
  const int spent = effort.at_most(100, [](Effort& part) { return spend_all(part, 500); });
  EXPECT_EQ(spent, 99);
  EXPECT_FALSE(effort.is_limited());
}

TEST(Effort, a_part_that_the_clock_ends_leaves_nothing) {
  Effort effort(0, now_us() - 1);
  EXPECT_EQ(effort.at_most(1000, [](Effort& part) { return spend_all(part, 5000); }), 0);
  EXPECT_TRUE(effort.is_spent());
}

}  // namespace
}  // namespace sonde
