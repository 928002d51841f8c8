// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "engine/scene/poses.hpp"
#include "tests/app/study_test.hpp"
#include "tests/support/xml.hpp"

namespace sonde::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

class Trade : public StudyTest {
 protected:
  /// What a folder holds, but for the times.
  std::map<std::string, std::string> but_for_times(const std::string& name) const {
    std::map<std::string, std::string> out;
    for (const auto& [file, text] : files(name)) {
      if (file.ends_with(".json"))
        out[file] = without_times(json::parse(text)).dump();
      else if (file == "trade.csv")
        out[file] = json(Csv(text).without({"time_us"})).dump();
      else if (file == "summary.csv")
        out[file] = json(Csv(text).without({"median_us", "p99_us", "p999_us"})).dump();
      else if (file == "poses.csv" || file == "extremes.csv")
        out[file] = text;
      else
        out[file];  // the picture and the printed tables are of times too
    }
    return out;
  }

  const std::string boxes = "trade boxes.sonde.json --count 3 ";

 private:
  static json without_times(json value) {
    for (const char* key : {"time_us", "median_us", "p99_us", "p999_us"})
      if (value.is_object()) value.erase(key);
    for (json& each : value)
      if (each.is_structured()) each = without_times(each);
    return value;
  }
};

// Reference: `sonde query`, which reads the file.
TEST_F(Trade, measures_the_mapping_of_time_and_accuracy) {
  const Outcome run = expect_done(boxes + "--calibrate --out c");
  ASSERT_TRUE(fs::exists(folder / "c/calibration.json"));
  const Outcome used = expect_done(
      "query boxes.sonde.json --poses c/poses.csv --accuracy 20% --calibration c/calibration.json");
  EXPECT_THAT(used.out, HasSubstr("within"));
  EXPECT_EQ(sonde(boxes + "--calibrate --shard 1/2 --out d").exit_code, 2);
  EXPECT_FALSE(fs::exists(folder / "d"));
}

TEST_F(Trade, writes_a_picture_tables_and_a_summary) {
  const Outcome run = expect_done(boxes + "--out t");
  const auto written = files("t");
  for (const char* name : {"study.json", "parts/pose-2.json", "parts/coherent-pdg-converged.json",
                           "trade.svg", "trade.csv", "poses.csv", "summary.json", "summary.csv"})
    EXPECT_TRUE(written.contains(name)) << name;
  EXPECT_EQ(run.out, written.at("summary.md"));
  EXPECT_EQ(parse_xml(written.at("trade.svg")).all("rect", "frame").size(), 6u);
  // The poses are those of the path, and what sonde query finds there is what the study found.
  ASSERT_EQ(read_poses(folder / "t/poses.csv").size(), 3u);
  const Csv trade(written.at("trade.csv"));
  const Csv query(sonde("query boxes.sonde.json --poses t/poses.csv").out);
  for (std::size_t i = 0; i < trade.rows.size(); ++i) {
    if (trade.text(i, "kind") != "static" || trade.text(i, "method") != "pdg") continue;
    if (trade.text(i, "budget") != "0") continue;
    const double depth = query.number(std::stoul(trade.text(i, "pose")), "depth");
    EXPECT_NEAR(trade.number(i, "depth"), depth, 1e-3 * depth);
  }
}

TEST_F(Trade, meshes_alone_are_measured_at_random_poses) {
  const json summary =
      json::parse(sonde("trade " + loose + "--count 2 --seed 3 --json --out t").out);
  EXPECT_EQ(summary.at("poses"), 2);
  for (const json& setting : summary.at("settings")) EXPECT_NE(setting.at("kind"), "coherent");
  const std::string poses = text_of(folder / "t/poses.csv");
  expect_done("trade " + loose + "--count 2 --seed 4 --out u");
  EXPECT_NE(text_of(folder / "u/poses.csv"), poses);
}

TEST_F(Trade, of_a_file_of_poses_those_that_overlap_are_measured) {
  const json summary =
      json::parse(sonde("trade " + loose + "--poses poses.csv --json --out t").out);
  EXPECT_EQ(summary.at("poses"), 2) << "the second of three is apart";
  expect_done("trade " + loose + "--poses poses.csv --count 1 --out u");
  EXPECT_EQ(read_poses(folder / "u/poses.csv").size(), 1u);
}

TEST_F(Trade, joined_shards_are_the_unsplit_run_but_for_the_times) {
  expect_done(boxes + "--out whole --threads 2");
  for (const char* shard : {"1", "2", "3"})
    expect_done(boxes + "--out part" + shard + " --threads 1 --shard " + shard + "/3");
  EXPECT_FALSE(fs::exists(folder / "part1" / "summary.md")) << "a shard says nothing in the end";
  expect_done("merge part3 part1 part2 --out joined");
  EXPECT_EQ(but_for_times("joined"), but_for_times("whole"));
  // Where the times are the same too, so is everything.
  for (const auto& entry : fs::directory_iterator(folder / "whole/parts"))
    for (const char* part : {"part1", "part2", "part3"})
      if (fs::exists(folder / part / "parts" / entry.path().filename()))
        fs::copy_file(entry, folder / part / "parts" / entry.path().filename(),
                      fs::copy_options::overwrite_existing);
  expect_done("merge part1 part2 part3 --out again");
  EXPECT_EQ(files("again"), files("whole"));
  // The same parts twice, with other times: the first ones are kept.
  expect_done("merge whole joined --out both");
  EXPECT_EQ(files("both"), files("whole"));
}

TEST_F(Trade, the_search_is_measured_with_another_number) {
  expect_done(boxes + "--out plain");
  expect_done(boxes + "--vary most_first_sketches=1 --vary most_sketches=1 --out varied");
  EXPECT_THAT(files("varied").at("study.json"), HasSubstr("most_first_sketches=1"));
  // The long searches, which give the reference, are the same.
  EXPECT_EQ(files("plain").at("poses.csv"), files("varied").at("poses.csv"));
  expect_refused(boxes + "--vary most_first_sketches=2 --out varied", 3,
                 "other inputs or settings");
  expect_refused(boxes + "--vary first_sketch=2 --out other", 2, "most_first_sketches");
}

TEST_F(Trade, refusals) {
  folder.write("none.csv", "px,py,pz,qw,qx,qy,qz\n");
  folder.write("apart.csv", "px,py,pz,qw,qx,qy,qz\n9,0,0,1,0,0,0\n");
  folder.write("far.csv", "t,px,py,pz,qw,qx,qy,qz\n0,9,0,0,1,0,0,0\n1,8,0,0,1,0,0,0\n");
  expect_refused("trade " + loose + "--poses none.csv --out t", 3, "none.csv: the probe overlaps");
  expect_refused("trade " + loose + "--poses apart.csv --out t", 3,
                 "apart.csv: the probe overlaps");
  folder.write("empty.csv", "t,px,py,pz,qw,qx,qy,qz\n");
  expect_refused("trade boxes.sonde.json --trajectory empty.csv --out t", 3, "empty.csv");
  expect_refused("trade boxes.sonde.json --trajectory far.csv --out t", 3, "far.csv: the probe");
  expect_refused("trade " + loose + "--poses missing.csv --out t", 3, "missing.csv");
  expect_refused("trade " + loose + "--poses path.csv --out t", 3, "path.csv");
  expect_refused("trade --out t", 2, "SCENE");
  expect_refused("trade boxes.sonde.json", 2, "--out");
  expect_refused("trade boxes.sonde.json --out path.csv", 2, "is a file");
  for (const char* count : {"0", "-1", "x"})
    expect_refused("trade boxes.sonde.json --out t --count " + std::string(count), 2, "--count");
  expect_refused("trade boxes.sonde.json --out t --shard 3/2", 2, "I/N");
}

TEST_F(Trade, a_finished_study_is_not_computed_again_and_another_is_not_overwritten) {
  expect_done(boxes + "--out t");
  const auto before = files("t");
  expect_done(boxes + "--out t");
  EXPECT_EQ(files("t"), before) << "the times as well";
  expect_refused(boxes + "--out t --seed 2", 3, "other inputs or settings");
}

TEST_F(Trade, interrupted_it_leaves_nothing_half_written_and_goes_on_later) {
  write_long_path(4000);
  const std::vector<std::string> arguments{"trade",        "boxes.sonde.json", "--count", "3",
                                           "--trajectory", "long.csv",         "--out",   "t",
                                           "--quiet",      "--threads",        "1"};
  EXPECT_EQ(signal_once_begun(start(arguments), "t", SIGINT), 130);
  EXPECT_FALSE(fs::exists(folder / "t" / "summary.md"));
  for (const auto& [name, text] : files("t"))
    EXPECT_FALSE(json::parse(text, nullptr, false).is_discarded()) << name;
  expect_done(boxes + "--out t --trajectory long.csv");
  EXPECT_TRUE(fs::exists(folder / "t" / "summary.md"));
}

// As the manual shows it; the second shard is killed on its way and started again with the others.
TEST_F(Trade, under_gnu_parallel_with_a_shard_killed_and_started_again) {
  write_long_path(3000);
  const std::vector<std::string> second{
      "trade", "boxes.sonde.json", "--count", "3",      "--trajectory", "long.csv", "--out",
      "part2", "--shard",          "2/3",     "--quiet"};
  EXPECT_EQ(signal_once_begun(start(second), "part2", SIGKILL), -1);
  EXPECT_FALSE(fs::exists(folder / "part2" / "parts" / "pose-2.json"));
  ASSERT_EQ(in_parallel(boxes + "--trajectory long.csv", 3), 0);
  expect_done("merge part1 part2 part3 --out joined");
  expect_done(boxes + "--trajectory long.csv --out whole");
  EXPECT_EQ(but_for_times("joined"), but_for_times("whole"));
}

/// Reference: each scene's own study, which is the one without a folder.
TEST_F(Trade, a_folder_of_scenes_has_a_front_and_is_joined_from_shards) {
  fs::create_directory(folder / "pairs");
  for (const char* name : {"one", "two"})
    folder.write(std::string("pairs/") + name + ".sonde.json",
                 R"({"probe": {"mesh": "../small.off"}, "fixed": {"mesh": "../large.off"},
                     "trajectory": "../path.csv"})");
  const std::string pairs = "trade pairs --count 2 ";
  expect_done(pairs + "--out whole");
  const auto whole = but_for_times("whole");
  for (const char* name :
       {"front.svg", "pairs.csv", "summary.json", "one/trade.svg", "two/poses.csv"})
    EXPECT_TRUE(whole.contains(name)) << name;
  const Csv rows(text_of(folder / "whole/pairs.csv"));
  EXPECT_EQ(rows.text(0, "pair"), "one");
  EXPECT_EQ(rows.text(rows.rows.size() - 1, "pair"), "two");
  expect_done(pairs + "--shard 1/2 --out a --quiet");
  EXPECT_FALSE(fs::exists(folder / "a/front.svg"));
  expect_done(pairs + "--shard 2/2 --out b --quiet");
  expect_done(pairs + "--shard 1/2 --out a --quiet");  // nothing is left to do
  expect_done("merge a b --out joined");
  expect_done(pairs + "--shard 2/2 --out a --quiet");
  expect_done("merge a b --out a");
  EXPECT_TRUE(fs::exists(folder / "a/front.svg"));
  auto joined = but_for_times("joined"), alone = whole;
  for (auto* each : {&joined, &alone}) each->erase("pairs.csv");  // of times too
  EXPECT_EQ(joined, alone);
  expect_refused("trade pairs --series s.csv --out c", 2, "of one pair");
  fs::create_directory(folder / "empty");
  expect_refused("trade empty --out c", 3, "holds no scene");
}

TEST_F(Trade, answers_of_another_program_are_in_the_picture) {
  folder.write("s.csv", "series,pose,depth,time_us\nPeer,0,0.01,3\nPeer,1,,4\n");
  expect_done(boxes + "--series s.csv --out t");
  EXPECT_THAT(text_of(folder / "t/trade.svg"), HasSubstr("Peer, median"));
  folder.write("bad.csv", "series,pose,depth,time_us\nPeer,9,0.01,3\n");
  const Outcome bad = sonde(boxes + "--series bad.csv --out refused");
  EXPECT_EQ(bad.exit_code, 3);
  EXPECT_FALSE(fs::exists(folder / "refused")) << "before anything is computed";
  EXPECT_THAT(bad.err, HasSubstr("bad.csv:2: pose 9 is none of the study, which has 3"));
}

}  // namespace
}  // namespace sonde::test
