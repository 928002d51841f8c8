// SPDX-License-Identifier: GPL-3.0-or-later
// The picture is parsed as XML, by expat, and what is drawn is looked up there.
#include "engine/study/charts/stacked_bars.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tests/support/xml.hpp"

namespace sonde {
namespace {

using test::has_text;
using test::parse_xml;
using test::Xml;

StackedBars chart() {
  return {.title = "a < b",
          .label = "share, %",
          .unit = "µs",
          .part_names = {"look", "solve", "none"},
          .bars = {{"one", {1, 3, 0}}, {"two", {2000, 500, 0}}}};
}

/// The widths of the parts: each has a title.
std::vector<double> widths(const Xml& svg) {
  std::vector<double> out;
  for (const Xml* rect : svg.all("rect"))
    if (!rect->all("title").empty()) out.push_back(rect->number("width"));
  return out;
}

TEST(StackedBars, parts_are_as_wide_as_their_share) {
  const Xml svg = parse_xml(to_svg(chart()));
  const std::vector<double> wide = widths(svg);
  ASSERT_EQ(wide.size(), 4u) << "what is 0 is not drawn";
  EXPECT_NEAR(wide[1], 3 * wide[0], 0.02);
  EXPECT_NEAR(wide[2], 4 * wide[3], 0.02);
  EXPECT_NEAR(wide[0] + wide[1], wide[2] + wide[3], 0.02) << "all bars are of one length";
  for (const char* text : {"a < b", "one", "two", "look", "solve", "share, %", "4 µs", "2500 µs"})
    EXPECT_TRUE(has_text(svg, text)) << text;
  EXPECT_FALSE(has_text(svg, "none")) << "no bar has it";
}

TEST(StackedBars, a_bar_of_nothing_has_its_name_alone) {
  StackedBars empty = chart();
  empty.bars = {{"idle", {0, 0, 0}}};
  const Xml svg = parse_xml(to_svg(empty));
  EXPECT_TRUE(widths(svg).empty());
  EXPECT_TRUE(has_text(svg, "idle"));
  EXPECT_TRUE(has_text(svg, "0 µs"));
}

TEST(StackedBars, what_is_no_share_is_refused) {
  for (const std::vector<double>& parts :
       {std::vector<double>{1, 2}, {1, -2, 0}, {1, NAN, 0}, {1, INFINITY, 0}}) {
    StackedBars wrong = chart();
    wrong.bars[0].parts = parts;
    EXPECT_THROW(to_svg(wrong), std::invalid_argument);
  }
}

}  // namespace
}  // namespace sonde
