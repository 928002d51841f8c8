// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/tuning/tuning_words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/engine/study/tuning/made_up_results.hpp"

namespace sonde {
namespace {

using test::column;
using test::line;
using test::results;
using test::stable_up_to;
using test::unstable;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(TuningWords, say_what_is_recommended_and_what_limits_it) {
  TuningResults r = stable_up_to({3000, 1500});
  r.lines[1].columns[0].theory_stable = 1200;
  // The lower boundary by the margin of 1.5.
  EXPECT_THAT(recommendation_in_words(r),
              ElementsAre("k 1000 N/m, limited by stability (edge contact, light hand)",
                          HasSubstr("held for seconds at 900 N/m"),
                          "measured to be stable up to 1500 N/m (a margin of 1.5), passive in "
                          "theory up to 375 N/m"));
  r.lines[1].columns[0].theory_stable = 750;
  EXPECT_THAT(recommendation_in_words(r).back(),
              HasSubstr("above the limit in theory, which has no friction: 750 N/m"));
  r.lines[1].columns[0].good.stiffness = 0;
  r.lines[1].columns[0].good.fault = HoldFault::chattering;
  EXPECT_EQ(gains_in_words(r),
            "no stiffness is good, limited by chatter (edge contact, light hand)");
}

// "Without friction up to 700 N/m" alone would not say what is.
TEST(TuningWords, say_what_is_meant_where_nothing_was_unstable_with_friction) {
  TuningResults r = stable_up_to({infinity});
  TuningColumn& only = r.lines[0].columns[0];
  only.without_friction = {700, HoldFault::unstable};
  EXPECT_THAT(recommendation_in_words(r),
              testing::Contains(HasSubstr("measured to be stable without friction up to 700 N/m")));
  only.without_friction_by_theory = true;
  EXPECT_THAT(recommendation_in_words(r),
              testing::Contains(HasSubstr("stable without friction, in theory, up to 700 N/m")));
  only.without_friction = {};
  only.harder_knocks = {900, HoldFault::unstable};
  EXPECT_THAT(recommendation_in_words(r),
              testing::Contains(HasSubstr("measured to be stable at harder knocks up to 900 N/m")));
}

TEST(TuningWords, say_what_a_damper_may_allow_where_it_is_much_more) {
  TuningResults r = stable_up_to({3000, 1500});
  r.damper = {2000, 1.5};
  EXPECT_THAT(recommendation_in_words(r),
              testing::Contains("with a damper (the coupling damped), theory and the driver allow "
                                "k 2000 N/m, b_t 1.5 N·s/m: a study of that coupling tells what "
                                "holds"));
  r.damper = {1100, 1.5};  // 1000 without
  EXPECT_THAT(recommendation_in_words(r), testing::Not(testing::Contains(HasSubstr("damper"))));
}

TEST(TuningWords, say_the_gains_of_the_damped_coupling) {
  TuningResults r = results();
  r.mode = Coupling::Mode::damped;
  r.lines = {line(0, GainAxis::damped, {column(0, 900), column(2, 3000)})};
  EXPECT_EQ(gains_in_words(r),
            "k 2000 N/m, b_t 2 N·s/m, limited by stability (flat contact, light hand)");
  const Coupling gains = recommended_coupling(r);
  EXPECT_EQ(gains.mode, Coupling::Mode::damped);
  EXPECT_EQ(gains.k, 2000);
  EXPECT_EQ(gains.b_t, 2);
}

TEST(TuningWords, say_why_no_virtual_damping_is_best) {
  TuningResults r = results();
  r.joint = {1e-4, 2e-4};
  r.mode = Coupling::Mode::classic;
  r.lines = {
      line(0, GainAxis::together, {column(0, 900), column(4, 3000, 300, HoldFault::chattering)})};
  EXPECT_THAT(recommendation_in_words(r),
              testing::Contains("no virtual damping is best: at b_t 4 N·s/m the stiffness may be "
                                "300 N/m, limited by chatter (flat contact, light hand)"));
  r.lines[0].columns[1] = column(4, 3000);
  const auto words = recommendation_in_words(r);
  EXPECT_THAT(words.front(), HasSubstr("b_t 4 N·s/m, b_r 0.0008 N·m·s/rad"));
  EXPECT_THAT(words.front(), HasSubstr("k_t 2000 N/m, k_r 0.2 N·m/rad"));
  EXPECT_THAT(words, testing::Not(testing::Contains(HasSubstr("no virtual damping"))));
}

// Reference: ζ = (b + b_own) / (2 √(k m)), of translation and rotation each.
TEST(TuningWords, state_the_damping_ratio_of_translation_and_rotation) {
  TuningResults r = results();
  r.joint = {1e-4, 2e-4};
  r.mode = Coupling::Mode::classic;
  r.device["damping"] = 2;
  r.device["rotational_damping"] = 1e-4;
  r.lines = {line(0, GainAxis::together_b_r, {column(8e-4, 1500)})};  // k_t 1000, k_r 0.1
  // 2 / (2 √(1000·0.2)) and 9e-4 / (2 √(0.1·2e-4)).
  EXPECT_THAT(recommendation_in_words(r),
              testing::Contains(HasSubstr("0.0707 of the translation, 0.101 of the rotation")));
}

TEST(TuningWords, state_how_hard_a_wall_feels_and_how_fast_its_force_rises) {
  TuningResults r = stable_up_to({3000});
  r.device["damping"] = 2;
  r.device["delay"] = 1e-3;
  EXPECT_THAT(recommendation_in_words(r),
              testing::Contains(testing::AllOf(HasSubstr("rate-hardness over 10 ms"),
                                               HasSubstr("ms (10 to 90 %, light hand)"))));
}

TEST(TuningWords, compare_with_the_best_of_both_dampers_and_of_each_by_itself) {
  TuningResults r = results();
  r.joint = {1e-4, 2e-4};
  r.mode = Coupling::Mode::classic;
  r.lines = {line(0, GainAxis::together, {column(0, 900), column(4, 300)}),
             line(0, GainAxis::together_b_t, {column(4, 600)}),
             line(0, GainAxis::together_b_r, {column(8e-4, 750)})};
  EXPECT_THAT(recommendation_in_words(r),
              testing::Contains(HasSubstr("at b_r 0.0008 N·m·s/rad by itself the stiffness may be "
                                          "500 N/m")));
}

TEST(TuningWords, say_where_the_gains_rely_on_friction) {
  TuningResults r = stable_up_to({3000, 1500});
  const auto relies = testing::Contains(
      "these gains may rely on friction: without it, at 900 N/m, the probe swings on in the flat "
      "contact (light hand)");
  EXPECT_THAT(recommendation_in_words(r), testing::Not(relies));
  r.lines[0].columns[0].without_friction = {1500, unstable};
  r.lines[0].columns[0].long_hold = {900, true, false};
  EXPECT_THAT(recommendation_in_words(r), relies);
  r.trusts_friction = true;
  EXPECT_THAT(recommendation_in_words(r), testing::Not(relies)) << "as asked";
  r.device["friction"] = r.device["rotational_friction"] = 0;
  EXPECT_THAT(
      recommendation_in_words(r),
      testing::Contains("the device has no friction: at 900 N/m, the probe swings on in the "
                        "flat contact (light hand)"));
}

TEST(TuningWords, say_where_a_hard_knock_swings_on) {
  TuningResults r = stable_up_to({3000, 1500});
  const auto swings = testing::Contains(
      "after a knock of 4 times the strength, at 900 N/m, the probe swings on in the flat contact "
      "(light hand)");
  EXPECT_THAT(recommendation_in_words(r), testing::Not(swings));
  for (TuningLine& line : r.lines) line.columns[0].long_hold.reset();
  EXPECT_THAT(recommendation_in_words(r), testing::Contains(HasSubstr("was not looked at")));
  r.lines[0].columns[0].long_hold = {900, false, true};
  EXPECT_THAT(recommendation_in_words(r), swings);
  r.trusts_friction = true;
  EXPECT_THAT(recommendation_in_words(r), swings) << "friction does not end it";
  r.lines[0].columns[0].long_hold = {900, true, false};
  EXPECT_THAT(
      recommendation_in_words(r),
      testing::Contains("held for seconds at 900 N/m, after a knock of 4 times the strength, "
                        "the probe comes to rest"));
  for (TuningLine& line : r.lines) line.columns[0].long_hold = {90, false, false};
  r.trusts_friction = false;
  EXPECT_THAT(
      recommendation_in_words(r),
      testing::Contains("held for seconds at 90 N/m, far from these gains, once without "
                        "friction and once after a knock of 4 times the strength, the probe comes "
                        "to rest"));
}

TEST(TuningWords, name_the_limiting_assumption_at_both_ends) {
  TuningResults r = stable_up_to({1500});
  for (const auto& [times, stable] : {std::pair{0.5, 3000.0}, {2.0, 750.0}}) {
    r.lines.push_back(line(0, GainAxis::object, {column(0, stable)}));
    r.lines.back().assumed = "max_force";
    r.lines.back().times = times;
  }
  EXPECT_THAT(recommendation_in_words(r).back(),
              testing::StrEq("of the device's values that are not sure, the max force limits most: "
                             "by the limits of the flat contact (light hand) alone, 1000 N/m as it "
                             "is, 2000 N/m at 5 N, 500 N/m at 20 N"));
}

TEST(TuningWords, say_whether_the_hand_changes_the_gains) {
  TuningResults r = stable_up_to({1500});
  r.lines.push_back(line(0, GainAxis::object, {column(0, 1530)}));
  r.lines.back().hand = "firm";
  EXPECT_THAT(recommendation_in_words(r),
              testing::Contains("how the hand holds is assumed too, and does not change the gains: "
                                "1000 N/m by the limits of each alone"));
  r.lines.back() = line(0, GainAxis::object, {column(0, 3000)});
  r.lines.back().hand = "firm";
  const std::string hands =
      "how the hand holds is assumed too: by the limits of each alone, the firm one allows 2000 "
      "N/m, the light one allows 1000 N/m";
  EXPECT_THAT(recommendation_in_words(r), testing::Contains(hands));
  r.ladder =
      RestLadder{GainAxis::object, 0, {{900, Swing{"flat", "limp", 0, 4, 2e-3, 31, 700}, 4}}};
  EXPECT_EQ(recommendation_in_words(r).front(),
            "no stiffness is good, limited by what comes to rest (flat contact, limp hand)");
  EXPECT_THAT(recommendation_in_words(r),
              testing::Contains(hands + ", before what comes to rest is tried"));
}

/// The first sentence that begins so.
std::size_t place_of(const std::vector<std::string>& words, const char* begin) {
  const auto at =
      std::ranges::find_if(words, [&](const auto& each) { return each.starts_with(begin); });
  EXPECT_NE(at, words.end()) << begin;
  return std::size_t(at - words.begin());
}

TEST(TuningWords, come_in_the_order_in_which_one_asks) {
  TuningResults r = stable_up_to({1500});
  r.lines.push_back(line(0, GainAxis::object, {column(0, 3000)}));
  r.lines.back().hand = "firm";
  for (const auto& [times, stable] : {std::pair{0.5, 3000.0}, {2.0, 750.0}}) {
    r.lines.push_back(line(0, GainAxis::object, {column(0, stable)}));
    r.lines.back().assumed = "max_force";
    r.lines.back().times = times;
  }
  for (TuningLine& each : r.lines)
    each.columns[0].theory_released = each.columns[0].theory_released_any_swing.emplace(4500);
  const auto words = recommendation_in_words(r);
  const std::vector<std::size_t> places{
      place_of(words, "k 1000 N/m"),
      place_of(words, "held for seconds"),
      place_of(words, "how the hand holds"),
      place_of(words, "measured to be stable"),
      place_of(words, "if the hand lets go"),
      place_of(words, "it rests on values that are not sure"),
      place_of(words, "of the device's values that are not sure")};
  EXPECT_TRUE(std::ranges::is_sorted(places)) << testing::PrintToString(words);
}

TEST(TuningWords, theory_does_not_deny_what_came_to_rest) {
  TuningResults r = stable_up_to({1500});
  r.lines[0].columns[0].theory_stable = 750;
  r.ladder = RestLadder{GainAxis::object, 0, {{1000, {}, 2}}};
  EXPECT_THAT(
      recommendation_in_words(r),
      testing::Contains("that is above the limit in theory, which has no friction and takes "
                        "the contact as linear: 750 N/m; in the contact as it is, the "
                        "probe came to rest"));
}

// Where the driver's word decides, say, each value may be half or twice what it is assumed to be.
TEST(TuningWords, name_no_limiting_assumption_where_none_limits) {
  const auto words_with = [](double low, double high) {
    TuningResults r = stable_up_to({1500});
    for (const auto& [times, stable] : {std::pair{0.5, low}, {2.0, high}}) {
      r.lines.push_back(line(0, GainAxis::object, {column(0, stable)}));
      r.lines.back().assumed = "max_force";
      r.lines.back().times = times;
    }
    return recommendation_in_words(r).back();
  };
  const std::string none = "none of the device's values that are not sure changes the gains: ";
  const std::string same =
      "1000 N/m at both ends of each, by the limits of the flat contact (light hand) alone";
  EXPECT_EQ(words_with(1500, 1500), none + same);
  EXPECT_EQ(words_with(1500, 1560), none + same);
  EXPECT_THAT(words_with(1500, 1650), HasSubstr("the max force limits most"));
  EXPECT_THAT(words_with(1500, 1350), HasSubstr("the max force limits most"));
}

// Reference: D ⪰ (T/2 + t_d) K + B holds for no K ⪰ 0 where B exceeds D, nor where D is 0.
TEST(TuningWords, say_that_no_stiffness_is_passive_and_why) {
  const auto words_at = [](double damping, double passive, double in_translation, double lever) {
    TuningResults r = results();
    r.mode = damping > 0 ? Coupling::Mode::damped : Coupling::Mode::object;
    const GainAxis axis = damping > 0 ? GainAxis::damped : GainAxis::object;
    r.lines = {line(0, axis, {column(damping, 1500)})};
    r.lines[0].columns[0].theory_passive = passive;
    r.lines[0].columns[0].theory_passive_in_translation = in_translation;
    r.lines[0].columns[0].cycle_lever = lever;
    return recommendation_in_words(r);
  };
  const auto says = [](const char* what) { return testing::Contains(HasSubstr(what)); };
  EXPECT_THAT(words_at(2, 0, 0, 0), says("no stiffness is passive at this damping, which is more"));
  EXPECT_THAT(words_at(0, 0, 0, 0), says("passive: the device has no damping of its own"));
  EXPECT_THAT(words_at(2, 0, 0, 1e-3), says("mJ; nor is any with the turn held"));
  EXPECT_THAT(words_at(0, 0, 120, 1e-3),
              says("mJ; with the turn held it is passive up to 120 N/m"));
  EXPECT_THAT(words_at(2, 400, 400, 0), testing::Not(says("no stiffness is passive")));
}

}  // namespace
}  // namespace sonde
