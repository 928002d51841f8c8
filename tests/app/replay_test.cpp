// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "tests/app/app_test.hpp"

namespace sonde::test {
namespace {

using nlohmann::json;

constexpr const char* replay_header =
    "t,px,py,pz,qw,qx,qy,qz,sx,sy,sz,sqw,sqx,sqy,sqz,fx,fy,fz,tx,ty,tz,depth,sigma,contacts,"
    "iterations,tick_us,saturated,late,jumped,converged,released";

class Replay : public AppTest {
 protected:
  Csv replay(const std::string& arguments) const {
    return Csv(expect_done("replay " + arguments).out);
  }
  static constexpr std::size_t last = 39;  // the end of the path, 19 mm deep
  static constexpr double deepest = 0.019;
};

// Reference: boxes that face each other come nearer by 1 mm a tick.
TEST_F(Replay, clearance_falls_through_zero_to_less_than_it) {
  const Csv csv(expect_done("replay boxes.sonde.json --clearance").out);
  EXPECT_THAT(csv.header, testing::EndsWith(",clearance"));
  for (std::size_t i = 0; i < csv.rows.size(); ++i) {
    const double gap = csv.number(i, "px") - 0.15;
    EXPECT_NEAR(csv.number(i, "clearance"), gap, gap > 0 ? 1e-12 : 1e-3 * std::abs(gap) + 1e-7)
        << i;
  }
}

// A probe between two walls: towards one, into it, and to the other.
TEST_F(Replay, clearance_names_the_part_that_is_nearest_or_that_holds_the_probe) {
  folder.write("walls.sonde.json", R"({"probe": {"mesh": "small.off"}, "fixed": [
    {"name": "left", "mesh": "large.off", "pose": [-0.3, 0, 0, 1, 0, 0, 0]},
    {"name": "right", "mesh": "large.off", "pose": [0.3, 0, 0, 1, 0, 0, 0]}]})");
  folder.write("walk.csv",
               "t,px,py,pz,qw,qx,qy,qz\n0,0.01,0,0,1,0,0,0\n0.1,0.1,0,0,1,0,0,0\n"
               "0.2,0.16,0,0,1,0,0,0\n0.3,-0.1,0,0,1,0,0,0\n");
  const Csv csv = replay("walls.sonde.json --trajectory walk.csv --clearance");
  EXPECT_THAT(csv.header, testing::EndsWith(",part,clearance"));
  EXPECT_LT(csv.number(2, "clearance"), 0);
  const char* expected[] = {"right", "right", "right", "left"};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(csv.text(i, "part"), expected[i]) << i;
}

TEST_F(Replay, one_row_for_each_row_of_the_path) {
  const Csv csv = replay("boxes.sonde.json");
  EXPECT_EQ(csv.header, replay_header);
  ASSERT_EQ(csv.rows.size(), 40u);
  for (const auto& row : csv.rows) EXPECT_EQ(row.size(), 31u);
  EXPECT_EQ(csv.number(7, "t"), 0.007);
  EXPECT_EQ(csv.number(7, "px"), 0.163);
  EXPECT_EQ(csv.text(7, "sx"), csv.text(7, "px")) << "free: the separated pose is the device's";
  EXPECT_EQ(csv.text(7, "fx"), "0");
  EXPECT_EQ(csv.text(7, "depth"), "0");
  EXPECT_NEAR(csv.number(last, "depth"), deepest, 2e-5);
  EXPECT_NEAR(csv.number(last, "sx"), 0.15, 2e-5);
  EXPECT_NEAR(csv.number(last, "fx"), 500 * deepest, 0.02) << "k of 500 N/m, outwards";
  EXPECT_EQ(csv.text(last, "saturated"), "0");
  EXPECT_EQ(csv.text(last, "jumped"), "0");
  EXPECT_EQ(csv.text(last, "converged"), "1");
}

TEST_F(Replay, the_same_bits_every_time_but_for_the_times) {
  const auto once = replay("boxes.sonde.json").without(time_columns);
  EXPECT_EQ(replay("boxes.sonde.json --threads 2").without(time_columns), once);
  const std::string steps = "boxes.sonde.json --budget-steps 2";
  EXPECT_EQ(replay(steps).without(time_columns), replay(steps).without(time_columns));
}

TEST_F(Replay, settings_of_the_scene_can_be_replaced) {
  EXPECT_NEAR(replay("boxes.sonde.json --k 100").number(last, "fx"), 100 * deepest, 0.004);
  const Csv limited = replay("boxes.sonde.json --max-force 2");
  EXPECT_NEAR(limited.number(last, "fx"), 2, 1e-12);
  EXPECT_EQ(limited.text(last, "saturated"), "1");
  const Csv classic = replay("boxes.sonde.json --coupling classic --k-t 200");
  EXPECT_NEAR(classic.number(last, "fx"), 200 * deepest, 0.008);
}

TEST_F(Replay, the_classic_mode_damps_with_the_times_of_the_path) {
  const std::string arguments = "boxes.sonde.json --coupling classic --k-t 200 --b-t ";
  // The path goes 1 mm in each millisecond: 1 m/s.
  const double more =
      replay(arguments + "2").number(last, "fx") - replay(arguments + "0").number(last, "fx");
  EXPECT_NEAR(more, 2, 0.02);
}

TEST_F(Replay, late_is_told_by_the_rate) {
  const Csv csv = replay("boxes.sonde.json --rate-hz 10000");
  for (std::size_t i = 0; i < csv.rows.size(); ++i)
    EXPECT_EQ(csv.text(i, "late"), csv.number(i, "tick_us") > 100 ? "1" : "0");
}

TEST_F(Replay, a_path_given_comes_before_that_of_the_scene) {
  folder.write("short.csv", "t,px,py,pz,qw,qx,qy,qz\n0,9,0,0,1,0,0,0\n");
  EXPECT_EQ(replay("boxes.sonde.json --trajectory short.csv").rows.size(), 1u);
  folder.write("none.csv", "t,px,py,pz,qw,qx,qy,qz\n");
  EXPECT_TRUE(replay("boxes.sonde.json --trajectory none.csv").rows.empty());
  folder.write("bare.sonde.json",
               R"({"probe": {"mesh": "small.off"}, "fixed": {"mesh": "large.off"}})");
  expect_refused("replay bare.sonde.json", 2, "--trajectory");
  EXPECT_EQ(replay("bare.sonde.json --trajectory path.csv").rows.size(), 40u);
}

TEST_F(Replay, static_mode_searches_every_row) {
  folder.write("in.csv", "t,px,py,pz,qw,qx,qy,qz\n0,0.14,0,0,1,0,0,0\n1,0.145,0,0,1,0,0,0\n");
  const std::string arguments = "boxes.sonde.json --trajectory in.csv --mode static ";
  const Csv csv = replay(arguments);
  EXPECT_NEAR(csv.number(0, "depth"), 0.01, 2e-5);
  EXPECT_NEAR(csv.number(1, "depth"), 0.005, 2e-5);
  EXPECT_NEAR(csv.number(1, "fx"), 2.5, 0.02);
  EXPECT_EQ(replay(arguments + "--threads 1").without(time_columns), csv.without(time_columns));
}

TEST_F(Replay, phases_are_columns_of_their_own_and_change_no_answer) {
  const Csv plain = replay("boxes.sonde.json"), phases = replay("--phases boxes.sonde.json");
  EXPECT_EQ(phases.header, std::string(replay_header) +
                               ",pdt,limited"
                               ",sketch_us,look_us,solve_us,sweep_us,verify_us,bound_us,couple_us");
  EXPECT_EQ(phases.text(last, "depth"), plain.text(last, "depth"));
  EXPECT_EQ(phases.text(last, "fx"), plain.text(last, "fx"));
  EXPECT_EQ(phases.text(last, "pdt"), "") << "a tick looks for no translation";
  EXPECT_EQ(phases.text(last, "limited"), "0");
  EXPECT_GT(phases.number(last, "look_us"), 0);
  EXPECT_GT(phases.number(last, "solve_us"), 0);
  EXPECT_GT(phases.number(last, "couple_us"), 0);
  EXPECT_EQ(phases.number(last, "sketch_us"), 0) << "a tick has no sketches";
  double sum = 0;
  for (const char* column : {"look_us", "solve_us", "sweep_us", "verify_us", "couple_us"})
    sum += phases.number(last, column);
  EXPECT_LE(sum, phases.number(last, "tick_us") + 0.01) << "no time counts twice";
}

TEST_F(Replay, the_scenes_wanted_accuracy_acts_unless_a_budget_is_given) {
  const std::string bodies = R"({"probe": {"mesh": "small.off"}, "fixed": {"mesh": "large.off"},
                     "trajectory": "path.csv", "servo": )";
  folder.write("wanted.sonde.json", bodies + R"({"accuracy": 0.05}})");
  folder.write("counted.sonde.json", bodies + R"({"accuracy": 0.05, "budget_steps": 9}})");
  const Csv wanted = replay("wanted.sonde.json");
  EXPECT_EQ(wanted.header, std::string(replay_header) + ",within,claim");
  EXPECT_EQ(wanted.text(last, "claim"), "expected");
  EXPECT_LE(wanted.number(last, "within"), 0.05 * (1 + 1e-9));
  EXPECT_EQ(replay("wanted.sonde.json --budget-us 1000").header, replay_header);
  EXPECT_EQ(replay("wanted.sonde.json --budget-steps 9").header, replay_header);
  EXPECT_EQ(replay("counted.sonde.json").header, replay_header);
}

TEST_F(Replay,
       an_accuracy_that_no_time_reaches_is_told_of_and_ticks_without_a_limit_claim_nothing) {
  const std::string command = "replay boxes.sonde.json --method pdt --accuracy 0.1%";
  const Outcome run = expect_done(command);
  EXPECT_THAT(run.err, testing::HasSubstr("no measured time reaches an accuracy of 0.1%"));
  EXPECT_EQ(expect_done(command + " --quiet").err, "");
  for (const std::string& out : {run.out, expect_done("replay boxes.sonde.json --claim").out}) {
    const Csv csv(out);
    EXPECT_EQ(csv.header, std::string(replay_header) + ",within,claim");
    EXPECT_EQ(csv.text(0, "claim"), "certified") << "free";
    EXPECT_EQ(csv.text(last, "claim"), "") << "what other ticks are compared with";
    EXPECT_EQ(csv.text(last, "within"), "");
  }
}

TEST_F(Replay, json_has_units) {
  const json result = json::parse(sonde("replay --json boxes.sonde.json").out);
  EXPECT_EQ(result.at("units").at("fx"), "N");
  EXPECT_EQ(result.at("results").size(), 40u);
  EXPECT_EQ(result.at("results")[3].size(), 31u);
}

TEST_F(Replay, out_is_written_whole) {
  expect_done("replay boxes.sonde.json --out r.csv");
  EXPECT_EQ(Csv(text_of(folder / "r.csv")).without(time_columns),
            replay("boxes.sonde.json").without(time_columns));
}

}  // namespace
}  // namespace sonde::test
