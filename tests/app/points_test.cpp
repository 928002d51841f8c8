// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "tests/app/app_test.hpp"

namespace sonde::test {
namespace {

using testing::HasSubstr;

/// About the larger box, of 0.2 m about the origin.
class Points : public AppTest {
 protected:
  Points() {
    folder.write("p.csv", "x,y,z\n0.02,0.01,0.09\n0.3,0.01,0.02\n0,0,-0.1000001\n");
    folder.write("r.csv", "x,y,z,dx,dy,dz\n0.5,0.01,0.02,-2,0,0\n0.5,0.01,0.02,1,0,0\n");
  }
};

TEST_F(Points, of_a_mesh_that_is_taken_as_a_surface_are_said_to_be_so) {
  // A box without one of its faces: how the interior is meant is not known.
  folder.write("open.off",
               "OFF\n8 10 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
               "3 0 2 1\n3 0 3 2\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n"
               "3 3 0 4\n3 3 4 7\n");
  const Outcome run = expect_done("points open.off --points p.csv");
  EXPECT_THAT(run.err, testing::StartsWith("sonde: open.off: "));
  EXPECT_THAT(run.err, HasSubstr("taken as a surface: "));
  EXPECT_EQ(run.err.find("taken"), run.err.rfind("taken")) << "once";
  EXPECT_EQ(expect_done("points open.off --points p.csv --quiet").err, "");
  EXPECT_EQ(expect_done("points large.off --points p.csv").err, "");
}

// Reference: the box itself.
TEST_F(Points, are_inside_or_not_and_have_a_nearest_one) {
  const Csv csv(expect_done("points large.off --points p.csv").out);
  EXPECT_EQ(csv.header, "index,inside,distance,x,y,z,nx,ny,nz,part");
  ASSERT_EQ(csv.rows.size(), 3u);
  EXPECT_EQ(csv.text(0, "inside"), "1");
  EXPECT_NEAR(csv.number(0, "distance"), 0.01, 1e-15);
  EXPECT_NEAR(csv.number(0, "z"), 0.1, 1e-15);
  EXPECT_EQ(csv.text(1, "inside"), "0");
  EXPECT_NEAR(csv.number(1, "distance"), 0.2, 1e-15);
  EXPECT_NEAR(csv.number(1, "nx"), 1, 1e-15);
  EXPECT_EQ(csv.text(2, "inside"), "0");
  EXPECT_NEAR(csv.number(2, "distance"), 1e-7, 1e-15);
  EXPECT_EQ(csv.text(2, "part"), "large.off");
  // From standard input, and of a mesh that is read as a surface or in another unit.
  EXPECT_EQ(Csv(expect_done("points large.off --points - < p.csv").out).rows, csv.rows);
  EXPECT_EQ(
      Csv(expect_done("points large.off --model surface --points p.csv").out).text(0, "inside"),
      "0");
  EXPECT_NEAR(
      Csv(expect_done("points large.off --unit mm --points p.csv").out).number(1, "distance"),
      0.2999, 0.02);
}

TEST_F(Points, rays_say_where_they_meet_it_first) {
  const Csv csv(expect_done("points large.off --rays r.csv").out);
  EXPECT_EQ(csv.header, "index,hit,distance,x,y,z,nx,ny,nz,part");
  EXPECT_EQ(csv.text(0, "hit"), "1");
  EXPECT_NEAR(csv.number(0, "distance"), 0.4, 1e-15);
  EXPECT_NEAR(csv.number(0, "x"), 0.1, 1e-15);
  EXPECT_EQ(csv.text(1, "hit"), "0");
  EXPECT_EQ(csv.text(1, "distance"), "");
  const nlohmann::json json =
      nlohmann::json::parse(expect_done("points large.off --json --rays r.csv").out);
  EXPECT_TRUE(json.at("results")[0].at("hit").get<bool>());
  EXPECT_TRUE(json.at("results")[1].at("distance").is_null());
}

TEST_F(Points, what_makes_no_sense_is_refused) {
  expect_refused("points large.off", 2, "--points or --rays");
  expect_refused("points large.off --points p.csv --rays r.csv", 2, "excludes");
  expect_refused("points large.off --points r.csv", 3, "r.csv:1: the header is");
  expect_refused("points large.off --points missing.csv", 3, "missing.csv");
  expect_refused("points missing.off --points p.csv", 3, "missing.off");
  folder.write("zero.csv", "x,y,z,dx,dy,dz\n0,0,0,1,0,0\n0,0,0,0,0,0\n");
  expect_refused("points large.off --rays zero.csv", 3, "zero.csv:3: the direction");
  folder.write("far.csv", "x,y,z\n1e31,0,0\n");
  expect_refused("points large.off --points far.csv", 3, "far.csv:2: a number is beyond 1e30");
  expect_refused("points large.off --points p.csv --out p.csv", 2, "one of the inputs");
}

}  // namespace
}  // namespace sonde::test
