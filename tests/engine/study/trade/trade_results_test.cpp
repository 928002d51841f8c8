// SPDX-License-Identifier: GPL-3.0-or-later
// Results made up by hand: what they come to is known.
#include "engine/study/trade/trade_results.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "engine/base/error.hpp"
#include "tests/engine/study/trade/made_up_trade.hpp"

namespace sonde {
namespace {

using test::made_up_trade;
using testing::HasSubstr;

const double none = std::numeric_limits<double>::quiet_NaN();

TradeFigures figures_with(const TradeResults& results, const TradeSetting& setting) {
  for (const TradeFigures& f : trade_figures(results))
    if (f.setting == setting) return f;
  throw std::out_of_range("no such setting");
}

TEST(TradeResults, the_reference_is_the_least_depth_anything_found) {
  TradePose pose;
  pose.long_pdg = {2, 2.2};
  pose.long_pdt = {3, 3.3};
  EXPECT_EQ(pose.reference(Method::pdg), 2);
  EXPECT_EQ(pose.reference(Method::pdt), 3);
  EXPECT_NEAR(pose.spread(Method::pdg), 0.1, 1e-12);
  pose.runs = {{{TradeKind::search, Method::pdt, 8}, 1.5, 1, 1},
               {{TradeKind::search, Method::pdg, 8}, none, 1, 1},
               {{TradeKind::bound, Method::pdg, 8}, 0.1, 1, 1}};
  EXPECT_EQ(pose.reference(Method::pdt), 1.5);
  EXPECT_EQ(pose.reference(Method::pdg), 1.5) << "a translation is a rigid motion";
  EXPECT_TRUE(std::isnan(TradePose().spread(Method::pdg)));
}

TEST(TradeResults, figures_of_searches_and_bounds) {
  // References 1, 1, 1, 1; searched 1, 1.02, 1.1 and one that failed.
  const TradeFigures search = figures_with(made_up_trade(), {TradeKind::search, Method::pdg, 8});
  EXPECT_EQ(search.count, 4u);
  EXPECT_EQ(search.failed, 1u);
  EXPECT_NEAR(search.median, 0.02, 1e-12);
  EXPECT_TRUE(std::isinf(search.p90));
  EXPECT_EQ(search.within_1, 0.25);
  EXPECT_EQ(search.within_5, 0.5);
  EXPECT_EQ(search.time_median, 20);
  EXPECT_EQ(search.time_p99, 40);
  const TradeFigures bound = figures_with(made_up_trade(), {TradeKind::bound, Method::pdg, 5000});
  EXPECT_NEAR(bound.median, 0.25, 1e-12);
  EXPECT_EQ(bound.failed, 0u);
}

TEST(TradeResults, figures_of_ticks_are_against_the_path_without_a_budget) {
  // Without a budget 0, 0, 1, 2, 4 m; with one 0, 1, 1, 2.03, 5.
  const TradeFigures f = figures_with(made_up_trade(), {TradeKind::tick, Method::pdg, 2000});
  EXPECT_EQ(f.count, 4u) << "at the first tick neither is in contact";
  EXPECT_NEAR(f.worst, 0.25, 1e-12);
  EXPECT_NEAR(f.median, 0.0075, 1e-12);
  EXPECT_EQ(f.within_1, 0.5);
  EXPECT_EQ(f.unconverged, 0.25);
  const TradeFigures whole = figures_with(made_up_trade(), {TradeKind::tick, Method::pdg, 0});
  EXPECT_EQ(whole.worst, 0);
  EXPECT_EQ(whole.count, 3u);
}

TEST(TradeResults, poses_that_only_touch_are_left_out) {
  TradeResults results = made_up_trade();
  results.radius = 2e6;  // of which the depth of 1 m is less than a millionth
  EXPECT_EQ(figures_with(results, {TradeKind::search, Method::pdg, 8}).count, 0u);
  EXPECT_TRUE(std::isnan(trade_reference(results, Method::pdg).p90));
}

TEST(TradeResults, the_spread_of_the_reference_is_over_poses) {
  // 0, 0, 0 and 0.1.
  const TradeReference reference = trade_reference(made_up_trade(), Method::pdg);
  EXPECT_EQ(reference.median, 0);
  EXPECT_NEAR(reference.worst, 0.1, 1e-12);
}

TEST(TradeResults, figures_of_extremes) {
  const ExtremeFigures far = figures_of(made_up_trade().extremes[0]);
  EXPECT_EQ(far.failed, 1u);
  EXPECT_EQ(far.median, 0.25);
  EXPECT_EQ(far.worst, 0.5);
  EXPECT_EQ(figures_of(made_up_trade().extremes[1]).worst, 0);
}

TEST(TradeResults, are_read_back_as_they_were_written) {
  const TradeResults made = made_up_trade();
  const StudyFolder folder = test::folder_of(made);
  const TradeResults read = read_trade("folder", folder);
  EXPECT_EQ(read.settings, made.settings);
  EXPECT_EQ(test::folder_of(read).results, folder.results);
}

TEST(TradeResults, parts_that_are_missing_or_wrong_are_named) {
  const auto reason = [](const StudyFolder& folder) -> std::string {
    try {
      read_trade("folder", folder);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  StudyFolder folder = test::folder_of(made_up_trade());
  for (const char* damaged : {"", "{", "{}", "[]", R"({"runs": 3})", R"({"runs": []})"}) {
    folder.results[1] = damaged;
    EXPECT_THAT(reason(folder), HasSubstr(folder.names[1])) << damaged;
  }
  folder.results[1].reset();
  EXPECT_THAT(reason(folder), HasSubstr(folder.names[1]));
  folder = test::folder_of(made_up_trade());
  folder.about = "{}";
  EXPECT_THAT(reason(folder), HasSubstr("study.json"));
}

}  // namespace
}  // namespace sonde
