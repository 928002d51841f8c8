// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/trade/trade_chart.hpp"

#include <gtest/gtest.h>

#include "tests/engine/study/trade/made_up_trade.hpp"
#include "tests/support/xml.hpp"

namespace sonde {
namespace {

std::vector<const test::Xml*> dots(const test::Xml& panel) { return panel.all("circle"); }

TEST(TradeChart, has_a_panel_for_each_kind_and_a_dot_for_each_setting) {
  const TradeResults results = test::made_up_trade();
  const test::Xml svg = test::parse_xml(trade_picture(results, trade_figures(results)));
  const auto panels = svg.all("g", "panel");
  ASSERT_EQ(panels.size(), 6u);
  EXPECT_EQ(dots(*panels[0]).size(), 1u) << "the median; the 90th percentile is a failure";
  EXPECT_EQ(dots(*panels[1]).size(), 2u);
  EXPECT_EQ(dots(*panels[2]).size(), 4u) << "without a budget nothing is off: at the floor";
  EXPECT_EQ(dots(*panels[5]).size(), 1u) << "of the one budget";
}

TEST(TradeChart, what_was_not_measured_is_not_shown) {
  TradeResults results = test::made_up_trade();
  results.paths.clear();
  results.settings.resize(1);
  const test::Xml svg = test::parse_xml(trade_picture(results, trade_figures(results)));
  EXPECT_EQ(svg.all("g", "panel").size(), 1u);
  results.radius = 2e6;  // all poses are left out: there is no line at the floor
  const test::Xml empty = test::parse_xml(trade_picture(results, trade_figures(results)));
  EXPECT_TRUE(dots(*empty.all("g", "panel").front()).empty());
}

}  // namespace
}  // namespace sonde
