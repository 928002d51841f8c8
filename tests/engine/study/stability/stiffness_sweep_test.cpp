// SPDX-License-Identifier: GPL-3.0-or-later
// Reference: made-up holds whose limits are known.
#include "engine/study/stability/stiffness_sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/base/error.hpp"
#include "tests/engine/study/never.hpp"

namespace sonde {
namespace {

using test::never;

/// Saturated from one stiffness on, unstable from another.
struct MadeUp {
  double saturated, unstable;
  int runs = 0;

  HoldReport operator()(double k) {
    ++runs;
    HoldReport report;
    report.stable = k < unstable;
    report.saturated = k >= saturated;
    return report;
  }
};

TEST(StiffnessSweep, finds_both_limits_to_the_ratio_from_any_start) {
  for (const double start : {1.0, 30.0, 799.0, 1500.0, 9e4})
    for (const double ratio : {1.02, 1.002}) {
      MadeUp made{800, 2000};
      const StiffnessSweep sweep =
          sweep_stiffness(std::ref(made), {.start = start, .ratio = ratio}, never);
      EXPECT_LE(sweep.good.stiffness, 800);
      EXPECT_GT(sweep.good.stiffness * ratio, 800) << start;
      EXPECT_EQ(sweep.good.fault, HoldFault::saturated);
      EXPECT_LE(sweep.stable.stiffness, 2000);
      EXPECT_GT(sweep.stable.stiffness * ratio, 2000) << start;
      EXPECT_EQ(sweep.stable.fault, HoldFault::unstable);
      EXPECT_EQ(std::size_t(made.runs), sweep.points.size());  // none twice
      EXPECT_TRUE(std::ranges::is_sorted(sweep.points, {}, &SweepPoint::stiffness));
      EXPECT_LT(made.runs, 100);
    }
}

/// Unstable between two stiffnesses and above a third; slow to die down near the first two.
struct WithIsland {
  double from, to, end;

  HoldReport operator()(double k) const {
    HoldReport report;
    report.stable = (k < from || k > to) && k < end;
    report.growth = k > from / 1.5 && k < to * 1.5 ? 0.5 : 0;
    return report;
  }
};

TEST(StiffnessSweep, a_stable_island_above_an_unstable_stiffness_is_not_taken_for_stable) {
  // The second is narrower than a step of the walk: the swing on its shore gives it away.
  for (const WithIsland island : {WithIsland{300, 600, 5000}, WithIsland{300, 330, 5000}})
    for (const double start : {500.0, 1000.0}) {
      const StiffnessSweep sweep = sweep_stiffness(island, {.start = start}, never);
      EXPECT_LE(sweep.stable.stiffness, island.from);
      EXPECT_GT(sweep.stable.stiffness * 1.02, island.from) << start;
      EXPECT_EQ(sweep.stable.fault, HoldFault::unstable);
      EXPECT_LE(sweep.good.stiffness, sweep.stable.stiffness);
      // Well above it holds again, as the map shows.
      EXPECT_TRUE(std::ranges::any_of(
          sweep.points, [](const SweepPoint& p) { return p.stiffness > 700 && p.report.stable; }));
    }
}

TEST(StiffnessSweep, no_limit_lies_above_a_fault_that_was_seen) {
  // Holds and fails by turns, as wide as it likes.
  const auto patches = [](double k) {
    HoldReport report;
    report.stable = std::sin(7 * std::log(k)) > -0.5;
    report.saturated = std::sin(17 * std::log(k)) > 0.5;
    return report;
  };
  for (const double start : {40.0, 200.0, 900.0, 4000.0}) {
    const StiffnessSweep sweep = sweep_stiffness(patches, {.start = start}, never);
    for (const SweepPoint& p : sweep.points) {
      EXPECT_TRUE(p.report.stable || p.stiffness > sweep.stable.stiffness) << start;
    }
    EXPECT_LE(sweep.good.stiffness, sweep.stable.stiffness);
  }
}

TEST(StiffnessSweep, what_is_too_soft_to_be_good_is_no_limit) {
  const auto slips = [](double k) {
    HoldReport report;
    report.stable = k < 2000;
    report.force_error = k < 200 ? 0.2 : 0.01;
    return report;
  };
  const StiffnessSweep sweep = sweep_stiffness(slips, {.start = 500}, never);
  EXPECT_GT(sweep.good.stiffness * 1.02, 2000);
  EXPECT_EQ(sweep.good.fault, HoldFault::unstable);
}

TEST(StiffnessSweep, a_good_range_narrower_than_a_step_of_the_walk_is_found) {
  // Too soft below, chattering above: with the largest steps the walk comes by 125, 250, 500, 1000.
  for (const double soft : {260.0, 330.0, 450.0})
    for (const double width : {1.05, 1.1}) {
      const auto narrow = [&](double k) {
        HoldReport report;
        report.stable = k < 3000;
        report.force_error = k < soft ? 0.2 : 0.01;
        report.chattering = k > width * soft;
        return report;
      };
      const StiffnessSweep sweep = sweep_stiffness(narrow, {.start = 500, .ratio = 1.0443}, never);
      EXPECT_LE(sweep.good.stiffness, width * soft);
      EXPECT_GT(sweep.good.stiffness * 1.0443, width * soft) << soft;
      EXPECT_EQ(sweep.good.fault, HoldFault::chattering);
    }
}

TEST(StiffnessSweep, where_nothing_is_good_it_says_so) {
  const auto never_good = [](double k) {
    HoldReport report;
    report.stable = k < 3000;
    report.force_error = k < 300 ? 0.2 : 0.01;
    report.chattering = k >= 300;
    return report;
  };
  const StiffnessSweep sweep = sweep_stiffness(never_good, {.start = 500}, never);
  EXPECT_EQ(sweep.good.stiffness, 0);
  EXPECT_LE(sweep.stable.stiffness, 3000);
  EXPECT_GT(sweep.stable.stiffness * 1.1, 3000);
  EXPECT_EQ(sweep.points.front().stiffness, 1);  // it looked all the way down
}

TEST(StiffnessSweep, a_limit_outside_of_the_range_is_said) {
  MadeUp high{1e9, 1e9};
  StiffnessSweep sweep = sweep_stiffness(std::ref(high), {.high = 1e5}, never);
  EXPECT_EQ(sweep.stable.stiffness, 1e5);
  EXPECT_EQ(sweep.stable.fault, HoldFault::none);
  MadeUp low{1, 1};
  sweep = sweep_stiffness(std::ref(low), {.low = 1}, never);
  EXPECT_EQ(sweep.stable.stiffness, 0);
  EXPECT_EQ(sweep.stable.fault, HoldFault::unstable);
}

TEST(StiffnessSweep, a_second_condition_is_searched_for_from_its_guess) {
  const auto swings = [](double k) {
    HoldReport report;  // out of contact, so never "stable"
    report.growth = k < 700 ? 0.5 : 1;
    return report;
  };
  for (const double start : {20.0, 560.0, 3000.0}) {
    int runs = 0;
    const auto counted = [&](double k) {
      ++runs;
      return swings(k);
    };
    const SweepLimit limit = search_limit(counted, comes_to_rest, {.start = start}, never);
    EXPECT_LE(limit.stiffness, 700);
    EXPECT_GT(limit.stiffness * 1.02, 700) << start;
    EXPECT_EQ(limit.fault, HoldFault::unstable);
    EXPECT_LT(runs, start == 560 ? 10 : 100);
  }
  const SweepLimit none = search_limit(swings, comes_to_rest, {.start = 100, .high = 400}, never);
  EXPECT_EQ(none.stiffness, 400);
  EXPECT_EQ(none.fault, HoldFault::none);
  const SweepLimit nothing =
      search_limit(swings, comes_to_rest, {.start = 2000, .low = 1000}, never);
  EXPECT_EQ(nothing.stiffness, 0);
  EXPECT_EQ(nothing.fault, HoldFault::unstable);
  EXPECT_THROW(search_limit(swings, comes_to_rest, {}, [] { return true; }), Cancelled);
}

TEST(StiffnessSweep, what_is_knocked_out_of_a_contact_has_come_to_rest) {
  HoldReport report;
  report.stable = false;
  report.growth = 0.1;
  EXPECT_TRUE(comes_to_rest(report));
  report.growth = 0.96;
  EXPECT_FALSE(comes_to_rest(report));
  report.growth = 0;
  report.failures = 1;
  EXPECT_FALSE(comes_to_rest(report));
}

TEST(StiffnessSweep, stops_when_asked) {
  MadeUp made{800, 2000};
  EXPECT_THROW(sweep_stiffness(std::ref(made), {}, [&] { return made.runs >= 3; }), Cancelled);
  EXPECT_EQ(made.runs, 3);
}

TEST(StiffnessSweep, the_worst_fault_is_named) {
  const auto fault = [](const HoldReport& r) { return name_of(fault_of(r, GainAxis::object)); };
  HoldReport report;
  EXPECT_STREQ(fault(report), "stability");
  report.stable = report.chattering = report.saturated = true;
  EXPECT_STREQ(fault(report), "saturation");
  report.saturated = false;
  EXPECT_STREQ(fault(report), "chatter");
  report.chattering = false;
  report.force_error = 0.11;
  EXPECT_STREQ(fault(report), "fidelity");
  report.force_error = 0.09;
  EXPECT_STREQ(fault(report), "none");
}

TEST(StiffnessSweep, each_axis_is_judged_by_its_own_error) {
  HoldReport force, torque;
  force.stable = torque.stable = true;
  force.force_error = torque.torque_error = 0.11;
  using enum GainAxis;
  for (const GainAxis axis : {object, translation, together})
    EXPECT_EQ(fault_of(force, axis), HoldFault::unfaithful) << name_of(axis);
  for (const GainAxis axis : {rotation, together})
    EXPECT_EQ(fault_of(torque, axis), HoldFault::unfaithful) << name_of(axis);
  EXPECT_EQ(fault_of(force, rotation), HoldFault::none);
  EXPECT_EQ(fault_of(torque, translation), HoldFault::none);
}

}  // namespace
}  // namespace sonde
