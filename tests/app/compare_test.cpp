// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "tests/app/study_test.hpp"
#include "tests/support/xml.hpp"

namespace sonde::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class Compare : public StudyTest {
 protected:
  const std::string boxes = "compare boxes.sonde.json ";
};

TEST_F(Compare, a_path_without_poses_is_refused) {
  folder.write("empty.csv", "t,px,py,pz,qw,qx,qy,qz\n");
  folder.write("nothing.csv", "");
  expect_refused(boxes + "--out none --trajectory empty.csv", 3, "empty.csv: holds no poses");
  expect_refused(boxes + "--out none --trajectory nothing.csv", 3, "the file is empty");
  EXPECT_FALSE(fs::exists(folder / "none"));
}

TEST_F(Compare, writes_pictures_tables_and_a_summary) {
  const Outcome run = expect_done(boxes + "--out c");
  const auto written = files("c");
  for (const char* name :
       {"study.json", "parts/pdt.json", "parts/pdg.json", "parts/analytic.json", "wrench.svg",
        "spectrum.svg", "wrench.csv", "summary.json", "summary.csv", "summary.md"})
    EXPECT_TRUE(written.contains(name)) << name;
  EXPECT_EQ(run.out, written.at("summary.md"));
  EXPECT_EQ(parse_xml(written.at("wrench.svg")).all("rect", "frame").size(), 9u);
  const Csv csv(written.at("wrench.csv"));
  ASSERT_EQ(csv.rows.size(), 40u);
  // A box flat on a box, 19 mm deep at the end, 500 N/m: there is nothing to turn for.
  for (const char* method : {"pdt_", "pdg_"}) {
    EXPECT_NEAR(csv.number(39, std::string(method) + "fx"), 9.5, 0.02);
    EXPECT_NEAR(csv.number(39, std::string(method) + "depth"), 0.019, 4e-5);
  }
}

TEST_F(Compare, the_summary_is_machine_readable) {
  const json summary = json::parse(sonde(boxes + "--out c --json").out);
  EXPECT_EQ(summary.at("scene"), "boxes");
  EXPECT_NEAR(summary.at("pdg").at("peak_force"), 9.5, 0.02);
  EXPECT_NEAR(summary.at("pdt").at("force_variation"), 9.5, 0.02) << "it only rises";
  EXPECT_EQ(summary.at("units").at("peak_torque"), "N*m");
  EXPECT_EQ(summary.at("pdg_claims").size(), 6u);
  EXPECT_EQ(summary.at("pdg_claims").at("better_torque"), "none");
}

TEST_F(Compare, settings_and_path_can_be_replaced) {
  const json soft = json::parse(sonde(boxes + "--out soft --json --k 100").out);
  EXPECT_NEAR(soft.at("pdg").at("peak_force"), 1.9, 0.01);
  const json classic =
      json::parse(sonde(boxes + "--out classic --json --coupling classic --k-t 200").out);
  EXPECT_NEAR(classic.at("pdt").at("peak_force"), 3.8, 0.02);
  folder.write("short.csv", "t,px,py,pz,qw,qx,qy,qz\n0,9,0,0,1,0,0,0\n1,8,0,0,1,0,0,0\n");
  const json nothing = json::parse(sonde(boxes + "--out s --json --trajectory short.csv").out);
  EXPECT_EQ(nothing.at("pdg").at("contact_ticks"), 0);
  EXPECT_TRUE(nothing.at("pdg").at("force_above_50_hz").is_null());
}

TEST_F(Compare, a_device_adds_the_largest_stable_stiffness) {
  EXPECT_TRUE(
      json::parse(sonde(boxes + "--out c --json").out).at("pdg").at("stable_stiffness").is_null());
  const json with = json::parse(sonde(boxes + "--out d --json --device sigma.7").out);
  for (const char* method : {"pdt", "pdg"}) {
    const double stable = with.at(method).at("stable_stiffness");
    EXPECT_GT(stable, 0);
    EXPECT_LE(with.at(method).at("passive_stiffness"), stable);
    // The same contact at twice the stiffness asked for is as stiff on the device.
    const json twice =
        json::parse(sonde(boxes + "--out e" + method + " --json --k 1000 --device sigma.7").out);
    EXPECT_NEAR(twice.at(method).at("stable_stiffness").get<double>() / stable, 1, 1e-3);
  }
  expect_refused(boxes + "--out f --device none", 2, "none");
}

TEST_F(Compare, joined_shards_are_the_unsplit_run_to_the_bit) {
  expect_done(boxes + "--out whole --threads 2");
  for (const char* shard : {"1", "2", "3"})
    expect_done(boxes + "--out part" + shard + " --shard " + shard + "/3");
  EXPECT_FALSE(fs::exists(folder / "part1" / "summary.md")) << "a shard says nothing in the end";
  expect_done("merge part3 part1 part2 --out joined");
  EXPECT_EQ(files("joined"), files("whole"));
}

TEST_F(Compare, a_finished_study_is_not_computed_again_and_another_is_not_overwritten) {
  expect_done(boxes + "--out c");
  const auto before = fs::last_write_time(folder / "c" / "parts" / "pdg.json");
  expect_done(boxes + "--out c");
  EXPECT_EQ(fs::last_write_time(folder / "c" / "parts" / "pdg.json"), before);
  const Outcome other = sonde(boxes + "--out c --k 100");
  EXPECT_EQ(other.exit_code, 3);
  EXPECT_THAT(other.err, testing::HasSubstr("other inputs or settings"));
  folder.write("small.off", box_off(0.04));
  EXPECT_EQ(sonde(boxes + "--out c").exit_code, 3) << "a mesh is an input";
}

TEST_F(Compare, refusals) {
  folder.write("bare.sonde.json",
               R"({"probe": {"mesh": "small.off"}, "fixed": {"mesh": "large.off"}})");
  expect_refused("compare bare.sonde.json --out c", 2, "--trajectory");
  expect_refused("compare none.sonde.json --out c", 3, "none.sonde.json");
  expect_refused(boxes, 2, "--out");
  expect_refused(boxes + "--out path.csv", 2, "is a file");
  for (const char* shard : {"0/2", "3/2", "1", "a/b"})
    expect_refused(boxes + "--out c --shard " + shard, 2, "I/N");
  for (const char* k : {"0", "-1", "nan"}) expect_refused(boxes + "--out c --k " + k, 2, "--k");
  expect_refused("merge c --out d", 3, "c");
  expect_refused("merge --out d", 2, "folders");
}

TEST_F(Compare, merging_too_little_names_what_is_missing) {
  expect_done(boxes + "--out part1 --shard 1/3");
  const Outcome run = sonde("merge part1 --out joined");
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.err, testing::HasSubstr("pdg, analytic"));
  EXPECT_FALSE(fs::exists(folder / "joined"));
}

TEST_F(Compare, interrupted_it_leaves_nothing_half_written_and_goes_on_later) {
  write_long_path(20000);
  const std::vector<std::string> arguments{
      "compare", "boxes.sonde.json", "--trajectory", "long.csv", "--out",
      "c",       "--quiet",          "--threads",    "1"};
  EXPECT_EQ(signal_once_begun(start(arguments), "c", SIGINT), 130);
  EXPECT_FALSE(fs::exists(folder / "c" / "summary.md"));
  expect_done(boxes + "--trajectory long.csv --out c");
  expect_done(boxes + "--trajectory long.csv --out whole");
  EXPECT_EQ(files("c"), files("whole"));
}

TEST_F(Compare, two_at_once_in_one_folder_make_one_whole_study) {
  write_long_path(4000);
  const std::vector<std::string> arguments{
      "compare", "boxes.sonde.json", "--trajectory", "long.csv", "--out", "c", "--quiet"};
  for (const pid_t child : {start(arguments), start(arguments)}) {
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
  }
  expect_done(boxes + "--trajectory long.csv --out whole");
  EXPECT_EQ(files("c"), files("whole"));
}

// As the manual shows it; the second shard is killed on its way and started again with the others.
TEST_F(Compare, under_gnu_parallel_with_a_shard_killed_and_started_again) {
  write_long_path(20000);
  const std::vector<std::string> second{
      "compare", "boxes.sonde.json", "--trajectory", "long.csv", "--out",
      "part2",   "--shard",          "2/3",          "--quiet"};
  EXPECT_EQ(signal_once_begun(start(second), "part2", SIGKILL), -1);
  EXPECT_FALSE(fs::exists(folder / "part2" / "parts" / "pdg.json"));
  ASSERT_EQ(in_parallel("compare boxes.sonde.json --trajectory long.csv", 3), 0);
  expect_done("merge part1 part2 part3 --out joined");
  expect_done(boxes + "--trajectory long.csv --out whole");
  EXPECT_EQ(files("joined"), files("whole"));
}

}  // namespace
}  // namespace sonde::test
