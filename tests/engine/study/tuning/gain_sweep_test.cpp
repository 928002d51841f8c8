// SPDX-License-Identifier: GPL-3.0-or-later
// Gains in the closed loop: what a sweep's limits and holds mean there, for seconds and minutes.
#include "engine/study/tuning/gain_sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "engine/study/tuning/gain_recommendation.hpp"
#include "engine/study/tuning/tuning_report.hpp"
#include "tests/engine/study/tuning/tuning_requests.hpp"

namespace sonde {
namespace {

using test::in_scene;
using test::never;
using test::pressed_boxes;
using test::spoon_in_cup;
using test::tuned;

/// What a lab may meet, as multiples: of the profile's friction, of the knock of a sweep.
struct Met {
  double friction = 1, knock = 1;
};

/// With the knock of a sweep: what a push alone does not set swinging could pass for stable.
HoldReport hold(const TuningRequest& request, const TuningSituation& at, const TuningLine& line,
                const Coupling& gains, double seconds, const Met& met = {}) {
  const auto grip = std::ranges::find(hand_grips, line.hand, &HandGrip::name);
  TuningSetup setup = tuning_setup(request, at, *grip);
  setup.loop.coupling = gains;
  setup.loop.device.translation.friction *= met.friction;
  setup.loop.device.rotation.friction *= met.friction;
  Press press = press_of(setup, line.axis);
  press.knock *= met.knock;
  press.jolt.force *= met.knock;
  press.jolt.torque *= met.knock;
  press.window_time = seconds / 2;
  ClosedLoop loop(setup.loop);
  return press_and_hold(loop, press);
}

/// In the second half of the time: at rest; not swinging harder than in the first; not at rest.
enum class Expected { rest, no_growth, swing, nothing };
using Expectation = std::function<Expected(const TuningLine&, const Met&)>;
Expected always_rest(const TuningLine&, const Met&) { return Expected::rest; }
Expected rest_with_friction(const TuningLine&, const Met& met) {
  return met.friction < 0.5 ? Expected::no_growth : Expected::rest;
}

bool as_expected(const HoldReport& held, Expected expected) {
  if (expected == Expected::no_growth) return held.growth < 1;
  return comes_to_rest(held) == (expected == Expected::rest);
}

/// Lines of other axes say what one damper could do by itself, for the map.
bool is_recommended(const TuningLine& line, const TuningResults& results) {
  return line.axis == recommended_axes(results).front();
}

void expect_rest_in_every_situation(const TuningRequest& request, double seconds,
                                    const Expectation& expectation = always_rest) {
  const TuningResults results = tuned(request);
  const auto gains = recommend(results, recommended_axes(results).front());
  ASSERT_TRUE(gains);
  testing::Test::RecordProperty("stiffness", std::to_string(gains->stiffness));
  ASSERT_GT(gains->stiffness, 0) << "there is nothing to hold";
  const auto situations = tuning_contacts(request, never).situations;
  const Coupling coupling = recommended_coupling(results);
  for (const TuningLine& line : results.lines) {
    if (!is_recommended(line, results)) continue;
    for (const double friction : {0.0, 0.5, 1.0, 2.0})
      for (const double knock : {1.0, 2.0, 4.0}) {
        const Met met{friction, knock};
        const Expected expected = expectation(line, met);
        if (expected == Expected::nothing) continue;
        const HoldReport held =
            hold(request, situations[line.situation], line, coupling, seconds, met);
        EXPECT_TRUE(as_expected(held, expected))
            << line.kind << ' ' << line.hand << " friction x " << friction << " knock x " << knock
            << ": " << held.growth << ' ' << held.contact;
      }
  }
}

/// At 1.3 × its boundaries a line does what ends them: at the usual knock in a sweep's time (in
/// many seconds friction may end what does not die down in a fraction); without friction, in that
/// time or in a longer one (what ends in a lasting swing may die down to that in a fraction, and
/// what bounces out of contact for most of a fraction may come to rest later); at a harder knock
/// where that has a boundary of its own, in a longer time.
void expect_fault_beyond(const TuningRequest& request, const TuningSituation& at,
                         const TuningLine& line, const TuningColumn& column,
                         const TuningResults& results) {
  const auto beyond = [&](const SweepLimit& limit, const Met& met, double seconds) {
    EXPECT_GT(limit.stiffness, 0);
    Coupling gains = recommended_coupling(results);
    set_gains(gains, line.axis, 1.3 * limit.stiffness, column.damping, results.joint);
    return hold(request, at, line, gains, seconds, met);
  };
  if (column.stable.fault != HoldFault::none) {
    EXPECT_FALSE(beyond(column.stable, {}, 0.6).stable);
  }
  ASSERT_TRUE(column.without_friction && column.harder_knocks);
  if (column.without_friction->fault != HoldFault::none && !column.without_friction_by_theory) {
    const auto is_stable = [&](double seconds) {
      return beyond(*column.without_friction, {.friction = 0}, seconds).stable;
    };
    EXPECT_FALSE(is_stable(0.6) && is_stable(4));
  }
  if (column.harder_knocks->stiffness < column.stable.stiffness) {
    const auto rests = [&](double knock) {
      return comes_to_rest(beyond(*column.harder_knocks, {.knock = knock}, 4));
    };
    EXPECT_FALSE(rests(2) && rests(4));
  }
}

/// Every situation and hand: for `seconds` at the recommended gains, and beyond its own boundaries.
void expect_recommendation_holds(const TuningRequest& request, double seconds) {
  const TuningResults results = tuned(request);
  const Coupling gains = recommended_coupling(results);
  const double damping = recommend(results, recommended_axes(results).front())->damping;
  testing::Test::RecordProperty("gains", std::to_string(gains.k) + " " + std::to_string(gains.k_t) +
                                             " " + std::to_string(gains.k_r) + " " +
                                             std::to_string(gains.b_t));
  const auto situations = tuning_contacts(request, never).situations;
  for (const TuningLine& line : results.lines) {
    if (!is_recommended(line, results)) continue;
    const TuningSituation& at = situations[line.situation];
    SCOPED_TRACE(line.kind + " " + line.hand);
    const HoldReport held = hold(request, at, line, gains, seconds);
    EXPECT_TRUE(held.stable) << held.growth << ' ' << held.contact;
    const auto column = std::ranges::find(line.columns, damping, &TuningColumn::damping);
    expect_fault_beyond(request, at, line, *column, results);
  }
}

TEST(Tuning, the_recommended_gains_come_to_rest_whatever_the_friction_and_the_knock) {
  TuningRequest request = pressed_boxes();
  request.device.mass.assumed = false;
  request.ratio = 1.1;
  expect_rest_in_every_situation(request, 0.6);
}
TEST(Tuning, Full_they_do_for_a_minute_in_the_cup) {
  expect_rest_in_every_situation(spoon_in_cup(), 60);
}
// Where the recommendation says that the probe swings on, it does so for the minute: without
// friction, and after the hardest knock. The rest that is left out, friction ends in one contact
// and not in another.
TEST(Tuning, Full_those_of_the_classic_coupling_do_while_the_knock_is_small_for_the_friction) {
  TuningRequest request = spoon_in_cup();
  request.coupling.mode = Coupling::Mode::classic;
  const auto expectation = [](const TuningLine& line, const Met& met) {
    // Only the damping that is recommended is held for seconds.
    const auto column = std::ranges::find_if(
        line.columns, [](const TuningColumn& one) { return one.long_hold.has_value(); });
    if (column == line.columns.end()) {
      ADD_FAILURE() << line.kind << ' ' << line.hand << ": not held";
      return Expected::nothing;
    }
    const LongHold& held = *column->long_hold;
    const auto said = [](bool swings) { return swings ? Expected::swing : Expected::rest; };
    if (met.friction == 0 && met.knock == 1) return said(held.swings_without_friction);
    if (met.friction == 1 && met.knock == std::ranges::max(harder_knocks))
      return said(held.swings_at_harder_knocks);
    if (line.hand == "firm" || met.knock <= 2 * met.friction) return Expected::rest;
    return Expected::nothing;
  };
  expect_rest_in_every_situation(request, 60, expectation);
}

/// A scene, and the device that it is felt on. Without any friction what swings may take longer
/// than a minute: in the edge contact of the peg, knocked four times as hard, 5 % of its energy are
/// gone from one half of the minute to the other.
using Felt = std::pair<const char*, const char*>;
class HeldForAMinute : public testing::TestWithParam<Felt> {};

TEST_P(HeldForAMinute, Full_whatever_the_friction_and_the_knock) {
  const auto& [scene, device] = GetParam();
  expect_rest_in_every_situation(in_scene(scene, device), 60, rest_with_friction);
}
INSTANTIATE_TEST_SUITE_P(Felt, HeldForAMinute,
                         testing::Values(Felt("torus-knots", "omega.7"),
                                         Felt("linked-tori", "touch"), Felt("terrain", "touch-x"),
                                         Felt("crumpled-soup", "lambda.7"),
                                         Felt("nut-on-bolt", "premium-1.5-6dof"),
                                         Felt("peg-in-hole", "premium-3.0-6dof")));

/// What a sweep says of holds of seconds, in the first contact by a light hand.
nlohmann::json held(const TuningPlan& plan, GainAxis axis, double stiffness) {
  const SweepExtent extent{.long_hold = stiffness};
  return nlohmann::json::parse(
             sweep_gains(tuning_setup(plan, 0, hand_grips[0]), axis, {0}, extent, never))
      .at("columns")
      .at(0)
      .at("long_hold");
}

// A hand whose torque has a potential gives nothing to a swing: then the classic coupling comes to
// rest there too, at any of these stiffnesses, as the object norm does. (A torque that kept its
// direction swung it on for ever, and looked like a fault of the coupling.)
TEST(Tuning, Full_without_friction_the_classic_coupling_comes_to_rest_in_the_flat_contact) {
  TuningRequest request = spoon_in_cup();
  request.coupling.mode = Coupling::Mode::classic;
  const TuningPlan plan = tuning_plan(request, never);
  ASSERT_EQ(plan.contacts.situations[0].contact.kind, ContactKind::flat);
  for (const double k : {172.0, 400.0, 551.0, 1801.0}) {
    TuningSetup setup = tuning_setup(plan, 0, hand_grips[0]);
    set_gains(setup.loop.coupling, GainAxis::together, k, 0, plan.joint);
    setup.loop.device.translation.friction = setup.loop.device.rotation.friction = 0;
    ClosedLoop loop(setup.loop);
    const RestReport held = press_until_rest(loop, press_of(setup, GainAxis::together));
    EXPECT_TRUE(held.at_rest) << k << ": " << held.kinetic << " J, " << held.frequency << " Hz";
  }
  request.coupling.mode = Coupling::Mode::object;
  const auto object = held(tuning_plan(request, never), GainAxis::object, 344);
  EXPECT_FALSE(object.at("swings_without_friction").get<bool>());
}

TEST(Tuning, dampings_are_evenly_spaced_by_ratio_from_below_a_tenth_of_critical) {
  TuningRequest request = spoon_in_cup();
  request.coupling.mode = Coupling::Mode::classic;
  const TuningPlan plan = tuning_plan(request, never);
  const TuningSetup setup = tuning_setup(plan, 0, hand_grips[0]);
  const double per = setup.rotation_per_translation;
  const auto& device = setup.loop.device;
  for (const GainAxis axis : {GainAxis::together, GainAxis::together_b_t, GainAxis::together_b_r}) {
    std::vector<double> shares = damping_shares(setup, axis);
    if (axis == GainAxis::together) {
      EXPECT_EQ(shares[0], 0);
      shares.erase(shares.begin());
    }
    ASSERT_GE(shares.size(), 3u) << name_of(axis);
    EXPECT_EQ(shares.back(), 1);
    for (std::size_t i = 1; i < shares.size(); ++i)
      EXPECT_NEAR(shares[i] / shares[i - 1], shares[1] / shares[0], 1e-12);
    const bool turns = axis == GainAxis::together_b_r;
    const double b = shares[0] * most_damping(setup, axis);
    const double inertia = turns ? device.rotation.inertia : device.translation.inertia;
    const double critical = 2 * std::sqrt(200 * (turns ? per : 1) * inertia);
    EXPECT_LT(b / critical, 0.1) << name_of(axis) << " on a spring as soft as the light hand";
  }
}

TEST(Tuning, each_damper_is_varied_by_itself_too) {
  TuningRequest request = pressed_boxes();
  request.coupling.mode = Coupling::Mode::classic;
  const auto plan = study_plan(request, 2, never);
  const TuningResults results = read_tuning("", compute_at_once(plan_tuning(plan), 2, never));
  for (const GainAxis axis : {GainAxis::together_b_t, GainAxis::together_b_r}) {
    const auto each = recommend_at_each_damping(results, axis);
    ASSERT_GE(each.size(), 3u) << name_of(axis);
    EXPECT_GT(each.front().damping, 0) << "none is the same as of both";
    EXPECT_GT(each.front().boundary, 0);
  }
  EXPECT_EQ(recommended_axes(results), std::vector{plan->axis});
}

// Reference: theory, of the one contact without friction. Far below its limit the probe comes to
// rest, and at twice that it cannot.
TEST(Tuning, holds_of_seconds_tell_a_lasting_swing_from_rest) {
  TuningRequest request = pressed_boxes();
  for (const auto mode : {Coupling::Mode::object, Coupling::Mode::classic}) {
    request.coupling.mode = mode;
    const TuningPlan plan = tuning_plan(request, never);
    const GainAxis axis = main_axis(request);
    const double limit = theory_limits(tuning_setup(plan, 0, hand_grips[0]), axis, 0).stable;
    const auto soft = held(plan, axis, limit / 4), stiff = held(plan, axis, 2 * limit);
    EXPECT_EQ(soft.at("stiffness"), limit / 4);
    EXPECT_FALSE(soft.at("swings_without_friction").get<bool>());
    EXPECT_FALSE(soft.at("swings_at_harder_knocks").get<bool>());
    EXPECT_TRUE(stiff.at("swings_without_friction").get<bool>());
    EXPECT_FALSE(stiff.at("swings_at_harder_knocks").get<bool>()) << "friction ends it";
  }
}

TEST(Tuning, what_the_holds_of_seconds_show_is_in_the_recommendation) {
  TuningRequest request = pressed_boxes();
  request.device.mass.assumed = false;
  const auto plan = study_plan(request, 1, never);
  ASSERT_GT(plan->held_stiffness, 0);
  StudyFolder study = compute_at_once(plan_tuning(plan), 2, never);
  const auto said = [&] {
    for (const StudyFile& file : tuning_files("", study))
      if (file.name == "recommendation.json")
        return nlohmann::json::parse(file.text).at("axes").at(0);
    return nlohmann::json();
  };
  // The ladder's rung, which is the first look's result here; without it, what each line says.
  EXPECT_DOUBLE_EQ(said().at("held_for_seconds_at").get<double>(), plan->held_stiffness);
  EXPECT_GT(said().at("longest_to_rest").get<double>(), 0);
  ASSERT_EQ(study.names.front(), ladder_part);
  study.names.erase(study.names.begin());
  study.results.erase(study.results.begin());
  EXPECT_EQ(said().at("held_for_seconds_at"), plan->held_stiffness);
  EXPECT_TRUE(said().at("swings_without_friction_in").empty());
  EXPECT_TRUE(said().at("swings_at_harder_knocks_in").is_array());
  for (const char* key : {"swings_without_friction", "swings_at_harder_knocks"}) {
    const StudyFolder quiet = study;
    nlohmann::json part = nlohmann::json::parse(*study.results[0]);
    part["columns"][0]["long_hold"][key] = true;
    study.results[0] = part.dump();
    ASSERT_EQ(said().at(std::string(key) + "_in").size(), 1u);
    EXPECT_EQ(said().at(std::string(key) + "_in")[0].at("hand"), "light");
    study = quiet;
  }
  nlohmann::json part = nlohmann::json::parse(*study.results[0]);
  for (auto& result : study.results) {
    part = nlohmann::json::parse(*result);
    part["columns"][0].erase("long_hold");
    result = part.dump();
  }
  EXPECT_TRUE(said().at("held_for_seconds_at").is_null());
  EXPECT_TRUE(said().at("swings_without_friction_in").is_null()) << "nobody looked";
}

// A device without friction: hard knocks are hard for it too, and what swings on is said.
TEST(Tuning, a_device_without_friction_is_knocked_and_held_as_others_are) {
  TuningRequest request = pressed_boxes();
  request.device.mass.assumed = false;
  request.device.friction.value = request.device.rotational_friction.value = 0;
  const TuningResults results = tuned(request);
  for (const TuningLine& line : results.lines) {
    EXPECT_TRUE(line.columns.front().harder_knocks) << line.kind << ' ' << line.hand;
    EXPECT_TRUE(line.columns.front().long_hold) << line.kind << ' ' << line.hand;
  }
}

TEST(Tuning, without_friction_the_boundary_is_that_of_a_profile_that_has_none) {
  TuningRequest request = pressed_boxes();
  request.device.mass.assumed = false;
  request.ratio = 1.02;
  // The firm hand's lie further above what the driver takes than a search goes.
  request.device.max_stiffness.value *= 10;
  request.device.max_rotational_stiffness.value *= 10;
  const TuningResults results = tuned(request);
  request.device.friction.value = request.device.rotational_friction.value = 0;
  const TuningResults smooth = tuned(request);
  ASSERT_EQ(results.lines.size(), smooth.lines.size());
  for (std::size_t i = 0; i < results.lines.size(); ++i) {
    const TuningColumn& column = results.lines[i].columns.front();
    const TuningColumn& reference = smooth.lines[i].columns.front();
    ASSERT_TRUE(column.without_friction && column.harder_knocks);
    EXPECT_FALSE(reference.without_friction);
    ASSERT_TRUE(reference.harder_knocks) << "knocks are hard without friction too";
    // Each is known to the ratio, from its own side.
    EXPECT_NEAR(column.without_friction->stiffness / reference.stable.stiffness, 1, 0.02)
        << results.lines[i].kind << ' ' << results.lines[i].hand;
    EXPECT_LT(column.without_friction->stiffness, column.stable.stiffness);
    EXPECT_FALSE(column.without_friction_by_theory);
    EXPECT_LE(column.harder_knocks->stiffness, column.stable.stiffness);
  }
}

TEST(Tuning, the_recommended_gains_hold_and_beyond_the_boundary_they_do_not) {
  TuningRequest request = pressed_boxes();
  request.device.mass.assumed = false;
  request.ratio = 1.02;
  expect_recommendation_holds(request, 5);
}
TEST(Tuning, Full_the_recommended_gains_hold_for_a_minute_in_every_situation) {
  expect_recommendation_holds(spoon_in_cup(), 60);
}
TEST(Tuning, Full_so_do_those_of_the_classic_coupling_together) {
  TuningRequest request = spoon_in_cup();
  request.coupling.mode = Coupling::Mode::classic;
  expect_recommendation_holds(request, 60);
}

}  // namespace
}  // namespace sonde
