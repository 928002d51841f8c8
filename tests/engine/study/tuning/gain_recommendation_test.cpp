// SPDX-License-Identifier: GPL-3.0-or-later
// Reference: made-up results whose answer can be worked out on paper.
#include "engine/study/tuning/gain_recommendation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/engine/study/tuning/made_up_results.hpp"

namespace sonde {
namespace {

using test::column;
using test::line;
using test::results;
using test::stable_up_to;
using test::unstable;

TEST(GainRecommendation, stability_is_the_least_of_all_situations_with_its_margin) {
  TuningResults r = stable_up_to({3000, 1500});
  const auto gains = recommend(r, GainAxis::object);
  ASSERT_TRUE(gains);
  EXPECT_DOUBLE_EQ(gains->stiffness, 1500 / stability_margin);
  EXPECT_DOUBLE_EQ(gains->margin(), stability_margin);
  EXPECT_EQ(gains->limit.reason, "stability");
  EXPECT_EQ(gains->limit.kind, "edge");
  EXPECT_DOUBLE_EQ(gains->boundary, 1500);
  EXPECT_DOUBLE_EQ(gains->theory, 750);
  EXPECT_DOUBLE_EQ(gains->passive, 375);
  EXPECT_FALSE(recommend(r, GainAxis::rotation));
  const Coupling c = recommended_coupling(r);
  EXPECT_EQ(c.mode, Coupling::Mode::object);
  EXPECT_DOUBLE_EQ(c.k, 1000);
  EXPECT_EQ(c.max_torque, 0.2);
}

TEST(GainRecommendation, what_was_never_unstable_has_no_boundary) {
  TuningResults r = results();
  r.lines = {line(0, GainAxis::object, {column(0, 50, 50, HoldFault::none)})};
  r.lines[0].columns[0].stable.fault = HoldFault::none;
  const auto gains = recommend(r, GainAxis::object);
  ASSERT_TRUE(gains);
  EXPECT_EQ(gains->limit.reason, "range");
  EXPECT_TRUE(std::isinf(gains->boundary));
  EXPECT_TRUE(has_recommendation(r));
}

TEST(GainRecommendation, where_no_stiffness_is_good_there_is_none) {
  EXPECT_FALSE(has_recommendation(stable_up_to({0})));
}

TEST(GainRecommendation, friction_carries_none_unless_it_is_trusted) {
  TuningResults r = stable_up_to({1423, 1500});
  r.lines[0].columns[0].without_friction = {600, unstable};
  r.lines[1].columns[0].without_friction = {516, unstable};
  const auto capped = recommend(r, GainAxis::object);
  EXPECT_DOUBLE_EQ(capped->stiffness, 344);
  EXPECT_EQ(capped->limit.reason, "friction");
  EXPECT_EQ(capped->limit.kind, "edge");
  EXPECT_DOUBLE_EQ(capped->boundary, 1423);
  EXPECT_DOUBLE_EQ(capped->without_friction, 516);
  r.trusts_friction = true;
  const auto trusting = recommend(r, GainAxis::object);
  EXPECT_DOUBLE_EQ(trusting->stiffness, 1423 / stability_margin);
  EXPECT_EQ(trusting->limit.reason, "stability");
  EXPECT_DOUBLE_EQ(trusting->without_friction, 516);
}

TEST(GainRecommendation, a_harder_knock_lowers_it_even_where_friction_is_trusted) {
  TuningResults r = stable_up_to({1500});
  r.trusts_friction = true;
  r.lines[0].columns[0].harder_knocks = r.lines[0].columns[0].stable;
  EXPECT_EQ(recommend(r, GainAxis::object)->limit.reason, "stability");
  r.lines[0].columns[0].harder_knocks = {900, unstable};
  const auto gains = recommend(r, GainAxis::object);
  EXPECT_DOUBLE_EQ(gains->stiffness, 600);
  EXPECT_EQ(gains->limit.reason, "knocks");
  EXPECT_DOUBLE_EQ(gains->harder_knocks, 900);
}

TEST(GainRecommendation, a_study_that_did_not_search_for_it_says_nothing_of_friction) {
  TuningResults r = stable_up_to({1500});
  EXPECT_TRUE(std::isinf(recommend(r, GainAxis::object)->without_friction));
  r.lines[0].columns[0].without_friction = {1e5, HoldFault::none};  // never unstable
  EXPECT_DOUBLE_EQ(recommend(r, GainAxis::object)->stiffness, 1000);
}

TEST(GainRecommendation, each_reason_is_named_where_it_holds) {
  const auto reason = [](const auto& change) {
    TuningResults r = stable_up_to({3000});
    change(r);
    const auto gains = recommend(r, GainAxis::object);
    return gains->limit.reason + " " + std::to_string(std::llround(gains->stiffness));
  };
  EXPECT_EQ(reason([](TuningResults&) {}), "stability 2000");
  EXPECT_EQ(reason([](TuningResults& r) {
              r.lines[0].columns[0].good = {1200, HoldFault::saturated};
            }),
            "saturation 1200");
  EXPECT_EQ(reason([](TuningResults& r) {
              r.lines[0].columns[0].good = {1100, HoldFault::chattering};
            }),
            "chatter 1100");
  EXPECT_EQ(reason([](TuningResults& r) {
              r.lines[0].columns[0].good = {1100, HoldFault::unfaithful};
            }),
            "fidelity 1100");
  EXPECT_EQ(reason([](TuningResults& r) { r.device["max_stiffness"] = 900; }), "driver 900");
  // 1e-3 N·m/rad are felt of 1 N/m: 0.5 N·m/rad at 500 N/m.
  EXPECT_EQ(reason([](TuningResults& r) { r.device["max_rotational_stiffness"] = 0.5; }),
            "driver 500");
  // K ≤ 2 f_c/Δ = 0.2 N / 0.2 mm; without friction a hundredth of 10 N.
  EXPECT_EQ(reason([](TuningResults& r) { r.device["resolution"] = 2e-4; }), "resolution 1000");
  EXPECT_EQ(reason([](TuningResults& r) {
              r.device["friction"] = 0;
              r.device["resolution"] = 2e-4;
            }),
            "resolution 500");
  EXPECT_EQ(reason([](TuningResults& r) {
              r.lines[0].columns[0].stable.fault = HoldFault::none;
              r.lines[0].columns[0].good.fault = HoldFault::none;
            }),
            "range 3000");
}

/// All gains together, and each axis alone, which goes further.
TuningResults classic() {
  TuningResults r = results();
  r.mode = Coupling::Mode::classic;
  r.joint = {2e-4, 1e-3};
  for (const std::size_t at : {0u, 1u})
    r.lines.push_back(
        line(at, GainAxis::together,
             {column(0, 300), column(5, at ? 1200 : 900, 1500, unstable), column(10, 600)}));
  r.lines.push_back(line(0, GainAxis::translation, {column(0, 30000)}));
  r.lines.push_back(line(0, GainAxis::rotation, {column(0, 15)}));
  return r;
}

TEST(GainRecommendation, the_damping_that_allows_most_is_taken) {
  const auto gains = recommend(classic(), GainAxis::together);
  EXPECT_DOUBLE_EQ(gains->stiffness, 600);
  EXPECT_DOUBLE_EQ(gains->damping, 5);
  const auto each = recommend_at_each_damping(classic(), GainAxis::together);
  ASSERT_EQ(each.size(), 3u);
  EXPECT_DOUBLE_EQ(each[0].stiffness, 200);
  EXPECT_DOUBLE_EQ(each[1].stiffness, gains->stiffness);
  EXPECT_DOUBLE_EQ(each[2].stiffness, 400);
  EXPECT_TRUE(recommend_at_each_damping(classic(), GainAxis::object).empty());
}

// The study has what it recommends first: both dampers, or one by itself.
TEST(GainRecommendation, a_damper_that_is_not_swept_is_none) {
  TuningResults r = classic();
  r.lines.insert(r.lines.begin(), line(0, GainAxis::together_b_r, {column(8e-4, 1500)}));
  EXPECT_EQ(recommended_axes(r), std::vector{GainAxis::together_b_r});
  Coupling c = recommended_coupling(r);
  EXPECT_DOUBLE_EQ(c.k_t, 1000);
  EXPECT_DOUBLE_EQ(c.k_r, 0.2);
  EXPECT_EQ(c.b_t, 0);
  EXPECT_DOUBLE_EQ(c.b_r, 8e-4);
  r.lines.front() = line(0, GainAxis::together_b_t, {column(7, 1500)});
  c = recommended_coupling(r);
  EXPECT_DOUBLE_EQ(c.b_t, 7);
  EXPECT_EQ(c.b_r, 0);
}

TEST(GainRecommendation, of_the_classic_coupling_it_is_what_was_held_together) {
  const TuningResults r = classic();
  EXPECT_EQ(recommended_axes(r), std::vector{GainAxis::together});
  const Coupling c = recommended_coupling(r);
  EXPECT_EQ(c.mode, Coupling::Mode::classic);
  EXPECT_DOUBLE_EQ(c.k_t, 600);
  EXPECT_DOUBLE_EQ(c.b_t, 5);
  EXPECT_DOUBLE_EQ(c.k_r, 600 * 2e-4);
  EXPECT_DOUBLE_EQ(c.b_r, 5 * 1e-3);
  EXPECT_GT(recommend(r, GainAxis::translation)->stiffness, c.k_t);
}

TEST(GainRecommendation, of_the_classic_coupling_the_drivers_limits_are_those_of_both_parts) {
  TuningResults r = classic();
  // 1e-3 N·m/rad are felt of k_r = inertia/mass = 1e-3 N·m/rad: 1 of 1, so 0.05 at k_t = 250 N/m.
  r.device["max_rotational_stiffness"] = 0.05;
  EXPECT_DOUBLE_EQ(recommend(r, GainAxis::together)->stiffness, 250);
  EXPECT_EQ(recommend(r, GainAxis::together)->limit.reason, "driver");
  r.device["max_stiffness"] = 100;
  EXPECT_DOUBLE_EQ(recommend(r, GainAxis::together)->stiffness, 100);
}

TEST(GainRecommendation, assumed_values_are_compared_in_their_own_situation) {
  TuningResults r = stable_up_to({3000, 1500});
  r.lines.push_back(line(0, GainAxis::object, {column(0, 4500)}));
  r.lines[2].assumed = "mass";
  r.lines[2].times = 2;
  EXPECT_DOUBLE_EQ(recommend(r, GainAxis::object)->stiffness, 1000);
  EXPECT_DOUBLE_EQ(recommend(r, GainAxis::object, "mass", 2)->stiffness, 3000);
  EXPECT_FALSE(recommend(r, GainAxis::object, "mass", 0.5));
  EXPECT_DOUBLE_EQ(recommend_as_varied(r, GainAxis::object)->stiffness, 2000);
}

TEST(GainRecommendation, assumed_values_are_compared_at_like_dampings) {
  TuningResults r = classic();
  TuningLine varied = line(0, GainAxis::together, {column(10, 300)});
  varied.assumed = "mass";
  varied.times = 2;
  r.lines.push_back(varied);
  // 5 N·s/m would allow 600 N/m: but what is varied is at 10.
  EXPECT_DOUBLE_EQ(recommend_as_varied(r, GainAxis::together)->damping, 10);
  EXPECT_DOUBLE_EQ(recommend_as_varied(r, GainAxis::together)->stiffness, 400);
  EXPECT_DOUBLE_EQ(recommend(r, GainAxis::together, "mass", 2)->stiffness, 200);
}

// What is tried until it rests caps every contact and damping; below that, each goes by its own
// limits, with the margin of a recommendation.
TEST(GainRecommendation, no_contact_or_damping_is_allowed_more_than_what_is_recommended) {
  TuningResults r = stable_up_to({1500, 3000});
  r.lines[0].columns.push_back(column(5, 600));
  r.lines[1].columns.push_back(column(5, 300));
  const auto allows = [&](double damping, const std::string& kind = {}) {
    const auto limit = allowed_at(r, GainAxis::object, damping, kind);
    return limit ? limit->stiffness : -1;
  };
  EXPECT_DOUBLE_EQ(recommend(r, GainAxis::object)->stiffness, 1000);
  EXPECT_DOUBLE_EQ(allows(0), 1000);
  EXPECT_DOUBLE_EQ(allows(0.1, "edge"), 1000) << "by itself it would be 2000";
  EXPECT_DOUBLE_EQ(allows(4, "flat"), 400);
  EXPECT_DOUBLE_EQ(allows(9, "edge"), 200);
  EXPECT_DOUBLE_EQ(allows(4), 200);
  EXPECT_EQ(allows(0, "jammed"), -1);
  EXPECT_FALSE(allowed_at(r, GainAxis::rotation, 0));
  r.lines[0].columns[0].theory_released = 750;
  EXPECT_DOUBLE_EQ(allows(0, "edge"), 500) << "a handle without a hand";
  r.ladder = RestLadder{GainAxis::object, 0, {{450, Swing{"flat", "limp", 0, 4}, 3}, {300, {}, 2}}};
  EXPECT_DOUBLE_EQ(allows(0, "edge"), 300);
  EXPECT_EQ(allowed_at(r, GainAxis::object, 4, "flat")->reason, "rest");
  EXPECT_DOUBLE_EQ(allows(4, "edge"), 200);
  r.ladder->rungs.pop_back();
  EXPECT_EQ(allows(4), 0) << "nothing rests";
}

// A heavy handle of little damping swings slower than 5 Hz where the loop first feeds it.
TEST(GainRecommendation, a_handle_that_swings_slowly_once_let_go_caps_the_object_norm) {
  for (const Coupling::Mode mode : {Coupling::Mode::object, Coupling::Mode::damped}) {
    TuningResults r = stable_up_to({1500});
    const GainAxis axis = mode == Coupling::Mode::object ? GainAxis::object : GainAxis::damped;
    r.mode = mode;
    r.lines[0].axis = axis;
    r.lines[0].columns[0].theory_released_any_swing = 300;
    const auto slow = recommend(r, axis);
    EXPECT_DOUBLE_EQ(slow->stiffness, 200);
    EXPECT_EQ(slow->limit.reason, "released");
    r.always_held = true;
    EXPECT_DOUBLE_EQ(recommend(r, axis)->stiffness, 1000);
  }
  TuningResults r = stable_up_to({1500});
  r.mode = Coupling::Mode::classic;
  r.lines[0].axis = GainAxis::translation;
  r.lines[0].columns[0].theory_released_any_swing = 300;
  EXPECT_DOUBLE_EQ(recommend(r, GainAxis::translation)->stiffness, 1000) << "said, but no cap";
}

// Reference: the loop's own rule, worked out: at most the driver's largest stiffness, and in the
// object norm its largest rotational one over 1.2 Î, whatever a contact feels.
TEST(GainRecommendation, nothing_is_recommended_that_the_loop_renders_as_less) {
  TuningResults r = stable_up_to({1500});
  r.felt = {{0.1, 1e-6}};
  EXPECT_DOUBLE_EQ(recommend(r, GainAxis::object)->stiffness, 1000);
  r.largest_inertia = 0.2;
  const auto by_turn = recommend(r, GainAxis::object);
  EXPECT_DOUBLE_EQ(by_turn->stiffness, 100 / (1.2 * 0.2));
  EXPECT_EQ(by_turn->limit.reason, "rendered");
  r.largest_inertia = 0;  // unknown, of studies before it was told
  r.device["max_stiffness"] = 300;
  EXPECT_DOUBLE_EQ(recommend(r, GainAxis::object)->stiffness, 300);
  r.mode = Coupling::Mode::classic;
  r.joint = {2, 0};
  r.lines = {line(0, GainAxis::together, {column(0, 1500)}),
             line(0, GainAxis::translation, {column(0, 1500)}),
             line(0, GainAxis::rotation, {column(0, 1500)})};
  EXPECT_DOUBLE_EQ(recommend(r, GainAxis::together)->stiffness, 50) << "k_r of twice that";
  EXPECT_DOUBLE_EQ(recommend(r, GainAxis::translation)->stiffness, 300);
  EXPECT_DOUBLE_EQ(recommend(r, GainAxis::rotation)->stiffness, 100);
  r.device["max_stiffness"] = r.device["max_rotational_stiffness"] = 0;  // unknown
  EXPECT_DOUBLE_EQ(recommend(r, GainAxis::rotation)->stiffness, 1000);
}

}  // namespace
}  // namespace sonde
