// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/trade/trade_front.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/engine/study/trade/made_up_trade.hpp"
#include "tests/support/csv.hpp"
#include "tests/support/xml.hpp"

namespace sonde {
namespace {

/// The same pair, so many times as large.
TradeResults grown(TradeResults out, double by) {
  out.radius *= by;
  for (TradePose& pose : out.poses) {
    for (double& depth : pose.long_pdg) depth *= by;
    for (double& depth : pose.long_pdt) depth *= by;
    for (TradeRun& run : pose.runs) run.depth *= by;
  }
  for (TradePath& path : out.paths)
    for (double& depth : path.depth) depth *= by;
  return out;
}

/// Reference: the figures of the pair alone, of which the front over it and its like are the same.
TEST(TradeFront, pairs_that_differ_in_size_only_have_the_figures_of_one) {
  const TradeResults one = test::made_up_trade();
  const TradeResults both[] = {one, grown(one, 1024)};
  const auto alone = trade_figures(one), front = trade_figures(pooled(both));
  ASSERT_EQ(alone.size(), front.size());
  for (std::size_t i = 0; i < alone.size(); ++i) {
    EXPECT_EQ(front[i].count, 2 * alone[i].count);
    EXPECT_EQ(front[i].failed, 2 * alone[i].failed);
    EXPECT_NEAR(front[i].median, alone[i].median, 1e-12);
    EXPECT_EQ(front[i].within_1, alone[i].within_1);
    EXPECT_EQ(front[i].time_median, alone[i].time_median);
  }
}

TEST(TradeFront, a_pair_that_is_wrong_shows_in_the_worst) {
  const TradeResults good = test::made_up_trade();
  TradeResults bad = good;
  for (TradePose& pose : bad.poses) pose.runs[0].depth = 3;
  const TradeResults both[] = {good, bad};
  EXPECT_EQ(trade_figures(pooled(both))[0].failed, 1u);
  EXPECT_GT(trade_figures(pooled(both))[0].p90, 1.9);
  EXPECT_LT(trade_figures(good)[0].median, 0.1);
}

TEST(TradeFront, files_are_a_picture_a_summary_and_a_row_of_each_pair) {
  TradeResults odd = test::made_up_trade();
  odd.scene = "a, \"b\"";
  const TradeResults both[] = {test::made_up_trade(), odd};
  const auto files = front_files(both);
  const auto text = [&](const char* name) {
    return std::ranges::find(files, name, &StudyFile::name)->text;
  };
  EXPECT_FALSE(test::parse_xml(text("front.svg")).all("rect", "frame").empty());
  const test::Csv pairs(text("pairs.csv"));
  ASSERT_EQ(pairs.rows.size(), 2 * odd.settings.size());
  EXPECT_EQ(pairs.text(0, "pair"), "made up");
  EXPECT_EQ(pairs.text(odd.settings.size(), "pair"), "a   b ");
  EXPECT_EQ(files.size(), 5u);
}

}  // namespace
}  // namespace sonde
