// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/compare.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace sonde::bench {
namespace {

Answer answer(std::optional<bool> touch, std::optional<double> distance) {
  Answer out;
  out.touch = touch;
  out.distance = distance;
  return out;
}

TEST(Compare, a_different_touch_is_wrong_unless_it_is_in_doubt_there) {
  EXPECT_EQ(judge_touch(true, true, 0, 0), Verdict::agree);
  EXPECT_EQ(judge_touch(true, false, 1e-6, 0), Verdict::wrong);
  EXPECT_EQ(judge_touch(true, false, 1e-6, 1e-4), Verdict::excused);
  EXPECT_EQ(judge_touch(false, true, 1e-6, 1e-4), Verdict::excused);
  EXPECT_EQ(judge_touch(false, true, 0.01, 1e-4), Verdict::wrong);
}

TEST(Compare, distances_agree_to_a_millionth) {
  EXPECT_EQ(judge_distance(0.5, 0.5 + 0.9e-6), Verdict::agree);
  EXPECT_EQ(judge_distance(0.5, 0.5 - 0.9e-6), Verdict::agree);
  EXPECT_EQ(judge_distance(0.5, 0.5 + 1.1e-6), Verdict::wrong);
  EXPECT_EQ(judge_distance(0.5, std::numeric_limits<double>::quiet_NaN()), Verdict::wrong);
  EXPECT_EQ(judge_distance(0.5, std::numeric_limits<double>::infinity()), Verdict::wrong);
}

TEST(Compare, the_worse_of_what_both_answered_counts) {
  EXPECT_EQ(judge(answer(true, 0), answer(false, 1), 0, 1e-4), Verdict::wrong);
  EXPECT_EQ(judge(answer(true, 0), answer(false, {}), 0, 1e-4), Verdict::excused);
  EXPECT_EQ(judge(answer({}, 0), answer(false, {}), 1, 0), Verdict::agree);
  EXPECT_EQ(judge(answer(true, 0.25), answer(true, 0.25), 1, 0), Verdict::agree);
}

TEST(Compare, text_holds_every_digit) {
  EXPECT_EQ(to_text(answer(false, 0.1)), "does not touch, distance 0.10000000000000001 m");
  EXPECT_EQ(to_text(answer(true, {})), "touches");
  EXPECT_EQ(to_text(Answer{}), "no answer");
}

}  // namespace
}  // namespace sonde::bench
