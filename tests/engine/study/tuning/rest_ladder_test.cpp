// SPDX-License-Identifier: GPL-3.0-or-later
// References: made-up ladders whose answer can be worked out on paper; the loop, held for a minute.
#include "engine/study/tuning/rest_ladder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "engine/study/tuning/gain_recommendation.hpp"
#include "engine/study/tuning/tuning_words.hpp"
#include "tests/engine/study/tuning/made_up_results.hpp"
#include "tests/engine/study/tuning/tuning_requests.hpp"

namespace sonde {
namespace {

using test::never;
using test::stable_up_to;
using testing::Contains;
using testing::HasSubstr;

const Swing swing{"flat", "limp", 0, 4, 2e-3, 31, 700};

/// Which would recommend 1000 N/m by the boundary alone.
TuningResults tried(std::vector<Rung> rungs) {
  TuningResults r = stable_up_to({1500});
  r.ladder = RestLadder{GainAxis::object, 0, std::move(rungs)};
  return r;
}

TEST(RestLadder, only_what_comes_to_rest_is_recommended) {
  const TuningResults r = tried({{1200, swing, 4}, {900, swing, 4}, {700, {}, 2}, {500, {}, 1}});
  const auto gains = recommend(r, GainAxis::object);
  EXPECT_DOUBLE_EQ(gains->stiffness, 700);
  EXPECT_EQ(gains->limit.reason, "rest");
  EXPECT_EQ(gains->limit.kind, "flat");
  EXPECT_EQ(gains->limit.hand, "limp");
  EXPECT_DOUBLE_EQ(gains->longest_to_rest, 2);
  EXPECT_THAT(recommendation_in_words(r),
              Contains(HasSubstr("stiffer, the probe swings on at 2 mm, 31 Hz, in the flat contact "
                                 "(limp hand), without friction, after a knock of 4 times")));
}

TEST(RestLadder, what_the_limits_allow_is_taken_to_a_rung) {
  const TuningResults r = tried({{1200, swing, 4}, {950, {}, 2}, {700, {}, 1}});
  const auto gains = recommend(r, GainAxis::object);
  EXPECT_DOUBLE_EQ(gains->stiffness, 950);
  EXPECT_EQ(gains->limit.reason, "stability");
  EXPECT_FALSE(gains->swings) << "nothing that the boundary allows";
  EXPECT_DOUBLE_EQ(gains->held_at, 950);
}

TEST(RestLadder, where_nothing_comes_to_rest_nothing_is_recommended) {
  const TuningResults r = tried({{950, swing, 4}, {300, swing, 4}});
  EXPECT_FALSE(has_recommendation(r));
  const auto words = recommendation_in_words(r);
  EXPECT_THAT(words.front(), HasSubstr("no stiffness is good"));
  EXPECT_THAT(words, Contains(HasSubstr("at no stiffness tried did it come to rest")));
  EXPECT_THAT(words, Contains(HasSubstr("what would help: ")));
}

TEST(RestLadder, reads_back_as_it_was_written) {
  const RestLadder ladder{GainAxis::together, 3.5, {{900, swing, 4}, {700, {}, 2}}};
  const RestLadder back = rest_ladder_of(to_json(ladder));
  EXPECT_EQ(to_json(back), to_json(ladder));
  EXPECT_EQ(back.rungs[0].swing->hand, "limp");
  EXPECT_FALSE(back.rungs[1].swing);
}

TEST(RestLadder, a_hand_that_lets_go_caps_unless_it_always_holds) {
  TuningResults r = stable_up_to({1500});
  r.lines[0].columns[0].theory_released = 450;
  r.lines[0].columns[0].theory_released_any_swing = 450;
  EXPECT_DOUBLE_EQ(recommend(r, GainAxis::object)->stiffness, 450 / stability_margin);
  EXPECT_EQ(recommend(r, GainAxis::object)->limit.reason, "released");
  EXPECT_THAT(recommendation_in_words(r),
              Contains("if the hand lets go, no swing of the handle grows: in theory it may be up "
                       "to 450 N/m"));
  r.always_held = true;
  EXPECT_DOUBLE_EQ(recommend(r, GainAxis::object)->stiffness, 1000);
  EXPECT_THAT(recommendation_in_words(r),
              Contains("if the hand lets go, the handle is unstable, and buzzes: in theory it may "
                       "be up to 450 N/m; a hand that always holds was asked for"));
}

TEST(RestLadder, a_slow_swing_that_grows_is_said_to_be_unstable) {
  TuningResults r = stable_up_to({1500});
  r.always_held = true;  // else it caps the object norm
  const auto says = [&](double released, std::optional<double> any_swing) {
    r.lines[0].columns[0].theory_released = released;
    r.lines[0].columns[0].theory_released_any_swing = any_swing;
    EXPECT_DOUBLE_EQ(recommend(r, GainAxis::object)->stiffness, 1000);
    std::string out;
    for (const std::string& sentence : recommendation_in_words(r))
      if (sentence.starts_with("if the hand lets go, ")) out += sentence.substr(21);
    return std::pair(if_let_go(*recommend(r, GainAxis::object)), out);
  };
  using testing::Pair;
  EXPECT_THAT(says(4500, 23.4),
              Pair(LetGo::slow_swing,
                   "the handle is unstable: in theory a swing slower than 5 Hz grows from 23.4 N/m "
                   "on, until a hand comes back; a faster one from 4500 N/m"));
  EXPECT_THAT(says(infinity, 0),
              Pair(LetGo::slow_swing,
                   "the handle is unstable: in theory a swing slower than 5 Hz grows at any "
                   "stiffness, until a hand comes back"));
  EXPECT_THAT(says(4500, 1200), Pair(LetGo::stable,
                                     "no swing of the handle grows: in theory it may be up to 1200 "
                                     "N/m"));
  EXPECT_THAT(says(infinity, infinity),
              Pair(LetGo::stable, "no swing of the handle grows in theory"));
  EXPECT_THAT(says(4500, {}), Pair(LetGo::no_buzz,
                                   "no swing of 5 Hz or faster grows: in theory it may be up to "
                                   "4500 N/m; slower ones were not looked at"));
  EXPECT_THAT(says(infinity, {}), Pair(LetGo::unknown, ""));
}

TEST(RestLadder, what_one_contact_does_not_know_nobody_knows) {
  TuningResults r = stable_up_to({1500, 3000});
  r.lines[0].columns[0].theory_released_any_swing = 700;
  EXPECT_FALSE(recommend(r, GainAxis::object)->released_any_swing);
  r.lines[1].columns[0].theory_released_any_swing = 600;
  EXPECT_DOUBLE_EQ(*recommend(r, GainAxis::object)->released_any_swing, 600);
}

/// Holds the probe in each contact and hand of the ladder, for windows of so many seconds.
void expect_rest(const TuningRequest& request, const AxisGains& gains, double seconds) {
  const TuningPlan plan = tuning_plan(request, never);
  for (std::size_t i = 0; i < plan.contacts.situations.size(); ++i)
    for (const HandGrip& hand : {limp_hand, hand_grips[0], hand_grips[1]})
      for (const double friction : {0.0, 2.0}) {
        TuningSetup setup = ladder_setup(plan, i, hand);
        setup.loop.device.translation.friction *= friction;
        setup.loop.device.rotation.friction *= friction;
        set_gains(setup.loop.coupling, GainAxis::object, gains.stiffness, 0, {});
        Press press = press_of(setup, GainAxis::object);
        press.knock = 3;
        press.window_time = seconds;
        ClosedLoop loop(setup.loop);
        const HoldReport held = press_and_hold(loop, press);
        EXPECT_LE(held.kinetic, quiet_energy(press, setup.loop.device)) << hand.name << friction;
      }
}

// Reference: a minute of the loop in each contact and hand of the ladder, on the rung recommended.
TEST(RestLadder, what_is_recommended_rests_for_a_minute) {
  TuningRequest request = test::pressed_boxes();
  request.device.mass.assumed = false;
  const TuningResults results = test::tuned(request);
  const auto gains = recommend(results, GainAxis::object);
  ASSERT_TRUE(gains && gains->tried && gains->stiffness > 0);
  expect_rest(request, *gains, 30);
}

// Reference: the loop on the rung recommended, for 20 s. What the limits alone allow is no rung.
TEST(RestLadder, what_a_first_look_did_not_find_is_recommended_only_once_tried) {
  TuningRequest request = test::pressed_boxes();
  request.device.mass.assumed = false;
  const auto plan = std::make_shared<TuningPlan>(*study_plan(request, 1, never));
  plan->held_stiffness = 0;
  TuningResults results = read_tuning("", compute_at_once(plan_tuning(plan), 2, never));
  const auto gains = recommend(results, GainAxis::object);
  ASSERT_TRUE(gains && gains->tried && results.ladder);
  EXPECT_EQ(std::ranges::count(results.ladder->rungs, gains->stiffness, &Rung::stiffness), 1);
  ASSERT_GT(gains->stiffness, 0);
  expect_rest(request, *gains, 10);
  const double least = results.ladder->rungs.back().stiffness;
  EXPECT_LE(results.ladder->rungs.front().stiffness, plan->unmeasured);
  EXPECT_LT(least, 0.2 * plan->unmeasured) << "also below what holds: a part may yet allow less";
  for (TuningLine& line : results.lines)
    line.columns.front().stable.stiffness = line.columns.front().good.stiffness = 0.9 * least;
  EXPECT_FALSE(has_recommendation(results));
  EXPECT_THAT(recommendation_in_words(results),
              Contains(HasSubstr("nothing so soft was held until it rests")));
}

// Reference: the loop on the rung recommended, for 20 s. The parts allow 0.6 of this first look.
TEST(RestLadder, what_a_first_look_found_too_stiff_is_recommended_softer) {
  TuningRequest request = test::pressed_boxes();
  request.device.mass.assumed = false;
  const auto plan = std::make_shared<TuningPlan>(*study_plan(request, 1, never));
  ASSERT_GT(plan->held_stiffness, 0);
  TuningResults results = read_tuning("", compute_at_once(plan_tuning(plan), 2, never));
  const double allowed = recommend(results, GainAxis::object)->limits.front().stiffness;
  ASSERT_GT(allowed, 0);
  plan->held_stiffness = allowed / 0.6;
  plan->unmeasured = 2 * plan->held_stiffness;
  results.ladder = climb_down(*plan, never);
  const auto gains = recommend(results, GainAxis::object);
  ASSERT_TRUE(gains && gains->tried);
  EXPECT_NEAR(gains->stiffness / allowed, 0.5 / 0.6, 1e-3) << "half of the first look";
  EXPECT_LE(gains->stiffness, 1.001 * allowed);
  expect_rest(request, *gains, 10);
}

// Reference: the same climb at each damping by itself.
TEST(RestLadder, where_no_first_look_found_any_every_damping_is_tried) {
  TuningRequest request = test::pressed_boxes();
  request.coupling.mode = Coupling::Mode::damped;
  TuningPlan plan = tuning_plan(request, never);
  const TuningSetup setup = tuning_setup(plan, 0, hand_grips[0]);
  const auto tried = [&](std::vector<DampingToTry> dampings) {
    plan.dampings = std::move(dampings);
    return climb_down(plan, never);
  };
  const std::vector<double> shares{0, 0.1, 1};
  std::vector<DampingToTry> all;
  double stiffest = 0, its_damping = 0;
  for (const double share : shares) {
    all.push_back({share, 3000});
    const RestLadder alone = tried({{share, 3000}});
    EXPECT_DOUBLE_EQ(alone.damping, share * most_damping(setup, plan.axis));
    const Rung* held = alone.held(infinity);
    if (!held || held->stiffness <= stiffest) continue;
    stiffest = held->stiffness;
    its_damping = alone.damping;
  }
  ASSERT_GT(stiffest, 0);
  const RestLadder best = tried(all);
  EXPECT_EQ(best.held(infinity)->stiffness, stiffest);
  EXPECT_EQ(best.damping, its_damping);
}

TEST(RestLadder, the_dampings_to_try_are_those_of_the_map) {
  TuningRequest request = test::pressed_boxes();
  request.coupling.mode = Coupling::Mode::damped;
  EXPECT_TRUE(study_plan(request, 2, never)->dampings.empty()) << "a first look allows some";
  request.low = 0.9 * request.high;  // stiffer than anything that holds
  const auto plan = study_plan(request, 2, never);
  ASSERT_EQ(plan->held_stiffness, 0);
  const std::vector<double> shares =
      damping_shares(tuning_setup(*plan, 0, hand_grips[0]), plan->axis);
  ASSERT_EQ(plan->dampings.size(), shares.size());
  ASSERT_GT(shares.size(), 2U);
  for (std::size_t i = 0; i < shares.size(); ++i) EXPECT_EQ(plan->dampings[i].share, shares[i]);
}

}  // namespace
}  // namespace sonde
