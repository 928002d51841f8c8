// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/bench/figures.hpp"

namespace sonde::bench {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

LibraryResult timed(const char* library, const std::vector<double>& poses_us) {
  LibraryResult out{library, {}, poses_us.size(), 0, 0, {}};
  for (const double us : poses_us) out.calls.push_back({us});
  return out;
}

Result result(const char* query, const char* poses, const char* pair,
              std::vector<LibraryResult> libraries) {
  return {query, pair, poses, 100, 200, false, "", std::move(libraries)};
}

const Table sample = {{{"name", ""}, {"time", "µs"}, {"count", ""}},
                      {{std::string("a, \"b\""), 1234.5678, std::int64_t{7}},
                       {std::string("c"), std::monostate{}, std::int64_t{-1}}}};

// By RFC 4180.
TEST(Table, csv_quotes_what_would_break_a_row) {
  EXPECT_EQ(to_csv(sample), "name,time,count\n\"a, \"\"b\"\"\",1234.5678,7\nc,,-1\n");
}

TEST(Table, csv_numbers_read_back_to_the_bit) {
  const double third = 1.0 / 3;
  const std::string text = to_csv({{{"x", ""}}, {{third}}});
  EXPECT_EQ(std::stod(text.substr(text.find('\n') + 1)), third);
}

TEST(Table, json_reads_back) {
  const auto read = nlohmann::json::parse(to_json(sample));
  EXPECT_EQ(read["units"], nlohmann::json({{"time", "µs"}}));
  ASSERT_EQ(read["rows"].size(), 2u);
  EXPECT_EQ(read["rows"][0]["name"], "a, \"b\"");
  EXPECT_EQ(read["rows"][0]["time"], 1234.5678);
  EXPECT_TRUE(read["rows"][1]["time"].is_null());
}

TEST(Table, text_columns_are_aligned_though_a_unit_has_two_bytes) {
  EXPECT_EQ(to_text(sample),
            "name    time  count\n"
            "          µs\n"
            "a, \"b\"  1235      7\n"
            "c          -     -1\n");
}

TEST(Table, text_shows_three_digits_without_an_exponent) {
  const Table numbers = {{{"x", ""}}, {{0.0123456}, {0.99999}, {9.999}, {12.345}, {123456.7}}};
  EXPECT_EQ(to_text(numbers), "     x\n\n 0.012\n  1.00\n  10.0\n  12.3\n123457\n");
}

TEST(Report, ratios_are_theirs_over_ours) {
  const std::vector<Result> results = {
      result("touch", "deep", "p", {timed("Sonde", {1, 2, 3}), timed("FCL", {8, 8, 8})})};
  const auto read = nlohmann::json::parse(to_json(long_table(results)));
  ASSERT_EQ(read["rows"].size(), 2u);
  EXPECT_TRUE(read["rows"][0]["over_sonde"].is_null());
  EXPECT_EQ(read["rows"][1]["over_sonde"], 4);
  EXPECT_EQ(read["rows"][1]["median_us"], 8);
}

TEST(Report, a_library_that_was_not_timed_leaves_its_columns_empty) {
  const std::vector<Result> results = {
      result("touch", "deep", "p", {timed("Sonde", {1}), timed("FCL", {8})}),
      result("touch", "deep", "q", {timed("Sonde", {1}), {"FCL", {}, 0, 0, 0, {}}})};
  const std::string text = wide_tables(results);
  EXPECT_THAT(text, HasSubstr("deep   p"));
  EXPECT_THAT(text, HasSubstr("8.00"));
  EXPECT_EQ(long_table(results).rows.size(), 3u);
}

TEST(Figures, pools_the_poses_and_counts_the_pairs_that_meet_what_is_asked) {
  std::vector<Result> results = {
      result("touch", "deep", "quick", {timed("Sonde", {1, 1}), timed("FCL", {6, 6})}),
      result("touch", "shallow", "quick", {timed("Sonde", {1}), timed("FCL", {6})}),
      result("touch", "deep", "slow", {timed("Sonde", {5}), timed("FCL", {10})}),
      result("touch", "far", "slow", {timed("Sonde", {1000}), timed("FCL", {1})})};
  results.push_back(results[2]);
  results.back().scale = true;  // not one of the figures
  const Table table = figures_table(
      results, {{"f", "touch", {"deep", "shallow"}, "FCL", 2, 3}, {"g", "none", {}, "", 0, 0}});
  ASSERT_EQ(table.rows.size(), 1u);
  const auto read = nlohmann::json::parse(to_json(table))["rows"][0];
  EXPECT_EQ(read["asked"], "<= 2 us, >= 3 x");
  EXPECT_EQ(read["Sonde median"], 1);
  EXPECT_EQ(read["Sonde p99"], 5);
  EXPECT_EQ(read["slowest pair"], "slow");
  EXPECT_EQ(read["slowest median"], 5);
  EXPECT_EQ(read["their median"], 6);
  EXPECT_EQ(read["ratio"], 6);
  EXPECT_EQ(read["least ratio at"], "slow");
  EXPECT_EQ(read["least ratio"], 2);
  EXPECT_EQ(read["pairs that meet it"], "1 of 2");
  EXPECT_EQ(read["their wrong answers"], "0 of 4");
}

TEST(Plot, decades_are_evenly_spaced_and_nothing_else_is_drawn) {
  const std::string svg =
      to_svg({"a < b", "x", "y, µs", {{"c", {1e3, 1e4, 1e5, 0}, {1, 10, 100, 5}}}});
  EXPECT_THAT(svg, HasSubstr("a &lt; b"));
  EXPECT_THAT(svg, HasSubstr("points=\"80,400 300,225 520,50 \""));
  EXPECT_THAT(svg, HasSubstr(">100 k</text>"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(to_svg({}), HasSubstr("</svg>"));
}

}  // namespace
}  // namespace sonde::bench
