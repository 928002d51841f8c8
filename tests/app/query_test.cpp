// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/app/app_test.hpp"

namespace sonde::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr const char* query_header =
    "index,status,depth,sigma,px,py,pz,qw,qx,qy,qz,lower_bound,contacts,residual,iterations,time_"
    "us";

class Query : public AppTest {
 protected:
  /// The result of a run that has to succeed.
  Csv query(const std::string& arguments) const {
    return Csv(expect_done("query " + arguments).out);
  }
  const std::string scene = "boxes.sonde.json --poses poses.csv ";
};

TEST_F(Query, columns_statuses_and_numbers) {
  const Csv csv = query(scene);
  EXPECT_EQ(csv.header, query_header);
  ASSERT_EQ(csv.rows.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_EQ(csv.rows[i].size(), 16u);
    EXPECT_EQ(csv.text(i, "index"), std::to_string(i));
    EXPECT_GT(csv.number(i, "time_us"), 0);
  }
  EXPECT_EQ(csv.text(0, "status"), "penetrating");
  EXPECT_NEAR(csv.number(0, "depth"), 0.01, 2e-5);
  EXPECT_NEAR(csv.number(0, "px"), 0.15, 2e-5);
  const double depth = csv.number(0, "depth");
  EXPECT_NEAR(csv.number(0, "sigma"), depth * depth, 1e-15);
  EXPECT_LE(csv.number(0, "lower_bound"), depth);
  EXPECT_GE(csv.number(0, "contacts"), 1);
  EXPECT_LT(csv.number(0, "residual"), 1e-3);
  EXPECT_EQ(csv.text(1, "status"), "separated");
  EXPECT_EQ(csv.text(1, "depth"), "0");
  EXPECT_EQ(csv.text(1, "lower_bound"), "");
  EXPECT_EQ(csv.text(1, "px"), "0.29999999999999999") << "as given, 17 digits";
}

TEST_F(Query, out_is_what_stdout_would_be) {
  const Outcome run = expect_done("query --out r.csv " + scene);
  EXPECT_EQ(run.out, "");
  const Csv file(text_of(folder / "r.csv"));
  EXPECT_EQ(file.without({"time_us"}), query("--out - " + scene).without({"time_us"}));
}

// Reference: the same poses in another file, in another order.
TEST_F(Query, the_answer_to_a_pose_does_not_depend_on_its_row) {
  const std::string first = "0.12,0.03,0.01,0.8,0.6,0,0\n",
                    second = "0.02,-0.05,0.04,0.5,0.5,-0.5,0.5\n",
                    header = "px,py,pz,qw,qx,qy,qz\n";
  folder.write("ab.csv", header + first + second);
  folder.write("bba.csv", header + second + second + first);
  const Csv ab = query("boxes.sonde.json --budget-steps 40 --poses ab.csv"),
            bba = query("boxes.sonde.json --budget-steps 40 --poses bba.csv");
  for (const char* column : {"status", "depth", "px", "py", "pz", "qw", "qx", "qy", "qz"}) {
    EXPECT_EQ(ab.text(0, column), bba.text(2, column));
    EXPECT_EQ(ab.text(1, column), bba.text(0, column));
    EXPECT_EQ(ab.text(1, column), bba.text(1, column));
  }
}

TEST_F(Query, quiet_and_a_pipe_leave_stderr_empty) {
  EXPECT_EQ(sonde("query --quiet " + scene).err, "");
  EXPECT_THAT(sonde("query " + scene).err, testing::Not(HasSubstr("searching"))) << "no terminal";
}

TEST_F(Query, same_bits_at_any_thread_count) {
  const auto one = query("--threads 1 " + scene).without({"time_us"});
  EXPECT_EQ(query("--threads 2 " + scene).without({"time_us"}), one);
  EXPECT_EQ(query("--threads 7 " + scene).without({"time_us"}), one);
  EXPECT_EQ(query(scene).without({"time_us"}), one);
}

TEST_F(Query, loose_meshes_and_a_scene_give_the_same) {
  EXPECT_EQ(query("--poses poses.csv " + loose).without({"time_us"}),
            query(scene).without({"time_us"}));
}

TEST_F(Query, the_poses_of_a_scene_are_not_used_but_its_scales_and_unit_are) {
  const auto expected = query(scene).without({"time_us"});
  folder.write("moved.sonde.json", R"({"unit": "cm",
      "probe": {"mesh": "small.off", "scale": 100, "pose": [7, 0, 0, 0, 1, 0, 0]},
      "fixed": {"mesh": "large.off", "scale": 100, "pose": [0, 3, 0, 0.6, 0.8, 0, 0]}})");
  EXPECT_EQ(query("moved.sonde.json --poses poses.csv").without({"time_us"}), expected);
  EXPECT_EQ(query("--poses poses.csv --unit cm --probe-scale 100 --fixed-scale 100 " + loose)
                .without({"time_us"}),
            expected);
}

TEST_F(Query, json_holds_the_same_numbers) {
  const Outcome run = expect_done("query --json " + scene);
  const json result = json::parse(run.out);
  EXPECT_EQ(result.at("units").at("depth"), "m");
  const Csv csv = query(scene);
  ASSERT_EQ(result.at("results").size(), csv.rows.size());
  for (std::size_t i = 0; i < csv.rows.size(); ++i) {
    const json& row = result.at("results")[i];
    EXPECT_EQ(row.size(), 16u);
    EXPECT_EQ(row.at("status"), csv.text(i, "status"));
    for (const char* name : {"index", "depth", "sigma", "px", "qw", "contacts", "iterations"})
      EXPECT_EQ(row.at(name).get<double>(), csv.number(i, name)) << name;
  }
  EXPECT_TRUE(result.at("results")[1].at("lower_bound").is_null());
}

TEST_F(Query, coherent_follows) {
  const Csv csv = query("--mode coherent " + scene);
  EXPECT_EQ(csv.header, query_header);
  ASSERT_EQ(csv.rows.size(), 3u);
  EXPECT_NEAR(csv.number(0, "depth"), 0.01, 2e-5);
  EXPECT_EQ(csv.without({"time_us"}), query("--mode coherent " + scene).without({"time_us"}));
}

TEST_F(Query, translation_only_turns_nothing) {
  const Csv csv = query("--method pdt " + scene);
  const Csv all = query(scene);
  for (std::size_t i = 0; i < 3; ++i) {
    const double slack = 1e-4 * all.number(i, "depth");  // the clearance a returned pose may have
    EXPECT_GE(csv.number(i, "depth"), all.number(i, "depth") - slack);
  }
  EXPECT_NEAR(csv.number(2, "qw"), 0.8, 1e-12);
  EXPECT_NEAR(csv.number(2, "qx"), 0.6, 1e-12);
}

TEST_F(Query, budgets_are_taken) {
  const Csv csv = query("--budget-steps 3 " + scene);
  EXPECT_EQ(csv.rows.size(), 3u);
  EXPECT_EQ(csv.without({"time_us"}),
            query("--threads 2 --budget-steps 3 " + scene).without({"time_us"}));
  EXPECT_EQ(query("--budget-us 1000000 " + scene).rows.size(), 3u);
}

TEST_F(Query, the_seed_is_any_64_bit_number) {
  EXPECT_EQ(query("--seed 18446744073709551615 " + scene).rows.size(), 3u);
}

TEST_F(Query, no_poses_give_a_header) {
  folder.write("none.csv", "px,py,pz,qw,qx,qy,qz\n");
  const Outcome run = expect_done("query boxes.sonde.json --poses none.csv");
  EXPECT_EQ(run.out, std::string(query_header) + "\n");
  EXPECT_TRUE(json::parse(sonde("query boxes.sonde.json --poses none.csv --json").out)
                  .at("results")
                  .empty());
}

TEST_F(Query, meshes_that_never_touch_are_separated) {
  folder.write("far.csv", "px,py,pz,qw,qx,qy,qz\n9,0,0,1,0,0,0\n1e6,0,0,1,0,0,0\n");
  for (const char* mode : {"static", "coherent"}) {
    const Csv csv = query(std::string("boxes.sonde.json --poses far.csv --mode ") + mode);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(csv.text(i, "status"), "separated");
      EXPECT_EQ(csv.text(i, "sigma"), "0");
    }
  }
}

TEST_F(Query, one_triangle_against_one_triangle) {
  folder.write("flat.off", "OFF\n3 1 0\n0 0 0\n0.1 0 0\n0 0.1 0\n3 0 1 2\n");
  folder.write("turn.csv",
               "px,py,pz,qw,qx,qy,qz\n"
               "0.02,0.02,-0.01,0.70710678118654757,0.70710678118654757,0,0\n");
  const Csv csv = query("--probe flat.off --fixed flat.off --poses turn.csv");
  ASSERT_EQ(csv.rows.size(), 1u);
  EXPECT_EQ(csv.text(0, "status"), "penetrating");
  EXPECT_GT(csv.number(0, "depth"), 0);
  EXPECT_LT(csv.number(0, "depth"), 0.011);
  EXPECT_GT(csv.number(0, "lower_bound"), 1e-3) << "the one goes through the other";
  EXPECT_LE(csv.number(0, "lower_bound"), csv.number(0, "depth"));
}

TEST_F(Query, a_mesh_against_itself_at_the_same_pose_gets_an_answer) {
  folder.write("same.csv", "px,py,pz,qw,qx,qy,qz\n0,0,0,1,0,0,0\n");
  const Csv csv = query("--probe small.off --fixed small.off --poses same.csv");
  EXPECT_EQ(csv.text(0, "status"), "penetrating");
  EXPECT_GT(csv.number(0, "depth"), 0.03);
  EXPECT_LT(csv.number(0, "depth"), 0.1001) << "one edge's length always does";
}

TEST_F(Query, an_inside_out_mesh_is_turned_and_reported) {
  folder.write("turned.off",
               "OFF\n4 4 0\n0 0 0\n.1 0 0\n0 .1 0\n0 0 .1\n"
               "3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n");
  const std::string arguments = "query --probe turned.off --fixed large.off --poses poses.csv";
  EXPECT_THAT(sonde(arguments).err, HasSubstr("inside out"));
  EXPECT_THAT(sonde(arguments + " --quiet").err, testing::Not(HasSubstr("inside out")));
}

// Reference: the depth of the first pose by hand, 0.01.
TEST_F(Query, one_knob_gives_two_columns_more_and_a_limited_time_a_third) {
  for (const char* knob : {"--time 5ms ", "--accuracy 5% ", "--claim ", "--sure 99% "}) {
    const Csv csv = query(knob + scene);
    EXPECT_TRUE(csv.header.starts_with(std::string(query_header) + ",within,claim")) << knob;
    // A search to an accuracy has a limit where a measured time reaches it.
    const std::string_view flag(knob);
    if (flag.starts_with("--time")) {
      EXPECT_TRUE(csv.header.ends_with(",late")) << knob;
    } else if (!flag.starts_with("--accuracy")) {
      EXPECT_TRUE(csv.header.ends_with(",claim")) << knob << "has no limit";
    }
    EXPECT_NEAR(csv.number(0, "depth"), 0.01, 5e-4);
    EXPECT_EQ(csv.text(1, "within"), "0") << "a free probe is free";
    EXPECT_EQ(csv.text(1, "claim"), "certified");
  }
  EXPECT_EQ(query("--time 5ms " + scene).text(0, "lower_bound"), "") << "only where asked for";
  const Csv bounded = query("--time 50ms --bound " + scene);
  EXPECT_GT(bounded.number(0, "lower_bound"), 0);
  EXPECT_LE(bounded.number(0, "lower_bound"), bounded.number(0, "depth"));
  EXPECT_EQ(query("--no-bound " + scene).text(0, "lower_bound"), "");
  const double part = query(scene).number(0, "lower_bound");
  EXPECT_GT(part, 0);
  EXPECT_LE(part, query("--bound " + scene).number(0, "lower_bound")) << "all that it may become";
}

// Reference: the depth of the first pose by hand, 0.01, which no turn makes less.
TEST_F(Query, phases_are_columns_of_their_own_and_change_no_answer) {
  const Csv plain = query(scene), phases = query("--phases " + scene);
  EXPECT_EQ(phases.header, std::string(query_header) +
                               ",pdt,converged,limited"
                               ",sketch_us,look_us,solve_us,sweep_us,verify_us,bound_us,couple_us");
  for (const char* column : {"depth", "px", "qx", "lower_bound", "iterations"})
    EXPECT_EQ(phases.text(0, column), plain.text(0, column)) << column;
  EXPECT_NEAR(phases.number(0, "pdt"), 0.01, 5e-4);
  EXPECT_EQ(phases.text(0, "converged"), "1");
  for (const char* column : {"sketch_us", "look_us", "solve_us", "verify_us", "bound_us"})
    EXPECT_GT(phases.number(0, column), 0) << column;
  EXPECT_EQ(phases.text(1, "limited"), "0") << "a free probe is not searched for";
}

// Reference: the clock: no search takes a nanosecond, and none of these takes ten seconds.
TEST_F(Query, a_time_that_was_not_had_is_said) {
  const Outcome hasty = sonde("query " + scene + "--time 0.001us");
  EXPECT_EQ(Csv(hasty.out).text(0, "late"), "1");
  EXPECT_THAT(hasty.err, HasSubstr("poses took over 1.1 times the time for each"));
  EXPECT_EQ(query("--time 10s " + scene).text(0, "late"), "0");
  EXPECT_FALSE(query("--claim " + scene).header.ends_with("late")) << "there is no limit";
}

// Reference: of the same errors, fewer keep to a narrower claim.
TEST_F(Query, the_surer_the_wider_the_claim) {
  double before = 0;
  for (const char* sure : {"50%", "0.9", "99%"}) {
    const Csv csv = query("--time 50ms --sure " + std::string(sure) + " " + scene);
    EXPECT_EQ(csv.text(0, "claim"), "expected");
    EXPECT_GE(csv.number(0, "within"), before) << sure;
    before = csv.number(0, "within");
  }
  for (const char* sure : {"0", "100%", "often"}) {
    const Outcome refused = sonde("query " + scene + "--sure " + sure);
    EXPECT_EQ(refused.exit_code, 2) << sure;
    EXPECT_THAT(refused.err, HasSubstr("--sure")) << sure;
  }
}

TEST_F(Query, a_calibration_of_its_own_is_measured_and_used) {
  expect_done("calibrate boxes.sonde.json --count 2 --out c.json");
  const Csv csv = query("--accuracy 20% --calibration c.json " + scene);
  EXPECT_LE(csv.number(0, "within"), 0.2);
}

TEST_F(Query, a_calibration_is_added_to_another) {
  const auto series = [&](const std::string& flags) {
    const Outcome run = expect_done("calibrate " + flags);
    std::set<std::string> names;
    const json made = json::parse(run.out);
    for (const auto& one : made.at("series"))
      names.insert(one.at("pair").get<std::string>() + " " + one.at("answers").get<std::string>());
    return names;
  };
  std::filesystem::copy_file(folder / "boxes.sonde.json", folder / "others.sonde.json");
  sonde("calibrate others.sonde.json --count 1 --out others.json");
  const std::set<std::string> both{"boxes search", "boxes tick", "others search", "others tick"};
  EXPECT_EQ(series("boxes.sonde.json --count 1 --add others.json"), both);
  EXPECT_EQ(series("boxes.sonde.json others.sonde.json --count 1 --add others.json"), both);
  EXPECT_EQ(series("boxes.sonde.json --count 0"), std::set<std::string>{"boxes tick"});
  folder.write("still.sonde.json",
               R"({"probe": {"mesh": "small.off"}, "fixed": {"mesh": "large.off"}})");
  const Outcome nothing = sonde("calibrate still.sonde.json --count 0");
  EXPECT_EQ(nothing.exit_code, 3);
  EXPECT_THAT(nothing.err, HasSubstr("still.sonde.json: no path"));
}

TEST_F(Query, a_knob_that_is_no_good_is_refused) {
  const auto refused = [&](const std::string& flags, int exit_code, const std::string& why) {
    const Outcome run = sonde("query --out r.csv " + flags + " " + scene);
    EXPECT_EQ(run.exit_code, exit_code) << flags;
    EXPECT_THAT(run.err, HasSubstr(why));
    EXPECT_FALSE(std::filesystem::exists(folder / "r.csv"));
  };
  for (const char* time : {"0", "0ms", "-1ms", "nan", "inf", "soon"})
    refused(std::string("--time=") + time, 2, "--time: \"");
  for (const char* accuracy : {"0%", "1000%", "100%", "-1%", "nan"})
    refused(std::string("--accuracy=") + accuracy, 2, "--accuracy: \"");
  refused("--time ''", 2, "--time: \"\"");
  refused("--accuracy ''", 2, "--accuracy: \"\"");
  folder.write("old.json", R"({"calibration": 0, "series": []})");
  refused("--time 1ms --calibration old.json", 3, "old.json:1: a calibration of version 0");
  folder.write("cut.json", R"({"calibration": 1, "series": [{"pair": "a")");
  refused("--time 1ms --calibration cut.json", 3, "cut.json:1:");
  refused("--time 1ms --calibration none.json", 3, "none.json");
  refused("--sure 0%", 2, "--sure: \"");
  refused("--time 1ms --accuracy 1%", 2, "the one follows from the other");
  refused("--time 1ms --budget-us 100", 2, "give no other");
}

TEST_F(Query, a_budget_of_steps_claims_only_what_is_certified) {
  const Csv csv(sonde("query " + loose + "--poses poses.csv --claim --budget-steps 5").out);
  ASSERT_EQ(csv.rows.size(), 3u);
  for (std::size_t row = 0; row < 3; ++row) EXPECT_NE(csv.text(row, "claim"), "expected") << row;
  const Csv tick(sonde("replay boxes.sonde.json --claim --budget-steps 5").out);
  EXPECT_EQ(tick.text(39, "claim"), "") << "a tick has no bound";
}

TEST_F(Query, a_calibration_that_is_not_there_is_told_of_even_unused) {
  expect_refused("query " + loose + "--poses poses.csv --calibration none.json", 3, "none.json");
}

}  // namespace
}  // namespace sonde::test
