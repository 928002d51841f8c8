// SPDX-License-Identifier: GPL-3.0-or-later
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "tests/app/study_test.hpp"

namespace sonde::test {
namespace {

using testing::HasSubstr;

class Tune : public StudyTest {
 protected:
  /// A device of which nothing is assumed, so that there is little to study.
  Tune() {
    std::string text = R"({"name": "Bench")";
    const std::pair<const char*, const char*> values[] = {
        {"max_force", "10"},       {"max_torque", "0.3"},
        {"max_stiffness", "3000"}, {"max_rotational_stiffness", "5"},
        {"max_damping", "10"},     {"max_rotational_damping", "0.01"},
        {"mass", "0.2"},           {"inertia", "2e-4"},
        {"damping", "1"},          {"rotational_damping", "1e-3"},
        {"friction", "0.1"},       {"rotational_friction", "1e-3"},
        {"resolution", "1e-6"},    {"rotational_resolution", "1e-5"},
        {"delay", "1e-3"}};
    for (const auto& [key, value] : values)
      text += std::string(", \"") + key + "\": {\"value\": " + value + ", \"source\": \"made up\"}";
    folder.write("bench.json", text + "}");
  }
  static constexpr const char* quick =
      "tune boxes.sonde.json --device bench.json --trajectory path.csv --ratio 1.5 ";
};

TEST_F(Tune, writes_a_map_and_a_coupling_that_a_scene_can_include) {
  const Outcome run = expect_done(std::string(quick) + "--out out --threads 2");
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(run.err, HasSubstr("left out: jammed contact: no such contact was found"));
  EXPECT_THAT(text_of(folder / "out/map.svg"), HasSubstr("<svg"));
  EXPECT_THAT(text_of(folder / "out/recommendation.json"), HasSubstr("\"limited_by\""));
  const Csv map(text_of(folder / "out/map.csv"));
  EXPECT_GT(map.rows.size(), 8u);
  folder.write("tuned.sonde.json",
               R"({"probe": {"mesh": "small.off"}, "fixed": {"mesh": "large.off"},
                   "trajectory": "path.csv", "coupling": "out/coupling.json"})");
  expect_done("replay tuned.sonde.json");
}

TEST_F(Tune, the_damped_coupling_has_its_own_gains_and_map) {
  expect_done(std::string(quick) + "--out out --coupling damped");
  EXPECT_THAT(text_of(folder / "out/map.svg"),
              testing::AllOf(HasSubstr("Damped object norm"), HasSubstr("damping b_t, N·s/m")));
  const std::string gains = text_of(folder / "out/coupling.json");
  EXPECT_THAT(gains, testing::AllOf(HasSubstr("\"mode\": \"damped\""), HasSubstr("\"k\""),
                                    HasSubstr("\"b_t\""), testing::Not(HasSubstr("\"k_t\"")),
                                    testing::Not(HasSubstr("\"b_r\""))));
  folder.write("tuned.sonde.json",
               R"({"probe": {"mesh": "small.off"}, "fixed": {"mesh": "large.off"},
                   "trajectory": "path.csv", "coupling": "out/coupling.json"})");
  const std::string damped = expect_done("replay tuned.sonde.json").out;
  EXPECT_NE(damped, expect_done("replay tuned.sonde.json --b-t 0").out);
}

TEST_F(Tune, says_a_first_result_that_gets_better_and_quiet_changes_no_file) {
  const Outcome run = expect_done(std::string(quick) + "--out out --threads 1");
  const auto place = [&](const char* words) { return run.err.find(words); };
  ASSERT_NE(place("parts: at most k "), std::string::npos) << run.err;
  EXPECT_LT(place("first look, in large steps: k "), place("parts: at most k "));
  EXPECT_NE(run.err.rfind("\nsonde: k "), std::string::npos) << run.err;
  // What is finished is not looked for again.
  const Outcome again = sonde(std::string(quick) + "--out out");
  EXPECT_THAT(again.err, testing::Not(HasSubstr("first look")));
  const Outcome quiet = sonde(std::string(quick) + "--out quiet --quiet");
  EXPECT_EQ(quiet.err, "");
  EXPECT_EQ(files("out"), files("quiet"));
}

TEST_F(Tune, finished_parts_are_kept_and_shards_make_the_same_files) {
  expect_done(std::string(quick) + "--out whole");
  for (const char* shard : {"2/2", "1/2"})
    expect_done(std::string(quick) + "--out shards --shard " + shard);
  for (const char* file : {"map.csv", "map.svg", "coupling.json", "recommendation.json"})
    EXPECT_EQ(text_of(folder / "shards" / file), text_of(folder / "whole" / file)) << file;
  // Another study does not go into the same folder.
  const std::string before = text_of(folder / "whole/map.csv");
  expect_refused(std::string(quick) + "--out whole --seed 2", 3, "other inputs or settings");
  EXPECT_EQ(text_of(folder / "whole/map.csv"), before);
}

TEST_F(Tune, a_damaged_part_is_named_and_nothing_is_joined) {
  expect_done(std::string(quick) + "--out whole --quiet");
  const auto part = std::filesystem::directory_iterator(folder / "whole/parts")->path();
  const std::string whole = text_of(part);
  const std::size_t columns = whole.find("\"columns\":");
  ASSERT_NE(columns, std::string::npos);
  for (const std::string& damaged :
       {std::string("{"), whole.substr(0, columns) + "\"columns\":[]}"}) {
    folder.write("whole/parts/" + part.filename().string(), damaged);
    expect_refused("merge whole --out joined", 3, part.stem().string());
    EXPECT_FALSE(std::filesystem::exists(folder / "joined")) << damaged;
  }
  folder.write("whole/parts/" + part.filename().string(), whole);
  expect_done("merge whole --out joined");
  EXPECT_EQ(text_of(folder / "joined/map.csv"), text_of(folder / "whole/map.csv"));
}

TEST_F(Tune, bad_input_is_refused_before_any_work) {
  const std::string scene = "tune boxes.sonde.json --out out ";
  // As `sonde-view` ends: a word that names no device is wrong usage, a file or a path that cannot
  // be used is bad input, with its own reason alone.
  expect_refused(scene + "--device sigma7", 2,
                 "nearest known one is \"sigma.7\"; known are: lambda.7");
  expect_refused(scene + "--device ''", 2, "known are: lambda.7");
  expect_refused(scene + "--device none.json", 3, "none.json: ");
  expect_refused(scene + "--device ./touch", 3, "a profile's file ends in \".json\"");
  expect_refused(scene, 2, "--device");
  for (const char* gain : {"0", "-5", "nan", "x", "inf", "1e12"}) {
    expect_refused(scene + "--device sigma.7 --from " + gain, 2, "between 1 and 100000");
    expect_refused(scene + "--device sigma.7 --to " + gain, 2, "between 1 and 100000");
  }
  expect_refused(scene + "--device sigma.7 --from 10 --to 10", 2, "--from must be below --to");
  expect_refused(scene + "--device sigma.7 --ratio 1", 2, "1.0001");
  expect_refused(scene + "--device sigma.7 --shard 3/2", 2, "I/N");
}

TEST_F(Tune, no_contact_on_the_trajectory_is_an_error) {
  folder.write("far.csv", "t,px,py,pz,qw,qx,qy,qz\n0,1,0,0,1,0,0,0\n1,1,0,0.1,1,0,0,0\n");
  expect_refused("tune boxes.sonde.json --device sigma.7 --out out --trajectory far.csv", 3,
                 "in contact at no pose of the trajectory");
  // Nor are contacts looked for elsewhere where the path was said but is empty.
  folder.write("empty.csv", "t,px,py,pz,qw,qx,qy,qz\n");
  expect_refused("tune boxes.sonde.json --device sigma.7 --out out --trajectory empty.csv", 3,
                 "holds no poses");
}

TEST_F(Tune, stiffness_beyond_all_reason_ends_in_an_honest_map) {
  const Outcome run = expect_done(std::string(quick) + "--out out --from 9e4 --to 1e5");
  const Csv map(text_of(folder / "out/map.csv"));
  ASSERT_FALSE(map.rows.empty());
  for (std::size_t i = 0; i < map.rows.size(); ++i) {
    EXPECT_NE(map.text(i, "class"), "stable");
    EXPECT_NE(map.text(i, "class"), "passive");
  }
  // Nothing of it can be recommended.
  EXPECT_FALSE(std::filesystem::exists(folder / "out/coupling.json"));
}

TEST_F(Tune, interrupted_it_keeps_what_is_finished_and_goes_on_from_there) {
  const std::string fine =
      "tune boxes.sonde.json --device bench.json --trajectory path.csv --ratio 1.01 --threads 1 ";
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    if (::chdir(folder.path().c_str()) != 0) ::_exit(99);
    ::execl(SONDE_PROGRAM, SONDE_PROGRAM, "tune", "boxes.sonde.json", "--device", "bench.json",
            "--trajectory", "path.csv", "--ratio", "1.01", "--threads", "1", "--out", "out",
            "--quiet", nullptr);
    ::_exit(99);
  }
  const auto parts = [&] {
    std::error_code none;
    return std::distance(std::filesystem::directory_iterator(folder / "out/parts", none), {});
  };
  int status = 0;
  while (parts() == 0 && ::waitpid(child, &status, WNOHANG) == 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  ::kill(child, SIGINT);
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_GE(parts(), 1);
  EXPECT_FALSE(std::filesystem::exists(folder / "out/map.csv"));
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "out")) {
    EXPECT_FALSE(entry.path().filename().string().starts_with(".")) << entry.path();
  }
  expect_done(fine + "--out out");
  expect_done(fine + "--out whole");
  EXPECT_EQ(text_of(folder / "out/map.csv"), text_of(folder / "whole/map.csv"));
}

// As the manual shows it; the second shard is killed on its way and started again with the others.
TEST_F(Tune, under_gnu_parallel_with_a_shard_killed_and_started_again) {
  const std::vector<std::string> second{"tune",         "boxes.sonde.json",
                                        "--device",     "bench.json",
                                        "--trajectory", "path.csv",
                                        "--ratio",      "1.01",
                                        "--out",        "part2",
                                        "--shard",      "2/3",
                                        "--threads",    "1",
                                        "--quiet"};
  EXPECT_EQ(signal_once_begun(start(second), "part2", SIGKILL), -1);
  const std::string study =
      "tune boxes.sonde.json --device bench.json --trajectory path.csv --ratio 1.01";
  ASSERT_EQ(in_parallel(study + " --threads 1", 3), 0);
  expect_done("merge part1 part2 part3 --out joined");
  expect_done(study + " --out whole");
  EXPECT_EQ(files("joined"), files("whole"));
}

}  // namespace
}  // namespace sonde::test
