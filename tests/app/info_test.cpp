// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "tests/app/app_test.hpp"

namespace sonde::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using Info = AppTest;

/// Twenty metres are hardly meant: what was exported in mm is read in metres unless somebody says
/// so.
TEST_F(Info, a_mesh_of_twenty_metres_is_probably_in_another_unit) {
  std::string text =
      "OFF\n4 4 0\n0 0 0\n20 0 0\n0 20 0\n0 0 20\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  folder.write("block.off", text);
  EXPECT_THAT(expect_done("info block.off").out,
              HasSubstr("in mm it would be 20 mm; give --unit mm"));
  EXPECT_EQ(expect_done("info --unit mm block.off").out.find("give --unit"), std::string::npos);
}

TEST_F(Info, a_zero_has_no_sign) {
  folder.write("flat.off", "OFF\n3 1 0\n0 -0 -0\n1 -0 0\n0 1 -0\n3 0 1 2\n");
  const std::string text = expect_done("info flat.off").out;
  EXPECT_EQ(text.find("-0,"), text.npos) << text;
  EXPECT_EQ(text.find("-0)"), text.npos) << text;
}

// Reference: boxes whose faces are 0.05 apart, one in the other, and one that reaches 0.01 into the
// other's face, which is the shortest way out (no turn of a box moves its face less).
TEST_F(Info, two_meshes_are_told_how_far_apart_they_lie) {
  folder.write("away.obj", "v 0.15 0 0\nv 0.15 1 0\nv 0.15 0 1\nf 1 2 3\n");
  const json apart = json::parse(expect_done("info --json large.off away.obj").out);
  EXPECT_EQ(apart.at("format"), 1);
  EXPECT_NEAR(apart.at("clearance").at("distance").get<double>(), 0.05, 1e-12);
  EXPECT_FALSE(apart.at("clearance").at("overlapping").get<bool>());
  EXPECT_THAT(expect_done("info large.off away.obj").out,
              testing::HasSubstr("apart           0.05 m"));
  EXPECT_THAT(expect_done("info large.off small.off").out,
              testing::HasSubstr("they touch or overlap"));
  EXPECT_FALSE(json::parse(expect_done("info --json large.off").out).contains("clearance"));
  EXPECT_EQ(apart.at("clearance").at("signed_distance"), apart.at("clearance").at("distance"));
  folder.write("reaching.off",
               "OFF\n8 6 0\n0.09 -0.1 -0.1\n0.29 -0.1 -0.1\n0.29 0.1 -0.1\n0.09 0.1 -0.1\n"
               "0.09 -0.1 0.1\n0.29 -0.1 0.1\n0.29 0.1 0.1\n0.09 0.1 0.1\n4 0 3 2 1\n4 4 5 6 7\n"
               "4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
  const json deep = json::parse(expect_done("info --json large.off reaching.off").out);
  EXPECT_TRUE(deep.at("clearance").at("overlapping").get<bool>());
  EXPECT_NEAR(deep.at("clearance").at("signed_distance").get<double>(), -0.01, 1e-5);
  EXPECT_THAT(expect_done("info large.off reaching.off").out,
              testing::HasSubstr("they touch or overlap: 0.01"));
}

TEST_F(Info, text_has_numbers_and_units) {
  const Outcome run = expect_done("info small.off large.off");
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, AllOf(HasSubstr("small.off\n"), HasSubstr("large.off\n"),
                             HasSubstr("triangles       12\n"), HasSubstr("solid ("),
                             HasSubstr("volume V        0.001 m³"), HasSubstr("none"),
                             HasSubstr("bytes a triangle)\n")));
}

TEST_F(Info, json_has_every_digit) {
  const Outcome run = expect_done("info --json --unit mm small.off");
  const json mesh = json::parse(run.out).at("meshes").at(0);
  EXPECT_EQ(mesh.at("triangles"), 12);
  EXPECT_EQ(mesh.at("vertices"), 8);
  EXPECT_EQ(mesh.at("model"), "solid");
  EXPECT_NEAR(mesh.at("volume").get<double>(), 1e-12, 1e-24);
  EXPECT_NEAR(mesh.at("inertia").at(2).get<double>(), 1e-8 / 6, 1e-20);
  EXPECT_NEAR(mesh.at("bounds").at("high").at(0).get<double>(), 5e-5, 1e-16);
  EXPECT_EQ(mesh.at("defects").at("open_edges"), 0);
  EXPECT_EQ(mesh.at("defects").at("turned"), false);
  // Eight vertices of three doubles, twelve triangles of three indices, and a tree.
  EXPECT_GT(mesh.at("memory_bytes"), 8 * 24 + 12 * 12);
  EXPECT_LT(mesh.at("memory_bytes"), 4096);
}

TEST_F(Info, an_allowance_is_said) {
  const Outcome run = expect_done("info --allowance 1e-3 small.off");
  EXPECT_THAT(run.out, HasSubstr("offset          taken 1 mm smaller (allowance); its mass is the "
                                 "mesh's; furthest corner 1.73205 mm"));
  const json mesh =
      json::parse(expect_done("info --json --safety 0.25 small.off").out).at("meshes").at(0);
  EXPECT_EQ(mesh.at("offset").at("by"), 0.25);
  EXPECT_NEAR(mesh.at("bounds").at("high").at(0).get<double>(), 0.3, 1e-15);
  EXPECT_NEAR(mesh.at("volume").get<double>(), 1e-3, 1e-15) << "of the mesh";
  expect_refused("info --allowance 0.06 small.off", 3, "small.off");
  expect_refused("info --allowance -1 small.off", 2, "--allowance");
  expect_refused("info --allowance 1 --safety 1 small.off", 2, "--safety");
  expect_refused("info --allowance nan small.off", 2, "--allowance");
}

TEST_F(Info, defects_are_counted) {
  folder.write("open.off",
               "OFF\n6 3 0\n0 0 0\n1 0 0\n0 1 0\n5 5 5\n5 5 5\n5 6 5\n"
               "3 0 1 2\n3 0 1 2\n3 3 4 5\n");
  const Outcome text = sonde("info open.off");
  EXPECT_THAT(text.out, AllOf(HasSubstr("surface ("), HasSubstr("area A"),
                              HasSubstr("1 triangles without area"), HasSubstr("1 duplicate")));
  const json mesh = json::parse(sonde("info --json open.off").out).at("meshes").at(0);
  EXPECT_EQ(mesh.at("defects").at("degenerate_triangles"), 1);
  EXPECT_EQ(mesh.at("bounds").at("high").at(0), 1) << "of the triangles that count";
}

TEST_F(Info, one_bad_mesh_among_good_ones_and_nothing_is_written) {
  folder.write("bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n");
  expect_refused("info small.off bad.off none.off", 3, "bad.off");
  expect_refused("info small.off bad.off none.off", 3, "none.off");
  expect_refused("info small.off bad.off --out r.txt", 3, "bad.off");
}

TEST_F(Info, a_model_that_does_not_fit_is_refused) {
  folder.write("open.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  expect_refused("info --model solid open.off", 3, "open.off");
  expect_done("info --model surface small.off");
}

TEST_F(Info, out_writes_a_file) {
  EXPECT_EQ(sonde("info small.off --out r.txt").out, "");
  EXPECT_EQ(text_of(folder / "r.txt"), sonde("info small.off").out);
}

}  // namespace
}  // namespace sonde::test
