// SPDX-License-Identifier: GPL-3.0-or-later
// Reference: made-up results whose answer can be worked out on paper.
#include "engine/study/tuning/assumptions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

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

TEST(Assumptions, the_one_that_limits_the_recommendation_comes_first_with_both_ends) {
  const auto intervals = assumed_intervals(varied_results(), GainAxis::object);
  ASSERT_EQ(intervals.size(), 2u);
  const AssumedInterval& worst = intervals.front();
  EXPECT_EQ(worst.key, "friction");
  EXPECT_DOUBLE_EQ(worst.low.value, 0.05);
  EXPECT_DOUBLE_EQ(worst.high.value, 0.2);
  EXPECT_DOUBLE_EQ(worst.low.gains.stiffness, 400);
  EXPECT_DOUBLE_EQ(worst.low.gains.boundary, 600);
  EXPECT_DOUBLE_EQ(worst.high.gains.boundary, 2400);
  EXPECT_EQ(worst.kind, "flat");
  EXPECT_EQ(worst.hand, "light");
  EXPECT_EQ(intervals.back().key, "mass");
  EXPECT_TRUE(change_gains(intervals));
}

/// Results in which each value allows this at its ends, by its boundary or by something else.
struct Ends {
  const char* key;
  std::pair<double, double> boundary, good;
};
TuningResults with_ends(const std::vector<Ends>& values) {
  TuningResults r = test::results();
  r.device["damping"] = 2;
  r.device["delay"] = 1e-3;
  r.lines = {line(0, GainAxis::object, {column(0, 1500)})};
  for (const Ends& each : values)
    for (const bool high : {false, true}) {
      const double boundary = high ? each.boundary.second : each.boundary.first;
      const double good = high ? each.good.second : each.good.first;
      TuningLine varied =
          line(0, GainAxis::object, {column(0, boundary, good, HoldFault::chattering)});
      varied.assumed = each.key;
      varied.times = high ? 2 : 0.5;
      r.lines.push_back(varied);
    }
  return r;
}

/// The same, worked out beside the engine: the least of a boundary over 1.5 and what is good, at
/// the worse end; ends within 5 % count as equal, and then the better end decides.
std::string limits_most(const std::vector<Ends>& values) {
  const auto allowed = [](double boundary, double good) { return std::min(boundary / 1.5, good); };
  std::vector<std::pair<double, double>> ends;
  for (const Ends& each : values)
    ends.push_back(std::minmax({allowed(each.boundary.first, each.good.first),
                                allowed(each.boundary.second, each.good.second)}));
  double least = 1e300;
  for (const auto& each : ends) least = std::min(least, each.first);
  std::size_t most = ends.size();
  for (std::size_t i = 0; i < ends.size(); ++i)
    if (ends[i].first <= 1.05 * least &&
        (most == ends.size() || ends[i].second > ends[most].second))
      most = i;
  return values[most].key;
}

TEST(Assumptions, what_limits_most_goes_by_what_is_recommended_and_not_by_the_boundary) {
  constexpr double any = 1e5;
  const std::vector<Ends> by_chatter{{"damping", {1400, 1600}, {300, 1200}},
                                     {"friction", {600, 2400}, {any, any}},
                                     {"mass", {1200, 1800}, {any, any}}};
  EXPECT_EQ(limits_most(by_chatter), "damping");
  // The mass's worse end is the least by what the search cannot tell; the delay is what holds back.
  const std::vector<Ends> hardly{{"damping", {1500, 1500}, {any, any}},
                                 {"delay", {3000, 1490}, {any, any}},
                                 {"mass", {1480, 1520}, {any, any}}};
  EXPECT_EQ(limits_most(hardly), "delay");
  const std::vector<Ends> none_good{{"damping", {1500, 1500}, {any, 0}},
                                    {"mass", {30, 1500}, {any, any}}};
  EXPECT_EQ(limits_most(none_good), "damping");
  for (const auto& values : {by_chatter, hardly, none_good}) {
    const TuningResults r = with_ends(values);
    EXPECT_EQ(assumed_intervals(r, GainAxis::object).front().key, limits_most(values));
  }
}

TEST(Assumptions, a_limit_without_a_hand_counts_for_what_limits_most) {
  TuningResults r =
      with_ends({{"delay", {3000, 900}, {1e5, 1e5}}, {"friction", {600, 2400}, {1e5, 1e5}}});
  for (TuningLine& line : r.lines)
    if (line.assumed == "delay") line.columns[0].theory_released = line.times > 1 ? 300 : 1200;
  EXPECT_EQ(assumed_intervals(r, GainAxis::object).front().key, "delay") << "300 / 1.5, not 400";
  r.always_held = true;
  EXPECT_EQ(assumed_intervals(r, GainAxis::object).front().key, "friction");
}

TEST(Assumptions, ends_that_the_search_cannot_tell_apart_change_nothing) {
  const auto changed = [](double low, double high) {
    const TuningResults r = with_ends({{"mass", {low, high}, {1e5, 1e5}}});
    return change_gains(assumed_intervals(r, GainAxis::object));
  };
  EXPECT_FALSE(changed(1500, 1500));
  EXPECT_FALSE(changed(1500, 1560));
  EXPECT_TRUE(changed(1500, 1600));
  EXPECT_TRUE(changed(0, 1500));
  EXPECT_FALSE(change_gains({}));
}

TEST(Assumptions, a_value_has_the_unit_of_the_profile) {
  EXPECT_EQ(unit_of({.key = "mass", .low = {}, .high = {}, .kind = {}, .hand = {}}), "kg");
  EXPECT_EQ(unit_of({.key = "none", .low = {}, .high = {}, .kind = {}, .hand = {}}), "");
}

TEST(Assumptions, the_limit_without_friction_counts_unless_friction_is_trusted) {
  TuningResults r = varied_results();
  r.lines[1].columns[0].without_friction = {400, HoldFault::unstable};
  const AssumedInterval worst = assumed_intervals(r, GainAxis::object).front();
  EXPECT_EQ(worst.key, "mass");
  EXPECT_DOUBLE_EQ(worst.low.gains.stiffness, 400 / stability_margin);
  EXPECT_DOUBLE_EQ(worst.high.gains.boundary, 1800);
  r.trusts_friction = true;
  EXPECT_EQ(assumed_intervals(r, GainAxis::object).front().key, "friction");
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
