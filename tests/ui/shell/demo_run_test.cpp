// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/demo_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/base/error.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::ui::test {
namespace {

/// A cube of 40 mm that goes along x into one of 100 mm, and half the way out again.
class DemoRunTest : public testing::Test {
 protected:
  static std::shared_ptr<const Body> cube(double side) {
    return sonde::test::body(sonde::test::box({side, side, side}));
  }
  static Pose at(double x) { return {Quat::Identity(), Vec3(x, 0.001, 0.002)}; }
  static Coupling gains() {
    Coupling coupling;
    coupling.k = 500;
    return coupling;
  }
  const Pair pair{cube(0.04), cube(0.1)};
  const std::vector<TimedPose> path{{2, at(0.09)}, {2.2, at(0.06)}, {2.3, at(0.065)}};
};

TEST_F(DemoRunTest, keeps_every_tick_of_the_path_at_its_own_time) {
  const DemoRun run = run_demo(pair, path, gains());
  const TickLog& log = run.kept->log();
  EXPECT_EQ(log.end() - log.begin(), 301u) << "with both ends, at 1 kHz";
  EXPECT_TRUE(log.along_path);
  EXPECT_NEAR(log.rate_hz(), 1000, 1e-6);
  EXPECT_NEAR(log.first_time(), 2, 1e-9);
  EXPECT_NEAR(log.last_time(), 2.3, 1e-9);
  EXPECT_LT((log.at(log.begin()).separation.device.p - at(0.09).p).norm(), 1e-9);
  EXPECT_LT((log.at(log.end() - 1).separation.device.p - at(0.065).p).norm(), 1e-9);
  EXPECT_EQ(run.kept->curves.size(), 301u);
}

TEST_F(DemoRunTest, the_deepest_tick_is_known_with_the_ways_out_of_it) {
  const DemoRun run = run_demo(pair, path, gains());
  EXPECT_TRUE(run.touches);
  const TickLog& log = run.kept->log();
  const Snapshot deepest = log.at(log.find(run.deepest));
  EXPECT_NEAR(deepest.separation.device.p.x(), 0.06, 1e-3) << "where the path turns";
  EXPECT_NEAR(run.deepest, 2.2, 2e-3) << "and when";
  EXPECT_NEAR(deepest.separation.depth, 0.01, 1e-3) << "x: 0.05 + 0.02 − 0.06";
  for (std::uint64_t i = log.begin(); i < log.end(); ++i)
    EXPECT_LE(log.at(i).separation.depth, deepest.separation.depth * (1 + 1e-6));
  const RecordedSearch* searched = log.searched(run.deepest);
  ASSERT_TRUE(searched);
  ASSERT_TRUE(searched->result.nearest);
  EXPECT_NEAR(searched->result.nearest->depth, 0.01, 1e-3);
}

TEST_F(DemoRunTest, a_path_of_hours_is_run_in_as_many_ticks_as_one_of_a_minute) {
  const DemoRun run = run_demo(pair, {{0, at(0.2)}, {7200, at(0.15)}}, gains());
  EXPECT_EQ(run.kept->log().end() - run.kept->log().begin(), 60'001u);
  EXPECT_EQ(run.kept->log().last_time(), 7200);
}

TEST_F(DemoRunTest, is_the_same_every_time_and_has_no_time_of_a_clock) {
  const DemoRun first = run_demo(pair, path, gains());
  const DemoRun second = run_demo(pair, path, gains());
  EXPECT_EQ(first.deepest, second.deepest);
  const TickLog &a = first.kept->log(), &b = second.kept->log();
  ASSERT_EQ(a.end(), b.end());
  for (std::uint64_t i = a.begin(); i < a.end(); ++i) {
    EXPECT_EQ(a.at(i).separation.separated.p, b.at(i).separation.separated.p) << i;
    EXPECT_EQ(a.at(i).wrench.force, b.at(i).wrench.force) << i;
    EXPECT_EQ(a.at(i).tick_us, 0);
    EXPECT_EQ(a.at(i).rate_hz, 0);
    EXPECT_EQ(a.at(i).late, 0u);
  }
}

TEST_F(DemoRunTest, of_a_path_that_never_touches_the_last_tick_counts) {
  const DemoRun run = run_demo(pair, {{0, at(0.2)}, {0.05, at(0.15)}}, gains());
  EXPECT_FALSE(run.touches);
  EXPECT_EQ(run.deepest, run.kept->log().last_time());
}

TEST_F(DemoRunTest, tells_how_far_it_is_and_can_be_cancelled) {
  std::vector<double> told;
  run_demo(pair, path, gains(), [&](double part) { return told.push_back(part), true; });
  ASSERT_FALSE(told.empty());
  EXPECT_TRUE(std::ranges::is_sorted(told));
  EXPECT_GT(told.front(), 0);
  EXPECT_LE(told.back(), 1);
  EXPECT_THROW(run_demo(pair, path, gains(), [](double part) { return part < 0.3; }), Cancelled);
}

}  // namespace
}  // namespace sonde::ui::test
