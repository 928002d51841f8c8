// SPDX-License-Identifier: GPL-3.0-or-later
// Reference: made-up holds whose limits are known.
#include "engine/study/stiffness_sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "engine/error.hpp"

namespace sonde {
namespace {

const Stop never = [] { return false; };

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

TEST(StiffnessSweep, FindsBothLimitsToTheRatioFromAnyStart) {
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
      EXPECT_LT(made.runs, 60);
    }
}

TEST(StiffnessSweep, ALimitOutsideOfTheRangeIsSaid) {
  MadeUp high{1e9, 1e9};
  StiffnessSweep sweep = sweep_stiffness(std::ref(high), {.high = 1e5}, never);
  EXPECT_EQ(sweep.stable.stiffness, 1e5);
  EXPECT_EQ(sweep.stable.fault, HoldFault::none);
  MadeUp low{1, 1};
  sweep = sweep_stiffness(std::ref(low), {.low = 1}, never);
  EXPECT_EQ(sweep.stable.stiffness, 0);
  EXPECT_EQ(sweep.stable.fault, HoldFault::unstable);
}

TEST(StiffnessSweep, StopsWhenAsked) {
  MadeUp made{800, 2000};
  EXPECT_THROW(sweep_stiffness(std::ref(made), {}, [&] { return made.runs >= 3; }), Cancelled);
  EXPECT_EQ(made.runs, 3);
}

TEST(StiffnessSweep, TheWorstFaultIsNamed) {
  HoldReport report;
  EXPECT_STREQ(name_of(fault_of(report)), "stability");
  report.stable = report.chattering = report.saturated = true;
  EXPECT_STREQ(name_of(fault_of(report)), "saturation");
  report.saturated = false;
  EXPECT_STREQ(name_of(fault_of(report)), "chatter");
  report.chattering = false;
  report.force_error = 0.11;
  EXPECT_STREQ(name_of(fault_of(report)), "fidelity");
  report.force_error = 0.09;
  EXPECT_STREQ(name_of(fault_of(report)), "none");
}

}  // namespace
}  // namespace sonde
