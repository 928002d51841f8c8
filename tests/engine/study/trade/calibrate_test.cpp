// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/trade/calibrate.hpp"

#include <gtest/gtest.h>

#include "engine/base/numbers.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::test {
namespace {

TEST(Calibrate, a_depth_of_zero_is_exact_where_the_true_depth_is) {
  const Pair pair{body(box(Vec3::Constant(0.1))), body(box(Vec3::Constant(0.1)))};
  const std::vector<Pose> apart{{Quat::Identity(), Vec3(1, 0, 0)}};
  const CalibrationSeries series =
      calibrate_searches(pair, "boxes", Method::pdg, apart, {0.0}, 1, [] { return false; });
  ASSERT_FALSE(series.points.empty());
  for (const CalibrationPoint& point : series.points)
    EXPECT_EQ(point.errors, std::vector<double>{0}) << point.time_us;
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
