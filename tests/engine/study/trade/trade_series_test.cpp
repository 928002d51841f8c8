// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/trade/trade_series.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "engine/base/error.hpp"
#include "engine/study/trade/trade_chart.hpp"
#include "tests/engine/study/trade/made_up_trade.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde {
namespace {

using testing::HasSubstr;

constexpr const char* head = "series,pose,depth,time_us\n";

// The reference of every made-up pose is 1 m.
TEST(TradeSeries, errors_are_of_the_studys_reference) {
  const test::TempFolder folder;
  const auto file = folder.write(
      "s.csv", std::string(head) + "FCL,0,0.25,10\nFCL,1,1.5,30\nBullet,0,,5\r\nFCL,2,1,20\n");
  const TradeResults made_up = test::made_up_trade();
  const auto all = trade_series(read_trade_answers(file, made_up.poses.size()), made_up);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].name, "FCL");
  EXPECT_THAT(all[0].errors, testing::ElementsAre(0, 0.5, 0.75));
  EXPECT_THAT(all[0].times, testing::ElementsAre(10, 20, 30));
  EXPECT_EQ(all[1].name, "Bullet");
  EXPECT_TRUE(std::isinf(all[1].errors[0])) << "no depth: infinitely wrong";
}

TEST(TradeSeries, are_dots_of_the_picture) {
  const TradeResults results = test::made_up_trade();
  const std::string without = trade_picture(results, trade_figures(results));
  const std::string with =
      trade_picture(results, trade_figures(results), {{"Peer & Co", {0.5, 0.7}, {10, 20}}});
  EXPECT_THAT(without, testing::Not(HasSubstr("Peer")));
  EXPECT_THAT(with, HasSubstr("Peer &amp; Co, median"));
}

TEST(TradeSeries, what_is_wrong_is_named_with_its_line) {
  const test::TempFolder folder;
  const auto refused = [&](const std::string& text, const std::string& reason) {
    const auto file = folder.write("bad.csv", text);
    try {
      read_trade_answers(file, test::made_up_trade().poses.size());
      ADD_FAILURE() << "accepted: " << text;
    } catch (const InputError& bad) {
      EXPECT_THAT(bad.what(), HasSubstr("bad.csv"));
      EXPECT_THAT(bad.what(), HasSubstr(reason));
    }
  };
  refused("name,pose\n", ":1: the header must be series,pose,depth,time_us");
  refused(std::string(head) + "FCL,0,1,1\nFCL,1,1\n", ":3: 3 columns");
  refused(std::string(head) + "FCL,4,1,1\n", "none of the study, which has 4");
  refused(std::string(head) + "FCL,0.5,1,1\n", "none of the study");
  refused(std::string(head) + "FCL,0,deep,1\n", "depth is \"deep\"");
  refused(std::string(head) + "FCL,0,1,-1\n", "time_us is \"-1\"");
  refused(std::string(head) + ",0,1,1\n", "the series has no name");
}

}  // namespace
}  // namespace sonde
