// SPDX-License-Identifier: GPL-3.0-or-later
// Every picture is parsed as XML, by expat, and what is drawn is looked up there.
#include "engine/study/charts/svg_chart.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <clocale>
#include <cmath>
#include <locale>

#include "engine/text/number_text.hpp"
#include "tests/support/xml.hpp"

namespace sonde {
namespace {

using test::parse_xml;
using test::Xml;
using testing::Contains;
using testing::ElementsAre;

struct Spot {
  double x, y;
};

std::vector<Spot> spots(const Xml& polyline) {
  std::vector<Spot> out;
  std::string_view text = polyline["points"];
  while (!text.empty()) {
    const std::string_view one = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(text.size(), one.size() + 1));
    const std::size_t comma = one.find(',');
    out.push_back(
        {parse_number(one.substr(0, comma)).value(), parse_number(one.substr(comma + 1)).value()});
  }
  return out;
}

std::vector<std::string> texts(const Xml& in) {
  std::vector<std::string> out;
  for (const Xml* text : in.all("text")) out.push_back(text->text);
  return out;
}

ChartPanel plain_panel(std::vector<ChartSeries> series) {
  ChartPanel panel;
  panel.title = "a panel";
  panel.x = {"time, s"};
  panel.y = {"force, N"};
  panel.series = std::move(series);
  return panel;
}

Xml drawn(const ChartPanel& panel) { return parse_xml(to_svg({"a chart", {panel}})); }

const Xml& frame_of(const Xml& svg) { return *svg.all("rect", "frame").at(0); }

TEST(SvgChart, titles_labels_and_names_are_there) {
  const Xml svg = drawn(plain_panel({{"PD_g", {0, 1}, {0, 2}}, {"", {0, 1}, {1, 1}}}));
  EXPECT_EQ(svg.name, "svg");
  EXPECT_EQ(svg["xmlns"], "http://www.w3.org/2000/svg");
  for (const char* text : {"a chart", "a panel", "time, s", "force, N", "PD_g", "0.5", "2"})
    EXPECT_THAT(texts(svg), Contains(text));
  EXPECT_EQ(svg.all("g", "series").size(), 2u) << "a series without a name is drawn";
}

TEST(SvgChart, what_is_special_in_xml_is_escaped) {
  const std::string name = "a<b & \"c\">";
  EXPECT_THAT(texts(drawn(plain_panel({{name, {0, 1}, {0, 1}}}))), Contains(name));
  EXPECT_THAT(texts(drawn(plain_panel({{"σ\x01\n", {0, 1}, {0, 1}}}))), Contains("σ  "));
}

TEST(SvgChart, a_line_goes_where_its_values_say) {
  const Xml svg = drawn(plain_panel({{"rise", {0, 5, 10}, {0, 5, 10}}}));
  const Xml& frame = frame_of(svg);
  const double left = frame.number("x"), top = frame.number("y");
  const double right = left + frame.number("width"), bottom = top + frame.number("height");
  const auto line = spots(*svg.all("polyline").at(0));
  ASSERT_EQ(line.size(), 3u);
  EXPECT_NEAR(line[0].x, left, 0.01);
  EXPECT_NEAR(line[0].y, bottom, 0.01);
  EXPECT_NEAR(line[1].x, (left + right) / 2, 0.01);
  EXPECT_NEAR(line[1].y, (top + bottom) / 2, 0.01);
  EXPECT_NEAR(line[2].x, right, 0.01);
  EXPECT_NEAR(line[2].y, top, 0.01);
}

TEST(SvgChart, what_is_no_number_breaks_a_line_and_leaves_a_point_out) {
  const std::vector<double> x{0, 1, 2, 3, 4}, y{0, 1, std::nan(""), 1, 0};
  EXPECT_EQ(drawn(plain_panel({{"a", x, y}})).all("polyline").size(), 2u);
  const Xml svg = drawn(plain_panel({{"a", x, y, ChartSeries::Form::points}}));
  EXPECT_EQ(svg.all("g", "series").at(0)->all("circle").size(), 4u);
  EXPECT_TRUE(svg.all("polyline").empty());
}

TEST(SvgChart, a_dashed_line_is_dashed_in_the_legend_too) {
  const Xml svg = drawn(plain_panel({{"bound", {0, 1}, {0, 1}, ChartSeries::Form::dashed}}));
  EXPECT_EQ(svg.all("polyline").at(0)->attributes.count("stroke-dasharray"), 1u);
  const auto lines = svg.all("line");
  EXPECT_EQ(std::ranges::count_if(
                lines, [](const Xml* l) { return l->attributes.contains("stroke-dasharray"); }),
            1);
}

TEST(SvgChart, panels_lie_above_one_another_inside_the_picture) {
  const ChartPanel panel = plain_panel({{"a", {0, 1}, {0, 1}}});
  const Xml svg = parse_xml(to_svg({"three", {panel, panel, panel}}));
  const auto frames = svg.all("rect", "frame");
  ASSERT_EQ(frames.size(), 3u);
  for (std::size_t i = 1; i < 3; ++i)
    EXPECT_GT(frames[i]->number("y"), frames[i - 1]->number("y") + frames[i - 1]->number("height"));
  EXPECT_LT(frames[2]->number("y") + frames[2]->number("height"), svg.number("height"));
}

TEST(SvgChart, a_long_legend_fits_into_the_picture) {
  const Xml svg = drawn(plain_panel(std::vector<ChartSeries>(30, {"name", {0, 1}, {0, 1}})));
  for (const Xml* text : svg.all("text"))
    EXPECT_LT(text->attributes.contains("transform") ? 0 : text->number("y"), svg.number("height"));
}

TEST(SvgChart, a_map_has_cells_on_logarithmic_axes) {
  ChartPanel map;
  map.x = {"stiffness, N/m", true};
  map.y = {"damping, N·s/m", true};
  map.kinds = {{"stable", "#d9f0d3"}, {"chattering", "#f4a582"}};
  map.cells = {{10, 100, 0.1, 1, 0}, {100, 1000, 0.1, 1, 1}, {100, 1000, 1, 10, 7}};
  map.series = {{"theory", {10, 1000}, {0.1, 10}, ChartSeries::Form::dashed}};
  const Xml svg = drawn(map);
  const auto cells = svg.all("rect", "cell");
  ASSERT_EQ(cells.size(), 2u) << "a cell of no kind is left out";
  EXPECT_NEAR(cells[0]->number("width"), cells[1]->number("width"), 0.02) << "a decade each";
  EXPECT_NEAR(cells[0]->number("x") + cells[0]->number("width"), cells[1]->number("x"), 0.02);
  EXPECT_EQ(cells[0]->children.at(0).text, "stable");
  EXPECT_EQ((*cells[1])["fill"], "#f4a582");
  EXPECT_THAT(texts(svg), Contains("chattering"));
  EXPECT_THAT(texts(svg), Contains("1000"));
}

TEST(SvgChart, what_the_axes_leave_out_is_cut_off) {
  ChartPanel panel = plain_panel({{"in, out, in", {0, 2, 4, 6}, {0.5, 0.5, 2.5, 0.5}},
                                  {"outside", {0, 6}, {3, 4}},
                                  {"far", {0, 2}, {-1e300, 1e300}},
                                  {"dots", {1, 1}, {0.5, 5}, ChartSeries::Form::points}});
  panel.y.from = 0;
  panel.y.to = 1;
  panel.kinds = {{"wide", "#eee"}};
  panel.cells = {{0, 6, -1, 2, 0}};
  const Xml svg = drawn(panel);
  const Xml& frame = frame_of(svg);
  const double top = frame.number("y"), height = frame.number("height");
  const auto groups = svg.all("g", "series");
  const auto lines = groups.at(0)->all("polyline");
  ASSERT_EQ(lines.size(), 2u);
  // y goes from 0.5 to 2.5 over two units of x: it leaves at x = 2.5, and comes back at 5.5.
  const double unit = frame.number("width") / 6;
  EXPECT_NEAR(spots(*lines[0]).back().x, frame.number("x") + 2.5 * unit, 0.02);
  EXPECT_NEAR(spots(*lines[0]).back().y, top, 0.02);
  EXPECT_NEAR(spots(*lines[1]).front().x, frame.number("x") + 5.5 * unit, 0.02);
  EXPECT_TRUE(groups.at(1)->all("polyline").empty());
  for (const Spot& spot : spots(*groups.at(2)->all("polyline").at(0))) {
    EXPECT_GE(spot.y, top - 0.01);
    EXPECT_LE(spot.y, top + height + 0.01);
  }
  EXPECT_EQ(groups.at(3)->all("circle").size(), 1u);
  EXPECT_NEAR(svg.all("rect", "cell").at(0)->number("height"), height, 0.01);
}

TEST(SvgChart, a_thinned_line_keeps_its_peaks) {
  ChartSeries noise{"noise", {}, {}};
  for (int i = 0; i < 100000; ++i) {
    noise.x.push_back(i);
    noise.y.push_back(i == 54321 ? 10 : i == 7 ? -10 : std::sin(i));
  }
  const Xml svg = drawn(plain_panel({noise}));
  const auto line = spots(*svg.all("polyline").at(0));
  EXPECT_LT(line.size(), 4000u);
  const Xml& frame = frame_of(svg);
  const auto by_height = [](const Spot& a, const Spot& b) { return a.y < b.y; };
  const auto [high, low] = std::minmax_element(line.begin(), line.end(), by_height);
  EXPECT_NEAR(high->y, frame.number("y"), 0.01);
  EXPECT_NEAR(high->x, frame.number("x") + 0.54321 * frame.number("width"), 0.02);
  EXPECT_NEAR(low->y, frame.number("y") + frame.number("height"), 0.01);
  EXPECT_TRUE(std::is_sorted(line.begin(), line.end(),
                             [](const Spot& a, const Spot& b) { return a.x < b.x; }));
}

TEST(SvgChart, nothing_to_draw_is_a_picture_as_well) {
  EXPECT_EQ(parse_xml(to_svg(SvgChart{})).all("g").size(), 0u);
  EXPECT_EQ(drawn(plain_panel({})).all("polyline").size(), 0u);
  EXPECT_EQ(drawn(plain_panel({{"a", {}, {}}, {"b", {0, 1, 2}, {}}})).all("polyline").size(), 0u);
}

/// Decimal commas, without any locale having to be installed.
struct Commas : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

TEST(SvgChart, the_same_bytes_in_any_locale) {
  const ChartPanel panel = plain_panel({{"a", {0, 0.3}, {0.1, 0.25}}});
  const std::string once = to_svg({"chart", {panel}});
  const std::locale before = std::locale::global(std::locale(std::locale(), new Commas));
  std::setlocale(LC_NUMERIC, "de_DE.UTF-8");  // where it is installed
  const std::string again = to_svg({"chart", {panel}});
  std::locale::global(before);
  EXPECT_EQ(again, once);
}

}  // namespace
}  // namespace sonde
