// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/charts/chart_scale.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace sonde {
namespace {

using testing::ElementsAre;

std::vector<std::string> texts(const ChartScale& scale) {
  std::vector<std::string> out;
  for (const ChartScale::Tick& tick : scale.ticks())
    if (!tick.text.empty()) out.push_back(tick.text);
  return out;
}

TEST(ChartScale, linear_ends_are_round) {
  const ChartScale scale({"x"}, {0.3, 7.2, 9.1});
  EXPECT_THAT(texts(scale), ElementsAre("0", "2", "4", "6", "8", "10"));
  EXPECT_EQ(scale.place(0), 0);
  EXPECT_EQ(scale.place(5), 0.5);
  EXPECT_EQ(scale.place(10), 1);
}

TEST(ChartScale, zero_is_written_without_a_sign) {
  EXPECT_THAT(texts(ChartScale({"x"}, {-1, 1})), ElementsAre("-1", "-0.5", "0", "0.5", "1"));
}

TEST(ChartScale, small_and_large_numbers_are_short) {
  EXPECT_THAT(texts(ChartScale({"x"}, {0, 2e-7})),
              ElementsAre("0", "5e-8", "1e-7", "1.5e-7", "2e-7"));
  EXPECT_THAT(texts(ChartScale({"x"}, {0, 4e20})),
              ElementsAre("0", "1e20", "2e20", "3e20", "4e20"));
}

TEST(ChartScale, the_ticks_lie_where_their_numbers_do) {
  for (const bool logarithmic : {false, true}) {
    const ChartScale scale({"x", logarithmic}, {0.02, 3000});
    std::size_t named = 0;
    for (const ChartScale::Tick& tick : scale.ticks()) {
      EXPECT_GE(tick.place, -1e-9);
      EXPECT_LE(tick.place, 1 + 1e-9);
      if (tick.text.empty()) continue;
      ++named;
      EXPECT_NEAR(*scale.place(std::stod(tick.text)), tick.place, 1e-9) << tick.text;
    }
    EXPECT_GE(named, 3u);
  }
}

TEST(ChartScale, logarithmic_ends_are_decades) {
  const ChartScale scale({"x", true}, {0.03, 2000});
  EXPECT_THAT(texts(scale), ElementsAre("0.01", "0.1", "1", "10", "100", "1000", "10000"));
  EXPECT_NEAR(*scale.place(10), 0.5, 1e-12);
}

TEST(ChartScale, within_a_decade_logarithmic_axes_have_numbers_too) {
  EXPECT_GE(texts(ChartScale({"x", true}, {150, 700})).size(), 2u);
}

TEST(ChartScale, what_has_no_place_is_left_out) {
  const double infinity = std::numeric_limits<double>::infinity();
  const ChartScale scale({"x", true}, {1, 100, 0, -5, std::nan(""), infinity});
  EXPECT_EQ(scale.place(1), 0);
  EXPECT_EQ(scale.place(100), 1);
  for (const double none : {0.0, -5.0, std::nan(""), infinity})
    EXPECT_FALSE(scale.place(none)) << none;
  EXPECT_FALSE(ChartScale({"x"}, {0, 1}).place(-infinity));
  EXPECT_EQ(ChartScale({"x"}, {0, 1}).place(-1), -1);
}

TEST(ChartScale, nothing_and_one_value_have_an_axis) {
  EXPECT_EQ(texts(ChartScale({"x"}, {})).front(), "0");
  EXPECT_EQ(texts(ChartScale({"x"}, {})).back(), "1");
  for (const double value : {0.0, 3.0, -2e6, 1e-300}) {
    const ChartScale scale({"x"}, {value});
    EXPECT_GT(*scale.place(value), 0) << value;
    EXPECT_LT(*scale.place(value), 1) << value;
    EXPECT_GE(scale.ticks().size(), 2u) << value;
  }
  const ChartScale logarithmic({"x", true}, {20});
  EXPECT_GT(*logarithmic.place(20), 0);
  EXPECT_LT(*logarithmic.place(20), 1);
}

TEST(ChartScale, the_axis_may_give_its_ends) {
  ChartAxis axis{"x"};
  axis.from = -3;
  axis.to = 4;
  const ChartScale scale(axis, {0, 100});
  EXPECT_EQ(scale.place(-3), 0);
  EXPECT_EQ(scale.place(4), 1);
  EXPECT_GT(*scale.place(100), 1);
}

}  // namespace
}  // namespace sonde
