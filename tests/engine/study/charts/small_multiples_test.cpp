// SPDX-License-Identifier: GPL-3.0-or-later
// The picture is parsed as XML, by expat, and what is drawn is looked up there.
#include "engine/study/charts/small_multiples.hpp"

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

SmallMultiples table() {
  SmallMultiples out{
      .title = "a < b", .x_label = "time, s", .quantities = {{"force, N"}, {"depth"}}};
  out.columns = {"one", "two", "three"};
  out.rows = {"k = 1", "k = 2"};
  for (int i = 0; i < 6; ++i)
    out.cells.push_back(
        {{0, 1, 2}, {{0, 1.0 + i, 2}, {0, NAN, 3}}, "note " + std::to_string(i), i == 4});
  return out;
}

TEST(SmallMultiples, has_a_line_for_each_quantity_of_each_cell_and_every_name) {
  const Xml svg = parse_xml(to_svg(table()));
  for (const char* text : {"a < b", "one", "two", "three", "k = 1", "k = 2", "force, N", "depth",
                           "time, s", "note 0", "note 5"})
    EXPECT_TRUE(has_text(svg, text)) << text;
  // Six lines of force; those of depth are broken in two by what is not finite.
  EXPECT_EQ(svg.all("polyline").size(), 6u + 2 * 6);
  EXPECT_EQ(svg.all("rect").size(), 1u + 2 * 6);
}

TEST(SmallMultiples, many_points_keep_their_highest) {
  SmallMultiples one{.title = "t", .x_label = "x", .quantities = {{"y"}}};
  one.columns = {"c"};
  one.rows = {"r"};
  ChartTableCell cell{{}, {{}}, "", false};
  for (int i = 0; i < 20'000; ++i) {
    cell.x.push_back(i);
    cell.y[0].push_back(i == 777 ? 10 : 1);
  }
  one.cells = {cell};
  const std::string svg = to_svg(one);
  EXPECT_LT(svg.size(), 20'000u);
  cell.y[0][777] = 1;
  one.cells = {cell};
  EXPECT_NE(to_svg(one), svg) << "the peak is drawn";
}

TEST(SmallMultiples, refuses_a_table_with_a_hole) {
  SmallMultiples cells = table(), lines = table(), points = table();
  cells.cells.pop_back();
  lines.cells[2].y.pop_back();
  points.cells[2].y[1].pop_back();
  EXPECT_THROW(to_svg(cells), std::invalid_argument);
  EXPECT_THROW(to_svg(lines), std::invalid_argument);
  EXPECT_THROW(to_svg(points), std::invalid_argument);
}

}  // namespace
}  // namespace sonde
