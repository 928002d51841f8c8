// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <set>

#include "tests/app/app_test.hpp"

namespace sonde::test {
namespace {

/// A cube of 0.1 m, of 0.01 m in one of 0.2 m along x, and 0.01 and 0.02 m off its middle.
class QueryMotions : public AppTest {
 protected:
  QueryMotions() {
    folder.write("one.csv", "px,py,pz,qw,qx,qy,qz\n0.14,0.01,0.02,1,0,0,0\n");
    folder.write("middle.csv", "px,py,pz,qw,qx,qy,qz\n0.14,0,0,1,0,0,0\n");
  }
  Csv query(const std::string& arguments) const {
    return Csv(expect_done("query boxes.sonde.json " + arguments).out);
  }
};

// Reference: what the cubes are in each other along each axis.
TEST_F(QueryMotions, along_directions) {
  for (const auto& [along, depth] : {std::pair{"--along 1,0,0", 0.01},
                                     {"--along -2,0,0", 0.29},
                                     {"--along 0,1,0", 0.14},
                                     {"--along 0,1,0 --along 0,0,3", 0.13}}) {
    const Csv csv = query("--poses one.csv " + std::string(along));
    EXPECT_EQ(csv.text(0, "status"), "penetrating") << along;
    EXPECT_NEAR(csv.number(0, "depth"), depth, 1e-9) << along;
    EXPECT_EQ(csv.text(0, "lower_bound"), "") << along;
  }
}

// Reference: about its far upper edge, 0.09 m from the face and 0.1 m from its own face, the cube
// turns until its upper edge is on the face: by acos 0.9. The mean square of the distance from the
// axis is 0.1²/6 + 2·0.05² m².
TEST_F(QueryMotions, about_an_axis) {
  const Csv csv = query("--poses middle.csv --about 0.19,0.05,0,0,0,1");
  EXPECT_NEAR(csv.number(0, "depth"), std::sqrt(2 * (1 - 0.9) * (0.01 / 6 + 0.005)), 1e-8);
}

TEST_F(QueryMotions, about_an_axis_that_leads_nowhere) {
  const Outcome run = expect_done("query boxes.sonde.json --poses middle.csv --about 0,0,0,1,0,0");
  EXPECT_EQ(Csv(run.out).text(0, "status"), "failed");
  EXPECT_THAT(run.err, testing::HasSubstr("pose 0 failed"));
}

// Reference: as along the axes.
TEST_F(QueryMotions, in_a_plane) {
  EXPECT_NEAR(query("--poses one.csv --in-plane 0,0,1").number(0, "depth"), 0.01, 2e-5);
  const Csv slid = query("--poses one.csv --in-plane 3,0,0 --no-turn");
  EXPECT_NEAR(slid.number(0, "depth"), 0.13, 2e-5);
  EXPECT_NEAR(slid.number(0, "px"), 0.14, 1e-9);
  EXPECT_EQ(slid.number(0, "qw"), 1);
}

TEST_F(QueryMotions, what_makes_no_sense_is_refused) {
  const std::string head = "query boxes.sonde.json --poses one.csv ";
  expect_refused(head + "--along 0,0,0", 2, "must not be 0,0,0");
  expect_refused(head + "--along 0,1", 2, "--along");
  expect_refused(head + "--along 0,inf,1", 2, "--along");
  expect_refused(head + "--about 0,0,0,0,0,0", 2, "must not be 0,0,0");
  expect_refused(head + "--about 0,0,0,1,0", 2, "--about");
  expect_refused(head + "--along 0,0,1 --in-plane 0,0,1", 2, "give one of them");
  expect_refused(head + "--no-turn", 2, "--in-plane");
  expect_refused(head + "--in-plane 0,0,1 --bound", 2, "leave out --bound");
  expect_refused(head + "--along 0,0,1 --touch", 2, "searches of their own");
  expect_refused(head + "--along 0,0,1 --method pdt", 2, "searches of their own");
  expect_refused(head + "--along 0,0,1 --seeds 3", 2, "exact");
}

// What shares and parts of one run have in common is in the column of the share.
TEST_F(QueryMotions, shares_of_other_motions_are_not_of_one_run) {
  std::set<std::string> runs;
  for (const char* motions :
       {"", "--along 1,0,0", "--along 0,1,0", "--along 1,0,0 --along 0,1,0",
        "--about 0.19,0.05,0,0,0,1", "--in-plane 0,0,1", "--in-plane 0,0,1 --no-turn"})
    runs.insert(query("--poses one.csv --shard 1/1 " + std::string(motions)).text(0, "shard"));
  EXPECT_EQ(runs.size(), 7u);
}

TEST_F(QueryMotions, a_scene_may_follow_them) {
  for (const std::string motions :
       {"--along 1,0,0", "--about 0.19,0.05,0,0,0,1", "--in-plane 0,0,1"})
    EXPECT_EQ(
        Csv(expect_done("query --poses one.csv " + motions + " boxes.sonde.json").out).rows.size(),
        1u)
        << motions;
  expect_refused("query boxes.sonde.json --poses one.csv --in-plane 0,0,1 --in-plane 1,0,0", 2,
                 "once");
}

}  // namespace
}  // namespace sonde::test
