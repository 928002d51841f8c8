// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/tuning/tuning_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "tests/engine/study/tuning/made_up_results.hpp"

namespace sonde {
namespace {

using test::column;
using test::line;
using test::results;
using test::stable_up_to;
using test::unstable;

TEST(TuningMap, classes_from_the_worst_down) {
  HoldReport report;
  EXPECT_EQ(class_of({100, report}, 200), MapClass::unstable);
  report.stable = report.chattering = report.saturated = true;
  EXPECT_EQ(class_of({100, report}, 200), MapClass::saturated);
  report.saturated = false;
  EXPECT_EQ(class_of({100, report}, 200), MapClass::chattering);
  report.chattering = false;
  EXPECT_EQ(class_of({100, report}, 200), MapClass::passive);
  EXPECT_EQ(class_of({300, report}, 200), MapClass::stable);
}

TEST(TuningMap, has_a_row_for_each_run_and_a_picture_for_each_mode) {
  TuningResults r = stable_up_to({3000, 1500});
  r.device_id = "a.device";
  const std::string csv = map_csv(r);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 4);
  const std::size_t commas = static_cast<std::size_t>(std::count(csv.begin(), csv.end(), ','));
  EXPECT_EQ(commas, 28u * 5);
  EXPECT_THAT(map_svg(r),
              testing::AllOf(testing::HasSubstr("<svg"), testing::HasSubstr("passive in theory"),
                             testing::HasSubstr("recommended")));
  r.mode = Coupling::Mode::classic;
  for (TuningLine& each : r.lines) each.axis = GainAxis::translation;
  EXPECT_THAT(map_svg(r), testing::HasSubstr("damping b_t"));
}

TEST(TuningMap, says_which_row_is_which_and_where_theory_is_crossed) {
  TuningResults r = stable_up_to({3000});
  for (const char* words : {">flat,<", ">light hand<", ">not run<", "above the limit in theory"})
    EXPECT_THAT(map_svg(r), testing::HasSubstr(words));
  r.lines[0].columns[0].theory_stable = 2500;
  EXPECT_THAT(map_svg(r), testing::Not(testing::HasSubstr("above the limit in theory")));
  r.lines[0].columns[0].without_friction = {1200, unstable};
  const std::string csv = map_csv(r);
  EXPECT_THAT(csv, testing::HasSubstr(",2500,750,1200,\n"));
  EXPECT_THAT(map_svg(r), testing::HasSubstr("limit without friction"));
}

/// Width of the first cell of a colour.
double width_of(const std::string& svg, const std::string& colour) {
  const std::regex cell("<rect [^>]*width=\"([0-9.]+)\"[^>]*fill=\"" + colour + "\"");
  std::smatch found;
  return std::regex_search(svg, found, cell) ? std::stod(found[1]) : 0;
}

TEST(TuningMap, cells_meet_halfway_on_the_logarithmic_scale) {
  TuningResults r = results();
  r.mode = Coupling::Mode::classic;
  r.lines = {line(0, GainAxis::translation, {column(0, 5000, 100, unstable)})};
  // Runs at 100 and 10 000 N/m, nothing between them: each has half of the picture's width.
  r.lines[0].columns[0].theory_passive = 0;
  const std::string svg = map_svg(r);
  const double stable = width_of(svg, "#c7e9c0"), wild = width_of(svg, "#d7301f");
  EXPECT_GT(stable, 100);
  EXPECT_NEAR(stable / wild, 1, 0.02);
}

}  // namespace
}  // namespace sonde
