// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/trade/calibrate.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/base/error.hpp"
#include "engine/base/numbers.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::test {
namespace {

TEST(Calibrate, a_depth_of_zero_is_exact_where_the_true_depth_is) {
  const Pair pair{body(box(Vec3::Constant(0.1))), body(box(Vec3::Constant(0.1)))};
  const std::vector<Pose> apart{{Quat::Identity(), Vec3(1, 0, 0)}};
  const CalibrationSeries series = calibrate_searches(pair, "boxes", Method::pdg, apart, {0.0}, 1);
  ASSERT_FALSE(series.points.empty());
  for (const CalibrationPoint& point : series.points)
    EXPECT_EQ(point.errors, std::vector<double>{0}) << point.time_us;
}

TEST(Calibrate, says_how_far_it_is_and_can_be_stopped) {
  TradeSetup setup{.pair = {body(box(Vec3::Constant(0.1))), body(box(Vec3::Constant(0.1)))}};
  setup.poses = {{Quat::Identity(), Vec3(0.09, 0, 0)}};
  for (const double x : {0.11, 0.1, 0.09}) setup.path.push_back({x, {Quat::Identity(), {x, 0, 0}}});
  std::vector<double> told;
  calibrate(setup, [&](double fraction) {
    told.push_back(fraction);
    return true;
  });
  EXPECT_GT(told.size(), 40u) << "each search and each tick";
  EXPECT_TRUE(std::ranges::is_sorted(told));
  EXPECT_EQ(told.front(), 0);
  EXPECT_GT(told.back(), 0.9);
  EXPECT_LT(told.back(), 1);
  EXPECT_THROW(calibrate(setup, [](double fraction) { return fraction < 0.5; }), Cancelled);
}

TEST(Calibrate, a_tick_is_wrong_by_what_it_is_too_deep) {
  EXPECT_DOUBLE_EQ(tick_error(3, 2, 4), 0.25);
  EXPECT_EQ(tick_error(2, 2, 4), 0);
  EXPECT_EQ(tick_error(1, 2, 4), 0) << "a shorter way out";
  EXPECT_EQ(tick_error(0, 0, 0), 0);
  EXPECT_EQ(tick_error(infinity, 2, 4), infinity);
  EXPECT_EQ(tick_error(2, infinity, 4), infinity);
}

}  // namespace
}  // namespace sonde::test
