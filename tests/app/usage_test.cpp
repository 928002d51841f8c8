// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/app_test.hpp"

namespace sonde::test {
namespace {

using testing::HasSubstr;
using Usage = AppTest;

TEST_F(Usage, help_and_version) {
  for (const char* arguments : {"--help", "info --help", "query --help", "replay -h",
                                "trade --help", "compare --help", "merge --help"}) {
    const Outcome run = sonde(arguments);
    EXPECT_EQ(run.exit_code, 0) << arguments;
    EXPECT_THAT(run.out, HasSubstr("Usage: sonde"));
    EXPECT_EQ(run.err, "");
  }
  const Outcome version = expect_done("--version");
  EXPECT_THAT(version.out, testing::MatchesRegex("sonde [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST_F(Usage, wrong_usage_exits_2_with_a_hint) {
  expect_refused("", 2, "Try 'sonde --help'");
  expect_refused("frobnicate", 2,
                 "unknown command frobnicate: the commands are info, query, replay");
  expect_refused("info", 2, "Try 'sonde info --help'");
  expect_refused("query boxes.sonde.json", 2, "--poses is required");
  expect_refused("query --poses poses.csv", 2, "give a SCENE, or --probe and --fixed");
  expect_refused("query --poses poses.csv --probe small.off", 2, "--fixed");
  expect_refused("query boxes.sonde.json --poses poses.csv " + loose, 2, "excludes");
  expect_refused("replay", 2, "SCENE is required");
  const std::string query = "query boxes.sonde.json --poses poses.csv ";
  for (const char* wrong :
       {"--frob", "--method pdx", "--mode fast", "--budget-us -1", "--budget-us nan",
        "--budget-us 1,5", "--budget-steps 1.5", "--budget-steps -1", "--seed x", "--seed -1",
        "--seed 99999999999999999999999", "--threads -2", "--threads 100000", "--probe-model maybe",
        "--fixed-model", "--unit mm", "extra"})
    expect_refused(query + wrong, 2, "Try 'sonde query --help'");
  for (const char* wrong : {"--unit mile", "--probe-scale 0", "--fixed-scale inf"})
    expect_refused("query --poses poses.csv " + loose + wrong, 2, "Try 'sonde query --help'");
  for (const char* wrong : {"--k 0", "--max-force nan", "--coupling hard", "--rate-hz 1e9"})
    expect_refused(std::string("replay boxes.sonde.json ") + wrong, 2, "Try 'sonde replay --help'");
}

TEST_F(Usage, an_output_that_is_an_input_is_refused) {
  for (const char* out : {"poses.csv", "./poses.csv", "boxes.sonde.json", "small.off"})
    expect_refused(std::string("query boxes.sonde.json --poses poses.csv --out ") + out, 2,
                   "is one of the inputs");
  expect_refused("replay boxes.sonde.json --out path.csv", 2, "is one of the inputs");
  expect_refused("info small.off --out small.off", 2, "is one of the inputs");
}

TEST_F(Usage, an_output_that_cannot_be_written_is_bad_input) {
  const std::string query = "query boxes.sonde.json --poses poses.csv --out ";
  expect_refused(query + "none/r.csv", 3, "none/r.csv: cannot be written");
  expect_refused(query + ".", 3, "cannot be written");
  expect_refused(query + "/dev/full", 3, "No space left");
  EXPECT_EQ(sonde("query boxes.sonde.json --poses poses.csv >/dev/full").exit_code, 3);
}

TEST_F(Usage, bad_input_exits_3_with_file_and_line) {
  const std::string query = "query boxes.sonde.json --out r.csv --poses ";
  expect_refused(query + "none.csv", 3, "none.csv: ");
  folder.write("bad.csv", "px,py,pz,qw,qx,qy,qz\n0,0,0,1,0,0,0\n0,0,0,1,0,0,x\n");
  expect_refused(query + "bad.csv", 3, "bad.csv:3: qz");
  folder.write("bad.sonde.json", "{\n\"probes\": 1}");
  expect_refused("query bad.sonde.json --poses poses.csv", 3, "bad.sonde.json:2: unknown key");
  expect_refused("replay bad.sonde.json", 3, "bad.sonde.json:2: unknown key");
  expect_refused("replay none.sonde.json", 3, "none.sonde.json: ");
  expect_refused("replay boxes.sonde.json --trajectory poses.csv", 3, "poses.csv:1: ");
  folder.write("bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 zero\n3 0 1 2\n");
  expect_refused("query --probe bad.off --fixed large.off --poses poses.csv", 3, "bad.off:5");
  folder.write("open.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  expect_refused("query --probe open.off --probe-model solid --fixed large.off --poses poses.csv",
                 3, "open.off: ");
}

TEST_F(Usage, paths_of_a_scene_lead_anywhere_unless_they_are_kept_in_a_folder) {
  std::filesystem::create_directory(folder / "scenes");
  folder.write(
      "scenes/up.sonde.json",
      "{\n\"probe\": {\"mesh\": \"../small.off\"},\n\"fixed\": {\"mesh\": \"../large.off\"}}");
  const std::string query = "query scenes/up.sonde.json --poses poses.csv";
  EXPECT_EQ(sonde(query).exit_code, 0) << "as bundled scenes do";
  expect_done(query + " --paths-within .");
  const std::string reason = "scenes/up.sonde.json:2: \"mesh\" leads out of the folder scenes";
  expect_refused(query + " --paths-within scenes", 3, reason);
  expect_refused("calibrate scenes/up.sonde.json --paths-within scenes", 3, reason);
  expect_refused(query + " --paths-within none", 2, "none");
  expect_done("replay scenes/up.sonde.json --trajectory path.csv --record up.sonderec --quiet");
  expect_done("replay up.sonderec --paths-within . --quiet");
  expect_refused("replay up.sonderec --paths-within scenes", 3,
                 "up.sonderec: its scene names small.off, out of the folder scenes");
  expect_done("info up.sonderec --paths-within .");
  expect_refused("info up.sonderec --paths-within scenes", 3, "out of the folder scenes");
}

TEST_F(Usage, a_mesh_that_is_missing_is_told_with_the_scenes_line) {
  folder.write("gone.sonde.json",
               "{\n\"probe\": {\"mesh\": \"small.off\"},\n\"fixed\":\n{\"mesh\": \"gone.off\"}}");
  expect_refused("query gone.sonde.json --poses poses.csv", 3,
                 "gone.sonde.json:4: \"mesh\" names gone.off: no such file");
}

TEST_F(Usage, control_characters_in_a_name_are_written_out) {
  folder.write("\x1b[31mred\n.off", box_off(0.05));
  folder.write("\x1b[31mbad.off", "no mesh");
  const Outcome run = expect_done("info '\x1b[31mred\n.off'");
  EXPECT_THAT(run.out, testing::StartsWith("\\x1b[31mred\\x0a.off\n"));
  expect_refused("info '\x1b[31mbad.off'", 3, "sonde: \\x1b[31mbad.off:1: ");
  expect_refused("info '\x1b[31mnone.off'", 3, "sonde: \\x1b[31mnone.off: no such file");
  expect_refused("'\x1b[31m'", 2, "unknown command \\x1b[31m");
  expect_refused("info none.off '\x1b[31mnone.off'", 3,
                 "none.off: no such file\nsonde: \\x1b[31mnone.off: no such file");
}

}  // namespace
}  // namespace sonde::test
