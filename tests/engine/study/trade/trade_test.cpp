// SPDX-License-Identifier: GPL-3.0-or-later
// Two boxes with the same axes. By translation the depth is the least overlap of their extents:
// that is the reference, without any solver.
#include "engine/study/trade/trade.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/base/error.hpp"
#include "engine/study/trade/trade_results.hpp"
#include "tests/engine/study/never.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde {
namespace {

using test::never;

/// A cube of 1 m on one of 2 m, so deep in it from above.
Pose pressed_by(double depth) { return {Quat::Identity(), Vec3(0.1, 0.05, 1.5 - depth)}; }

TradeSetup cubes() {
  TradeSetup setup{.pair = {test::body(test::box({1, 1, 1})), test::body(test::box({2, 2, 2}))}};
  setup.poses = {pressed_by(0.1), pressed_by(0.3)};
  for (int i = 0; i < 30; ++i) setup.path.push_back({0.001 * i, pressed_by(0.01 * i - 0.05)});
  setup.scene = "cubes";
  return setup;
}

/// Computed on so many threads.
TradeResults results_of(const TradeSetup& setup, unsigned threads) {
  const test::TempFolder folder;
  compute_parts(folder.path(), trade_study(setup), {}, threads, never);
  return read_trade("folder", read_study(folder.path()));
}

/// All but the times.
std::vector<std::string> texts(TradeResults results) {
  std::vector<std::string> out;
  for (TradePose& pose : results.poses) {
    for (TradeRun& run : pose.runs) run.time_us = 0;
    out.push_back(to_json(pose));
  }
  for (TradePath& path : results.paths) {
    std::ranges::fill(path.time_us, 0);
    out.push_back(to_json(path));
  }
  out.push_back(to_json(results.extremes));
  return out;
}

class Trade : public testing::Test {
 protected:
  static void SetUpTestSuite() { results_ = results_of(cubes(), 2); }
  inline static TradeResults results_;
};

TEST_F(Trade, every_setting_is_measured_on_every_pose_and_on_the_path) {
  ASSERT_EQ(results_.poses.size(), 2u);
  for (const TradePose& pose : results_.poses)
    for (const TradeRun& run : pose.runs) EXPECT_GT(run.time_us, 0);
  EXPECT_EQ(results_.poses[0].runs.size() + results_.paths.size(), results_.settings.size());
  for (const TradePath& path : results_.paths) EXPECT_EQ(path.depth.size(), 30u);
}

TEST_F(Trade, the_reference_of_translations_is_the_least_overlap_of_the_extents) {
  const double depths[] = {0.1, 0.3};
  for (std::size_t i = 0; i < 2; ++i) {
    const TradePose& pose = results_.poses[i];
    EXPECT_EQ(pose.long_pdt.size(), 4u);
    EXPECT_NEAR(pose.reference(Method::pdt), depths[i], 2e-4 * depths[i]);  // the clearance
    EXPECT_LT(pose.spread(Method::pdt), 1e-3);
    EXPECT_LE(pose.reference(Method::pdg), pose.reference(Method::pdt));
  }
}

TEST_F(Trade, searches_are_above_the_reference_and_bounds_below) {
  for (const TradePose& pose : results_.poses)
    for (const TradeRun& run : pose.runs) {
      const double reference = pose.reference(run.setting.method);
      if (run.setting.kind == TradeKind::bound) {
        EXPECT_LE(run.depth, reference);
        continue;
      }
      EXPECT_GE(run.depth, reference) << run.setting.budget;
      if (run.setting.budget > 0) continue;
      EXPECT_LT(error_of(pose, run), 1e-3) << "two boxes are no hard case";
    }
}

TEST_F(Trade, pdt_ticks_have_the_depth_of_the_press) {
  for (const TradePath& path : results_.paths) {
    if (path.setting.method != Method::pdt || path.setting.budget != 0) continue;
    for (std::size_t i = 0; i < path.depth.size(); ++i) {
      const double pressed = 0.01 * static_cast<double>(i) - 0.05;
      EXPECT_NEAR(path.depth[i], std::max(0.0, pressed), 2e-4 * std::abs(pressed) + 1e-9) << i;
    }
  }
}

TEST_F(Trade, only_the_times_differ_from_run_to_run) {
  EXPECT_EQ(texts(results_of(cubes(), 1)), texts(results_));
}

TEST_F(Trade, without_a_path_or_a_solid_there_is_nothing_of_them) {
  TradeSetup setup = cubes();
  setup.path.clear();
  std::mt19937_64 random(5);
  const auto soup = test::body(test::random_soup(random, 12, 1));
  setup.pair = {soup, soup};
  setup.poses = {Pose{Quat::Identity(), Vec3(0.01, 0.02, 0.03)}};
  const nlohmann::json about = nlohmann::json::parse(trade_study(setup).about);
  for (const auto& setting : about.at("settings")) EXPECT_EQ(setting.at("kind"), "static");
}

TEST_F(Trade, stops_where_it_is_asked_to) {
  const Study study = trade_study(cubes());
  for (const StudyPart& part : study.parts)
    EXPECT_THROW(part.compute([] { return true; }), Cancelled) << part.name;
}

}  // namespace
}  // namespace sonde
