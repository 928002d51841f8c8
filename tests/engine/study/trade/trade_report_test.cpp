// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/trade/trade_report.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/scene/poses.hpp"
#include "tests/engine/study/trade/made_up_trade.hpp"
#include "tests/support/csv.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde {
namespace {

std::string file(const std::string& name, const TradeResults& results) {
  const auto files = trade_files(results);
  return std::ranges::find(files, name, &StudyFile::name)->text;
}

TEST(TradeReport, tables_have_a_row_for_each_pose_and_setting) {
  const TradeResults results = test::made_up_trade();
  const test::Csv trade(file("trade.csv", results));
  ASSERT_EQ(trade.rows.size(), 8u);
  EXPECT_EQ(trade.text(2, "kind"), "static");
  EXPECT_NEAR(trade.number(2, "error"), 0.02, 1e-12);
  EXPECT_EQ(trade.text(6, "depth"), "") << "a failure";
  EXPECT_EQ(trade.text(6, "error"), "");
  const test::Csv extremes(file("extremes.csv", results));
  ASSERT_EQ(extremes.rows.size(), 8u);
  EXPECT_EQ(extremes.number(1, "change"), -0.5);
  EXPECT_EQ(extremes.text(2, "change"), "") << "a failure";
  const test::Csv summary(file("summary.csv", results));
  ASSERT_EQ(summary.rows.size(), results.settings.size());
  EXPECT_EQ(summary.text(0, "failed"), "1");
  EXPECT_NEAR(summary.number(0, "median_error"), 0.02, 1e-12);
  EXPECT_EQ(summary.number(2, "p99_us"), 5);
}

TEST(TradeReport, the_poses_can_be_queried) {
  const TradeResults results = test::made_up_trade();
  const test::TempFolder folder;
  const auto poses = read_poses(folder.write("poses.csv", file("poses.csv", results)));
  ASSERT_EQ(poses.size(), 4u);
  EXPECT_EQ(poses[2].p.x(), 0.2);
  EXPECT_EQ(poses[2].p.z(), 0.3);
}

TEST(TradeReport, the_summary_says_what_the_tables_say) {
  const auto json = nlohmann::json::parse(file("summary.json", test::made_up_trade()));
  EXPECT_EQ(json.at("settings").size(), 4u);
  EXPECT_EQ(json.at("settings")[0].at("kind"), "static");
  EXPECT_TRUE(json.at("settings")[0].at("p90_error").is_null()) << "a failure is no number";
  EXPECT_EQ(json.at("units").at("median_us"), "us");
  EXPECT_NEAR(json.at("reference").at("pdg").at("worst_spread"), 0.1, 1e-12);
  EXPECT_EQ(json.at("extremes")[0].at("worst_change"), 0.5);
  const std::string text = file("summary.md", test::made_up_trade());
  for (const char* title : {"## Static search", "## Lower bound", "## Coherent", "| far |"})
    EXPECT_THAT(text, testing::HasSubstr(title));
}

TEST(TradeReport, only_times_depend_on_times) {
  TradeResults slow = test::made_up_trade();
  for (TradePose& pose : slow.poses)
    for (TradeRun& run : pose.runs) run.time_us *= 2;
  const test::Csv one(file("trade.csv", slow)), other(file("trade.csv", test::made_up_trade()));
  EXPECT_NE(one.rows, other.rows);
  EXPECT_EQ(one.without({"time_us"}), other.without({"time_us"}));
  const std::vector<std::string> times{"median_us", "p99_us", "p999_us"};
  EXPECT_EQ(test::Csv(file("summary.csv", slow)).without(times),
            test::Csv(file("summary.csv", test::made_up_trade())).without(times));
}

}  // namespace
}  // namespace sonde
