// SPDX-License-Identifier: GPL-3.0-or-later
// Reference: made-up results whose answer can be worked out on paper.
#include "engine/study/tuning/assumptions.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/study/tuning/made_up_results.hpp"

namespace sonde {
namespace {

using test::column;
using test::line;

TuningLine varied(const char* key, double times, double stable) {
  TuningLine out = line(0, GainAxis::object, {column(0, stable)});
  out.assumed = key;
  out.times = times;
  return out;
}

TuningResults varied_results() {
  TuningResults r = test::results();
  r.lines = {line(0, GainAxis::object, {column(0, 1500)}), varied("mass", 0.5, 1200),
             varied("mass", 2, 1800), varied("friction", 2, 2400), varied("friction", 0.5, 600)};
  return r;
}

TEST(Assumptions, the_one_with_the_worst_end_comes_first_with_both_ends) {
  const auto intervals = assumed_intervals(varied_results(), GainAxis::object);
  ASSERT_EQ(intervals.size(), 2u);
  const AssumedInterval& worst = intervals.front();
  EXPECT_EQ(worst.key, "friction");
  EXPECT_DOUBLE_EQ(worst.low.value, 0.05);
  EXPECT_DOUBLE_EQ(worst.high.value, 0.2);
  EXPECT_DOUBLE_EQ(worst.low.gains.stiffness, 400);
  EXPECT_DOUBLE_EQ(worst.low.gains.boundary, 600);
  EXPECT_DOUBLE_EQ(worst.high.gains.boundary, 2400);
  EXPECT_EQ(intervals.back().key, "mass");
}

TEST(Assumptions, the_boundary_without_friction_counts_unless_friction_is_trusted) {
  TuningResults r = varied_results();
  r.lines[1].columns[0].without_friction = {400, HoldFault::unstable};
  const AssumedInterval worst = assumed_intervals(r, GainAxis::object).front();
  EXPECT_EQ(worst.key, "mass");
  EXPECT_DOUBLE_EQ(boundary_that_counts(r, worst.low.gains), 400);
  EXPECT_DOUBLE_EQ(boundary_that_counts(r, worst.high.gains), 1800);
  r.trusts_friction = true;
  EXPECT_EQ(assumed_intervals(r, GainAxis::object).front().key, "friction");
  EXPECT_DOUBLE_EQ(boundary_that_counts(r, worst.low.gains), 1200);
}

TEST(Assumptions, none_where_nothing_was_varied) {
  TuningResults r = varied_results();
  r.lines.resize(1);
  EXPECT_TRUE(assumed_intervals(r, GainAxis::object).empty());
}

TEST(Assumptions, each_hand_has_its_own_boundary_and_gains) {
  TuningResults r = varied_results();
  r.lines.push_back(line(1, GainAxis::object, {column(0, 900)}));
  r.lines.push_back(line(0, GainAxis::object, {column(0, 5e4, 5e4, HoldFault::none)}));
  r.lines.back().hand = "firm";
  r.lines.back().columns[0].stable.fault = HoldFault::none;
  const auto by_hand = recommend_by_hand(r, GainAxis::object, 0);
  ASSERT_EQ(by_hand.size(), 2u);
  EXPECT_DOUBLE_EQ(by_hand.at("light").boundary, 900);
  EXPECT_DOUBLE_EQ(by_hand.at("light").stiffness, 600) << "by the margin of 1.5";
  EXPECT_TRUE(std::isinf(by_hand.at("firm").boundary));
  EXPECT_GT(by_hand.at("firm").stiffness, 600);
}

}  // namespace
}  // namespace sonde
