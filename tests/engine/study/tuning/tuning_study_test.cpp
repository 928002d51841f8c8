// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/tuning/tuning_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/haptics/safety/borne_gains.hpp"
#include "engine/study/tuning/assumptions.hpp"
#include "engine/study/tuning/gain_recommendation.hpp"
#include "engine/study/tuning/tuning_words.hpp"
#include "tests/engine/study/never.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using test::never;

/// A box that comes down on a larger one.
TuningRequest boxes_held_by(const std::string& device) {
  TuningRequest request{
      .pair = {test::body(test::box({0.06, 0.05, 0.04})), test::body(test::box({0.2, 0.2, 0.1}))}};
  request.X_FM = {Quat::Identity(), {0, 0, 0.1}};
  request.device = read_device_profile(SONDE_RESOURCES "/devices/" + device + ".json");
  for (const ProfileKey& key : profile_keys()) (request.device.*key.value).assumed = false;
  for (int i = 0; i < 30; ++i)
    request.path.push_back({i * 1e-3, {Quat::Identity(), {0.01, 0.005, 0.075 - i * 2e-4}}});
  return request;
}

std::shared_ptr<const TuningPlan> plan_of(const TuningRequest& request) {
  return study_plan(request, 2, never);
}

AxisGains gains_of(const Study& study) {
  return *recommend(read_tuning("", compute_at_once(study, 2, never)), GainAxis::object);
}

// Reference: the study itself. Both know a limit from below, each to its own ratio.
TEST(TuningStudy, the_first_look_is_as_near_as_it_says) {
  const auto plan = plan_of(boxes_held_by("sigma.7"));
  const Study whole = plan_tuning(plan);
  EXPECT_LT(plan->first_look.names.size(), whole.parts.size());
  const AxisGains coarse = *recommend(read_tuning("", plan->first_look), GainAxis::object);
  const AxisGains fine = gains_of(whole);
  EXPECT_DOUBLE_EQ(fine.held_at, fine.stiffness) << "a rung of the ladder";
  EXPECT_GT(fine.stiffness, 0);
  EXPECT_LE(coarse.stiffness, 1.02 * fine.stiffness);
  EXPECT_GE(coarse.stiffness * first_look_ratio, fine.stiffness);
}

// Reference: the study of that coupling, with its runs.
TEST(TuningStudy, what_a_damper_may_allow_is_said_and_held_by_its_own_study) {
  TuningRequest request = boxes_held_by("sigma.7");
  request.ratio = 1.5;
  request.device.max_stiffness.value *= 20;  // so that the driver limits neither
  request.device.max_rotational_stiffness.value *= 20;
  const auto plain = plan_of(request);
  ASSERT_TRUE(plain->damper.has_value());
  EXPECT_GT(plain->damper->stiffness, plain->held_stiffness);
  request.coupling.mode = Coupling::Mode::damped;
  const auto damped = plan_of(request);
  EXPECT_FALSE(damped->damper.has_value());
  EXPECT_EQ(damped->axis, GainAxis::damped);
  EXPECT_GT(damped->damping_share, 0);
  EXPECT_LE(damped->held_stiffness, plain->damper->stiffness);
  EXPECT_GT(damped->held_stiffness, 1.5 * plain->held_stiffness);
  const Study study = plan_tuning(damped);
  const TuningResults results = read_tuning("", compute_at_once(study, 2, never));
  const Coupling gains = recommended_coupling(results);
  EXPECT_EQ(gains.mode, Coupling::Mode::damped);
  EXPECT_GT(gains.b_t, 0);
  EXPECT_NEAR(gains.k / damped->held_stiffness, 1, 0.5);
}

// Reference: the cap of the loop itself, on the gains that would be written.
TEST(TuningStudy, what_is_recommended_is_rendered_as_it_is) {
  TuningRequest request = boxes_held_by("sigma.7");
  request.ratio = 1.5;
  request.device.max_rotational_stiffness.value /= 10;
  const BorneGains most{request.device.max_stiffness.value,
                        request.device.max_rotational_stiffness.value};
  const auto plan = plan_of(request);
  const TuningResults results = read_tuning("", compute_at_once(plan_tuning(plan), 2, never));
  const Coupling gains = recommended_coupling(results);
  EXPECT_GT(gains.k, 0);
  EXPECT_FALSE(is_reduced(borne(gains, most, request.pair.probe().mass), gains)) << gains.k;
  EXPECT_EQ(recommend(results, GainAxis::object)->limit.reason, "rendered");
  EXPECT_LE(results.ladder->rungs.front().stiffness, 1.000001 * gains.k) << "nor tried";
}

// References: the recommendation of a study whose every run holds; the "driver" among its limits.
TEST(TuningStudy, nothing_is_looked_at_that_could_not_be_recommended) {
  for (const Coupling::Mode mode : {Coupling::Mode::object, Coupling::Mode::classic}) {
    TuningRequest request = boxes_held_by("sigma.7");
    request.coupling.mode = mode;
    const auto plan = plan_of(request);
    ASSERT_TRUE(std::isfinite(plan->unmeasured));
    EXPECT_LE(plan->held_stiffness, plan->unmeasured);
    const TuningResults first = read_tuning("", plan->first_look);
    for (const TuningLine& line : first.lines)
      for (const SweepPoint& run : line.columns.front().runs)
        EXPECT_LE(run.stiffness, 1.000001 * stability_margin * plan->unmeasured);
    const RestLadder ladder = climb_down(*plan, never);
    ASSERT_FALSE(ladder.rungs.empty());
    EXPECT_LE(ladder.rungs.front().stiffness,
              std::max(plan->unmeasured, plan->held_stiffness) * 1.000001);
    double driver = INFINITY;
    for (std::size_t i = 0; i < plan->contacts.situations.size(); ++i)
      driver = std::min(driver, driver_limit(*plan, i, plan->axis, request.device));
    EXPECT_GE(driver * 1.000001, plan->unmeasured);
    const AxisGains gains = *recommend(first, plan->axis);
    for (const GainLimit& limit : gains.limits)
      if (limit.reason == "driver") {
        EXPECT_NEAR(limit.stiffness / driver, 1, 1e-12);
      }
  }
}

TEST(TuningStudy, what_finished_parts_allow_only_falls_as_parts_come_in) {
  const auto plan = plan_of(boxes_held_by("sigma.7"));
  const StudyFolder whole = compute_at_once(plan_tuning(plan), 2, never);
  StudyFolder so_far = whole;
  for (auto& result : so_far.results) result.reset();
  EXPECT_FALSE(tuning_so_far("", so_far, GainAxis::object));
  double before = INFINITY;
  for (std::size_t i = whole.names.size(); i-- > 0;) {  // in any order; here from the last
    so_far.results[i] = whole.results[i];
    const auto results = tuning_so_far("", so_far, GainAxis::object);
    ASSERT_TRUE(results);
    const double now = recommend(*results, GainAxis::object)->stiffness;
    EXPECT_LE(now, before);
    before = now;
  }
  EXPECT_EQ(before, recommend(read_tuning("", whole), GainAxis::object)->stiffness);
}

// Theory prefers the largest damping here; a real loop chatters at it.
TEST(TuningStudy, assumed_values_are_varied_at_a_damping_at_which_something_is_good) {
  TuningRequest request = boxes_held_by("sigma.7");
  request.coupling.mode = Coupling::Mode::classic;
  const auto plan = plan_of(request);
  const TuningSetup setup = tuning_setup(*plan, hardest(*plan), hand_grips[0]);
  EXPECT_GT(theory_limits(setup, GainAxis::together, 1).stable,
            theory_limits(setup, GainAxis::together, plan->damping_share).stable);
  const TuningResults results = read_tuning("", plan->first_look);
  EXPECT_GT(recommend(results, GainAxis::together)->stiffness, 0);
}

// An interval that the search cannot tell apart is left out.
TEST(TuningStudy, a_measured_value_is_varied_between_the_ends_of_its_interval) {
  TuningRequest request = boxes_held_by("sigma.7");
  const double delay = request.device.delay.value;
  request.device.delay.interval = {0.8 * delay, 1.5 * delay};
  request.device.mass.interval = {0.99 * request.device.mass.value,
                                  1.005 * request.device.mass.value};
  const Study study = plan_tuning(plan_of(request));
  std::vector<std::string> varied;
  for (const StudyPart& part : study.parts)
    if (std::ranges::count(part.name, '.') > 2) varied.push_back(part.name);
  ASSERT_EQ(varied.size(), 2u);
  EXPECT_TRUE(varied[0].ends_with(".delay.low")) << varied[0];
  EXPECT_TRUE(varied[1].ends_with(".delay.high")) << varied[1];
  const TuningResults results = read_tuning("", compute_at_once(study, 2, never));
  const auto intervals = assumed_intervals(results, GainAxis::object);
  ASSERT_EQ(intervals.size(), 1u);
  EXPECT_DOUBLE_EQ(intervals[0].low.value, 0.8 * delay);
  EXPECT_DOUBLE_EQ(intervals[0].high.value, 1.5 * delay);
  const auto held = [](const AssumedEnd& end) {
    return std::min(end.gains.boundary, end.gains.without_friction);
  };
  EXPECT_GT(held(intervals[0].low), held(intervals[0].high)) << "a longer delay holds less";
}

// Reference: the search that such a part does not make, on the profile that it varies.
TEST(TuningStudy, parts_that_vary_a_friction_go_by_the_limit_without_any) {
  TuningRequest request = boxes_held_by("sigma.7");
  request.device.friction.assumed = true;
  const auto plan = plan_of(request);
  const TuningResults results = read_tuning("", compute_at_once(plan_tuning(plan), 2, never));
  int varied = 0;
  for (const TuningLine& line : results.lines) {
    if (line.assumed.empty()) continue;
    ++varied;
    DeviceProfile device = request.device;
    device.friction.value *= line.times;
    const TuningSetup setup = tuning_setup(*plan, line.situation, hand_grips[0], device);
    const auto searched = nlohmann::json::parse(
        sweep_gains(setup, GainAxis::object, {0}, {.without_friction = true, .in_full = 0}, never));
    const double reference = searched.at("columns").front().at("without_friction");
    ASSERT_TRUE(line.columns.front().without_friction) << line.times;
    EXPECT_DOUBLE_EQ(line.columns.front().without_friction->stiffness, reference);
  }
  EXPECT_EQ(varied, 2);
}

// Reference: the same sweep with every damping in full.
TEST(TuningStudy, limits_at_other_dampings_are_known_to_a_coarser_ratio) {
  TuningRequest request = boxes_held_by("sigma.7");
  request.coupling.mode = Coupling::Mode::classic;
  const auto plan = plan_of(request);
  const TuningSetup setup = tuning_setup(*plan, hardest(*plan), hand_grips[1]);
  const std::vector<double> shares{0, 0.125};
  const auto columns = [&](const SweepExtent& extent) {
    return nlohmann::json::parse(sweep_gains(setup, GainAxis::together, shares, extent, never))
        .at("columns");
  };
  const auto fine = columns({.beyond = true});
  const auto coarse = columns({.beyond = true, .in_full = 0});
  EXPECT_EQ(coarse[0], fine[0]);
  EXPECT_LT(coarse[1].at("runs").size(), fine[1].at("runs").size());
  const auto stiffest = [](const auto& column) {
    return column.at("runs").back().at("stiffness").template get<double>() /
           column.at("stable").template get<double>();
  };
  EXPECT_GT(stiffest(fine[1]), 3.9);
  EXPECT_LE(stiffest(coarse[1]), 1.001 * std::pow(setup.ratio, 16)) << "a step of the walk";
  const double known_to = coarse_ratio(setup.ratio);
  EXPECT_LE(known_to, 1.11 * std::pow(setup.ratio / 1.02, 5));
  for (const char* limit : {"stable", "good"}) {
    if (fine[1].at(limit) == 0) {  // nothing is faithful at that damping: neither finds anything
      EXPECT_STREQ(limit, "good");
      EXPECT_EQ(coarse[1].at(limit), 0);
      continue;
    }
    const double times = coarse[1].at(limit).get<double>() / fine[1].at(limit).get<double>();
    EXPECT_LE(times, setup.ratio) << limit;
    EXPECT_GE(times, 1 / known_to) << limit;
  }
}

TEST(TuningStudy, a_tick_may_take_what_the_servo_gives_it) {
  const auto counted = [](const Budget& budget, double accuracy = 0) {
    ServoSettings servo;
    servo.budget = budget;
    servo.accuracy = accuracy;
    return counted_budget(servo);
  };
  const Budget of_servo = counted({.steps = 0, .microseconds = 800});
  EXPECT_EQ(of_servo.work, 80'000);
  EXPECT_EQ(of_servo.microseconds, 0) << "a clock";
  EXPECT_EQ(of_servo.steps, 60);
  EXPECT_EQ(counted({.steps = 7, .microseconds = 0.001}).work, 1);
  EXPECT_EQ(counted({.steps = 7}).steps, 7);
  EXPECT_EQ(counted({}).work, 3'000'000);
  EXPECT_EQ(counted({.microseconds = 1e6}).work, 3'000'000);
  EXPECT_EQ(TuningRequest{.pair = boxes_held_by("sigma.7").pair}.budget.work, 80'000);
  EXPECT_EQ(counted({.microseconds = 100}, 0.01).work, 3'000'000) << "an accuracy goes before";
}

TEST(TuningStudy, a_sweep_without_anything_good_does_not_go_down_to_what_is_of_no_use) {
  TuningRequest request = boxes_held_by("sigma.7");
  request.coupling.mode = Coupling::Mode::classic;
  const auto plan = plan_of(request);
  const TuningSetup setup = tuning_setup(*plan, hardest(*plan), hand_grips[0]);
  const auto json = nlohmann::json::parse(sweep_gains(setup, GainAxis::together, {1}, {}, never));
  const auto& column = json.at("columns").front();
  EXPECT_EQ(column.at("good"), 0);
  EXPECT_DOUBLE_EQ(column.at("runs").front().at("stiffness").get<double>(),
                   column.at("theory_stable").get<double>() / 32);
}

// Where nothing resists a turn, a hand that pushes with a torque makes the handle spin ever faster.
TEST(TuningStudy, a_device_without_torque_is_pushed_by_a_force_alone) {
  const auto turns = plan_of(boxes_held_by("sigma.7")), slides = plan_of(boxes_held_by("touch"));
  for (const TuningSituation& each : slides->contacts.situations) {
    EXPECT_EQ(each.push.torque, Vec3(Vec3::Zero()));
    // A quarter of the 3.3 N of its profile.
    EXPECT_NEAR(each.push.force.norm(), 0.825, 1e-12);
  }
  bool any = false;
  for (const TuningSituation& each : turns->contacts.situations)
    any = any || each.push.torque.norm() > 0;
  EXPECT_TRUE(any);
}

}  // namespace
}  // namespace sonde
