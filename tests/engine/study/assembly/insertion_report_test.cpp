// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/assembly/insertion_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/base/error.hpp"
#include "engine/body/body.hpp"
#include "tests/support/csv.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

/// A peg 19 mm wide over a slot 20 mm wide and 60 mm deep between two walls.
InsertionRequest peg_over_slot() {
  PolygonSoup walls;
  for (const double side : {-1.0, 1.0}) {
    const std::size_t first = walls.points.size();
    const PolygonSoup wall = test::box({0.02, 0.2, 0.06});
    for (const Vec3& x : wall.points) walls.points.push_back(x + Vec3(0.02 * side, 0, -0.03));
    for (Polygon p : wall.polygons) {
      for (std::size_t& corner : p) corner += first;
      walls.polygons.push_back(p);
    }
  }
  const Pair pair(test::body(test::box({0.019, 0.05, 0.1})), test::body(walls));
  InsertionRequest out{
      .pair = pair,
      .way = way_along(pair, {Quat::Identity(), Vec3(0, 0, 0.06)}, -Vec3::UnitZ(), 0.05, 0),
      .coupling = {},
      .map = {},
      .about = {}};
  out.steps = 20;
  out.wanted = 0.05;
  out.map = InsertionMap{.axis = -Vec3::UnitZ(),
                         .lateral = Vec3::UnitX(),
                         .largest_offset = 1e-3,
                         .largest_tilt = 0.05,
                         .offsets = 11,
                         .tilts = 9};
  out.about = R"({"wanted": 0.05, "largest_tilt": 0.05, "largest_offset": 0.001})";
  return out;
}

std::string text_of(const std::vector<StudyFile>& files, const std::string& name) {
  for (const StudyFile& file : files)
    if (file.name == name) return file.text;
  return "no " + name;
}

TEST(InsertionReport, the_words_have_the_allowance_that_the_numbers_have) {
  InsertionRequest request = peg_over_slot();
  request.map.reset();
  const auto words = [&](const std::string& probe) {
    request.about = R"({"wanted": 0.05, "inputs": {"probe": {)" + probe + "}}}";
    return text_of(insertion_files("", compute_at_once(plan_insertion(request), 1, {})),
                   "summary.md");
  };
  EXPECT_THAT(words(R"("offset": -5e-05)"),
              HasSubstr("The probe is taken 0.05 mm smaller (allowance)"));
  EXPECT_THAT(words(R"("offset": -1e-06)"), HasSubstr("0.001 mm smaller (allowance)"));
  EXPECT_THAT(words(R"("offset": 0.002)"), HasSubstr("2 mm larger (safety)"));
  EXPECT_THAT(words(""), Not(HasSubstr("is taken")));
}

// Reference: by hand. The peg hangs by its middle, 40 mm of it in at the end. Tilted by θ, its
// lower corners are ±d/2 cos θ + 50 mm sin θ aside of the middle, and where it crosses the mouth at
// the end its sides are d/2 / cos θ and 10 mm tan θ aside.
TEST(InsertionReport, a_point_of_the_map_is_as_reckoned_by_hand) {
  const InsertionRequest request = peg_over_slot();
  const auto files = insertion_files("", compute_at_once(plan_insertion(request), 2, {}));
  const test::Csv map(text_of(files, "map.csv"));
  EXPECT_EQ(map.header, "offset,tilt,free_travel,goes_in");
  ASSERT_EQ(map.rows.size(), 99u);
  const double d = 0.019, D = 0.02;
  int in = 0, out = 0;
  for (std::size_t i = 0; i < map.rows.size(); ++i) {
    const double offset = map.number(i, "offset"), tilt = map.number(i, "tilt");
    const double at_foot = 0.05 * std::sin(tilt), half = 0.5 * d * std::cos(tilt);
    // The foot swings one way; the other side of the peg is widest at the mouth, 10 mm under the
    // middle at the end.
    const double at_mouth = 0.01 * std::tan(tilt), side = 0.5 * d / std::cos(tilt);
    const auto room_of = [&](double sign) {
      const double foot = 0.5 * D - std::abs(offset - sign * at_foot) - half;
      const double mouth = 0.5 * D - std::abs(offset - sign * at_mouth) - side;
      return std::min(foot, mouth);
    };
    // Tilts are about axis × lateral = −z × x = −y: a positive one swings the foot towards +x.
    const double room = room_of(-1);
    if (std::abs(room) < 2e-6) continue;
    EXPECT_EQ(map.text(i, "goes_in"), room > 0 ? "1" : "0") << offset << ", " << tilt;
    (room > 0 ? in : out) += 1;
  }
  EXPECT_GT(in, 10);
  EXPECT_GT(out, 10);
}

TEST(InsertionReport, one_long_way_says_how_far_it_is) {
  InsertionRequest request = peg_over_slot();
  request.map.reset();
  Study study = plan_insertion(request);
  ASSERT_EQ(study.parts.size(), 1u);
  std::vector<double> told;
  study.parts[0].compute([&] {
    told.push_back(*study.parts[0].done);
    return false;
  });
  EXPECT_GT(told.size(), 20u);
  EXPECT_TRUE(std::ranges::is_sorted(told));
  EXPECT_GT(told.back(), 0.6);
}

TEST(InsertionReport, tables_and_pictures_say_the_same) {
  InsertionRequest request = peg_over_slot();
  request.way =
      way_along(request.pair, {Quat::Identity(), Vec3(0.8e-3, 0, 0.06)}, -Vec3::UnitZ(), 0.05, 0);
  const auto files = insertion_files("", compute_at_once(plan_insertion(request), 1, {}));
  const Json summary = Json::parse(text_of(files, "summary.json"));
  EXPECT_EQ(summary.at("format"), 1);
  EXPECT_FALSE(summary.at("goes_in").get<bool>());
  const double first = summary.at("first_contact").at("travel").get<double>();
  EXPECT_NEAR(first, 0.01, 1e-9 * 0.05);
  EXPECT_LE(summary.at("first_contact").at("tolerance").get<double>(), 1e-9 * 0.05);
  EXPECT_THAT(text_of(files, "summary.md"), HasSubstr("It binds after 10 mm of 50 mm"));
  const test::Csv way(text_of(files, "insert.csv"));
  EXPECT_GT(way.rows.size(), 21u) << "more about the first contact";
  double travel = -1;
  for (std::size_t i = 0; i < way.rows.size(); ++i) {
    EXPECT_GT(way.number(i, "travel"), travel);
    travel = way.number(i, "travel");
    EXPECT_EQ(way.text(i, "clearance").empty(), travel >= 0.01) << travel;
    if (travel == first) {
      EXPECT_NEAR(way.number(i, "nz"), 1, 1e-9) << "not the direction of rounding";
    }
    // F = k t, and t is what the depth is but for the turn.
    EXPECT_LE(way.number(i, "fz"), 500 * way.number(i, "depth") * (1 + 1e-9));
    EXPECT_GE(way.number(i, "fz"), 0.9 * 500 * way.number(i, "depth"));
  }
  for (const char* name : {"insert.svg", "map.svg"})
    EXPECT_THAT(text_of(files, name), HasSubstr("</svg>")) << name;
  EXPECT_THAT(text_of(files, "map.svg"), HasSubstr("goes in"));
}

/// A block over a foot, which it comes down on after 10 mm, between two walls.
InsertionRequest block_over_foot(const std::string& name) {
  const PolygonSoup walls = test::joined(test::placed(test::box({0.02, 0.2, 0.06}), {-0.03, 0, 0}),
                                         test::placed(test::box({0.02, 0.2, 0.06}), {0.03, 0, 0}));
  const PolygonSoup foot = test::placed(test::box({0.02, 0.02, 0.01}), {0, 0, -0.025});
  const auto fixed = with_parts(*test::body(test::joined(walls, foot)),
                                {{"walls", test::body(walls), {}}, {name, test::body(foot), {}}});
  const Pair pair(test::body(test::box({0.03, 0.05, 0.02})), fixed);
  InsertionRequest out{
      .pair = pair,
      .way = way_along(pair, {Quat::Identity(), Vec3::Zero()}, -Vec3::UnitZ(), 0.015, 0),
      .coupling = {},
      .map = {},
      .about = {}};
  out.steps = 3;
  out.wanted = 0.015;
  out.about = R"({"wanted": 0.015})";
  return out;
}

// Reference: by hand. The block is nearer to the walls where it begins, and comes down on the foot.
TEST(InsertionReport, the_part_that_binds_is_named) {
  StudyFolder study = compute_at_once(plan_insertion(block_over_foot("foot")), 1, {});
  const auto files = insertion_files("", study);
  const Json summary = Json::parse(text_of(files, "summary.json"));
  EXPECT_EQ(summary.at("first_contact").at("part"), "foot");
  EXPECT_THAT(text_of(files, "summary.md"),
              HasSubstr("It binds after 10 mm of 15 mm, on foot, at ("));
  const test::Csv way(text_of(files, "insert.csv"));
  EXPECT_EQ(way.text(0, "part"), "walls");
  EXPECT_EQ(way.text(way.rows.size() - 1, "part"), "foot");
  // A part of before there were names.
  Json part = Json::parse(*study.results[0]);
  part.at("first").erase("part");
  for (Json& row : part.at("steps")) row.erase(row.size() - 1);
  study.results[0] = part.dump();
  const auto before = insertion_files("", study);
  EXPECT_EQ(test::Csv(text_of(before, "insert.csv")).text(0, "part"), "");
  EXPECT_THAT(text_of(before, "summary.md"), HasSubstr("It binds after 10 mm of 15 mm, at ("));
}

TEST(InsertionReport, any_name_of_a_part_is_one_cell_of_the_table) {
  const std::string name = "a \"foot\", left";
  const InsertionRequest request = block_over_foot(name);
  const auto files = insertion_files("", compute_at_once(plan_insertion(request), 1, {}));
  EXPECT_THAT(text_of(files, "insert.csv"), HasSubstr(R"(,"a ""foot"", left")"));
  EXPECT_EQ(Json::parse(text_of(files, "summary.json")).at("first_contact").at("part"), name);
}

TEST(InsertionReport, a_way_that_binds_has_no_least_room_in_words) {
  const InsertionRequest request = block_over_foot("foot");
  const auto files = insertion_files("", compute_at_once(plan_insertion(request), 1, {}));
  EXPECT_THAT(text_of(files, "summary.md"), HasSubstr("It binds"));
  EXPECT_THAT(text_of(files, "summary.md"), Not(HasSubstr("room")));
  EXPECT_LT(Json::parse(text_of(files, "summary.json")).at("least_clearance").get<double>(), 1e-10);
}

// Reference: by hand. The walls are lowered to plates that no row of the table is beside.
TEST(InsertionReport, the_least_room_is_that_between_the_rows_too) {
  InsertionRequest request = peg_over_slot();
  PolygonSoup plates;
  for (const double side : {-1.0, 1.0}) {
    const std::size_t first = plates.points.size();
    const PolygonSoup plate = test::box({0.02, 0.2, 1e-4});
    for (const Vec3& x : plate.points) plates.points.push_back(x + Vec3(0.0196 * side, 0, 0));
    for (Polygon p : plate.polygons) {
      for (std::size_t& corner : p) corner += first;
      plates.polygons.push_back(p);
    }
  }
  request.pair = Pair(test::body(test::box({0.019, 0.05, 1e-4})), test::body(plates));
  request.way =
      way_along(request.pair, {Quat::Identity(), Vec3(0, 0, 0.0263)}, -Vec3::UnitZ(), 0.05, 0);
  request.map.reset();
  StudyFolder study = compute_at_once(plan_insertion(request), 1, {});
  auto files = insertion_files("", study);
  Json summary = Json::parse(text_of(files, "summary.json"));
  EXPECT_NEAR(summary.at("least_clearance").get<double>(), 1e-4, 1e-7);
  EXPECT_NEAR(summary.at("least_clearance_at").get<double>(), 0.0263, 1e-4);
  EXPECT_NEAR(summary.at("least_clearance_tolerance").get<double>(), 1e-7, 1e-9);
  EXPECT_EQ(summary.at("least_clearance_searched"), 0.05);
  EXPECT_TRUE(summary.at("least_clearance_complete").get<bool>());
  EXPECT_THAT(text_of(files, "summary.md"), HasSubstr("The least room where it is free is 0.1"));
  EXPECT_THAT(text_of(files, "summary.md"), Not(HasSubstr("limit")));
  // A part of before the search, or one whose search was ended, says what counts.
  Json part = Json::parse(*study.results[0]);
  part.erase("room");
  study.results[0] = part.dump();
  files = insertion_files("", study);
  summary = Json::parse(text_of(files, "summary.json"));
  EXPECT_GT(summary.at("least_clearance").get<double>(), 5e-4);
  EXPECT_FALSE(summary.at("least_clearance_complete").get<bool>());
  EXPECT_THAT(text_of(files, "summary.md"), HasSubstr("ended at its limit of work after 0 mm"));
}

TEST(InsertionReport, a_folder_that_is_not_whole_is_refused) {
  StudyFolder study = compute_at_once(plan_insertion(peg_over_slot()), 2, {});
  study.results[0].reset();
  EXPECT_THROW(insertion_files("f", study), InputError);
  study.results[0] = "{}";
  EXPECT_THROW(insertion_files("f", study), InputError);
}

}  // namespace
}  // namespace sonde
