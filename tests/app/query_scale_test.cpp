// SPDX-License-Identifier: GPL-3.0-or-later
// What a query answers beside depths, and how it is split and joined.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/app/app_test.hpp"

namespace sonde::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class QueryScale : public AppTest {
 protected:
  QueryScale() {
    std::string many = "px,py,pz,qw,qx,qy,qz\n";
    for (int i = 0; i < 41; ++i)
      many += std::to_string(0.1 + 0.003 * i) + ",0.01," + std::to_string(0.002 * i) +
              ",0.96,0,0.28,0\n";
    folder.write("many.csv", many);
  }
  Csv query(const std::string& arguments) const {
    return Csv(expect_done("query boxes.sonde.json " + arguments).out);
  }
  static std::vector<std::vector<std::string>> untimed(const std::string& text) {
    return Csv(text).without({"time_us"});
  }
};

// Reference: what a search says of the same poses.
TEST_F(QueryScale, touch_says_whether_and_no_more) {
  const Csv all = query("--poses many.csv"), touched = query("--poses many.csv --touch");
  EXPECT_EQ(touched.header, "index,status");
  ASSERT_EQ(touched.rows.size(), all.rows.size());
  int separated = 0;
  for (std::size_t i = 0; i < all.rows.size(); ++i) {
    EXPECT_EQ(touched.text(i, "status"), all.text(i, "status")) << i;
    separated += touched.text(i, "status") == "separated";
  }
  EXPECT_GT(separated, 5);
  EXPECT_LT(separated, 36);
}

// Reference: boxes that face each other, their halves 0.05 and 0.1.
TEST_F(QueryScale, clearance_is_the_gap_with_its_points) {
  folder.write("faces.csv",
               "px,py,pz,qw,qx,qy,qz\n0.18,0,0,1,0,0,0\n0.14,0,0,1,0,0,0\n0,-0.4,0,1,0,0,0\n");
  for (const std::string more : {"", " --touch", " --mode coherent"}) {
    const Csv csv = query("--poses faces.csv --clearance" + more);
    EXPECT_NEAR(csv.number(0, "clearance"), 0.03, 1e-15);
    EXPECT_NEAR(csv.number(0, "ax"), 0.13, 1e-15);
    EXPECT_NEAR(csv.number(0, "bx"), 0.1, 1e-15);
    EXPECT_EQ(csv.text(0, "ay"), csv.text(0, "by"));
    EXPECT_EQ(csv.text(0, "part"), "large.off");
    EXPECT_EQ(csv.text(1, "ax") + csv.text(1, "bz"), "");
    if (more == " --touch") {
      EXPECT_EQ(csv.text(1, "clearance") + csv.text(1, "part"), "") << "no depth without a search";
    } else {
      EXPECT_NEAR(csv.number(1, "clearance"), -0.01, 1e-6) << more;
      EXPECT_EQ(csv.text(1, "part"), "large.off");
    }
    if (more != " --mode coherent") {
      EXPECT_NEAR(csv.number(2, "clearance"), 0.25, 1e-15);
    }
  }
  EXPECT_THAT(query("--poses faces.csv --clearance --claim").header,
              HasSubstr("time_us,clearance,ax,ay,az,bx,by,bz,part,within,claim"));
}

// Reference: a face on a face, which is held by two opposite corners at least: the force of the
// contacts, Σ λ n, is along the separation, and their torque about the probe's middle is none.
TEST_F(QueryScale, contacts_are_rows_of_their_own) {
  folder.write("deep.csv", "px,py,pz,qw,qx,qy,qz\n0.3,0,0,1,0,0,0\n0.14,0.01,0.02,1,0,0,0\n");
  const Csv csv = query("--poses deep.csv --contacts c.csv");
  const Csv contacts(text_of(folder / "c.csv"));
  EXPECT_EQ(contacts.header, "index,x,y,z,nx,ny,nz,multiplier,part");
  ASSERT_GE(contacts.rows.size(), 2u);
  double sum = 0, about_y = 0, about_z = 0;
  for (std::size_t i = 0; i < contacts.rows.size(); ++i) {
    EXPECT_EQ(contacts.text(i, "index"), "1");
    EXPECT_NEAR(contacts.number(i, "x"), 0.1, 1e-9);
    EXPECT_NEAR(contacts.number(i, "nx"), 1, 1e-6);
    EXPECT_EQ(contacts.text(i, "part"), "large.off");
    const double force = contacts.number(i, "multiplier") * contacts.number(i, "nx");
    sum += force;
    about_y += force * (contacts.number(i, "z") - 0.02);
    about_z += force * (contacts.number(i, "y") - 0.01);
  }
  EXPECT_NEAR(sum, csv.number(1, "depth"), 1e-6);
  EXPECT_NEAR(about_y, 0, 1e-6 * sum);
  EXPECT_NEAR(about_z, 0, 1e-6 * sum);
}

TEST_F(QueryScale, contacts_name_the_part) {
  folder.write("parts.sonde.json", R"({"probe": {"mesh": "small.off"}, "fixed": [
    {"name": "floor, old", "mesh": "large.off"},
    {"name": "wall", "mesh": "large.off", "pose": [1, 0, 0, 1, 0, 0, 0]}]})");
  folder.write("both.csv", "px,py,pz,qw,qx,qy,qz\n0,0,0.14,1,0,0,0\n0.86,0,0,1,0,0,0\n");
  expect_done("query parts.sonde.json --poses both.csv --contacts c.csv --out r.csv");
  const std::string contacts = text_of(folder / "c.csv");
  EXPECT_THAT(contacts, HasSubstr(",\"floor, old\"\n"));
  EXPECT_THAT(contacts, HasSubstr(",wall\n"));
  for (const std::string& line : split(contacts, '\n')) {
    if (line.starts_with("0,")) {
      EXPECT_THAT(line, testing::EndsWith("old\""));
    }
    if (line.starts_with("1,")) {
      EXPECT_THAT(line, testing::EndsWith("wall"));
    }
  }
}

TEST_F(QueryScale, clearance_names_the_part_in_shares_too) {
  folder.write("parts.sonde.json", R"({"probe": {"mesh": "small.off"}, "fixed": [
    {"name": "floor, old", "mesh": "large.off"},
    {"name": "стена", "mesh": "large.off", "pose": [1, 0, 0, 1, 0, 0, 0]}]})");
  folder.write("both.csv", "px,py,pz,qw,qx,qy,qz\n0,0,0.3,1,0,0,0\n0.7,0,0,1,0,0,0\n");
  for (const std::string more : {"", " --touch"}) {
    const std::string all = "query parts.sonde.json --poses both.csv --clearance" + more;
    for (const std::string i : {"1", "2"}) expect_done(all + " --shard " + i + "/2 --out s" + i);
    expect_done("merge s1 s2 --out joined.csv");
    for (const std::string& text : {expect_done(all).out, text_of(folder / "joined.csv")}) {
      EXPECT_THAT(text, HasSubstr(",part\n"));
      EXPECT_THAT(text, HasSubstr(",\"floor, old\"\n"));
      EXPECT_THAT(text, HasSubstr(",стена\n"));
    }
    EXPECT_EQ(json::parse(expect_done(all + " --json").out).at("results")[1].at("part"), "стена");
  }
}

TEST_F(QueryScale, poses_come_from_standard_input_and_from_paths) {
  const auto all = query("--poses many.csv").without({"time_us"});
  EXPECT_EQ(
      Csv(expect_done("query boxes.sonde.json --poses - < many.csv").out).without({"time_us"}),
      all);
  const Csv path = query("--poses path.csv --touch");
  EXPECT_EQ(path.rows.size(), 40u);
  EXPECT_EQ(path.text(0, "status"), "separated");
  EXPECT_EQ(path.text(39, "status"), "penetrating");
  folder.write("odd.csv", "t,px\n1,2\n");
  expect_refused("query boxes.sonde.json --poses odd.csv", 3, "odd.csv:1: the header is");
}

// Reference: one run of all poses.
TEST_F(QueryScale, shares_are_joined_to_what_one_run_writes) {
  for (const std::string json : {"", " --json"}) {
    const std::string rest = json + " --poses many.csv --no-bound --clearance --quiet --contacts ";
    const std::string whole = "query boxes.sonde.json --out whole" + rest + "whole.contacts";
    expect_done(whole);
    for (const std::string i : {"1", "2", "3"})
      expect_done("query boxes.sonde.json --shard " + i + "/3 --out part" + i + rest + "contacts" +
                  i);
    expect_done("merge part3 part1 part2 --out joined");
    const std::string joined = text_of(folder / "joined"), all = text_of(folder / "whole");
    if (json.empty()) {
      EXPECT_EQ(Csv(joined).header, Csv(all).header);
      EXPECT_EQ(untimed(joined), untimed(all));
      expect_done("merge contacts1 contacts2 contacts3 --out joined.contacts");
      EXPECT_EQ(text_of(folder / "joined.contacts"), text_of(folder / "whole.contacts"));
    } else {
      const auto untimed_json = [](const std::string& text) {
        nlohmann::json whole = nlohmann::json::parse(text);
        for (auto& row : whole["results"]) row.erase("time_us");
        return whole;
      };
      EXPECT_EQ(untimed_json(joined), untimed_json(all));
      EXPECT_EQ(joined.substr(0, joined.find("results")), all.substr(0, all.find("results")));
    }
  }
  const Csv part(text_of(folder / "contacts2"));
  EXPECT_EQ(std::stoi(part.text(0, "index")) % 3, 1) << "the index in the whole file";
}

TEST_F(QueryScale, shares_that_do_not_belong_together_are_refused) {
  const std::string rest = " --poses many.csv --no-bound --quiet ";
  const auto share = [&](const std::string& name, const std::string& arguments) {
    expect_done("query boxes.sonde.json --out " + name + rest + arguments);
  };
  share("a", "--shard 1/2");
  share("b", "--shard 2/2");
  share("other", "--shard 2/2 --seed 9");
  share("third", "--shard 2/3");
  share("all", "");
  expect_refused("merge a --out m", 3, "a: of 2 shares these are missing: 2");
  expect_refused("merge a a b --out m", 3, "a: share 1 is there twice");
  expect_refused("merge a other --out m", 3, "other: is of another run");
  expect_refused("merge a third --out m", 3, "third: is of another run");
  expect_refused("merge a all --out m", 3, "all:1: is no result of sonde query --shard");
  expect_refused("merge a poses.csv --out m", 3, "poses.csv:1: is no result");
  folder.write("cut", text_of(folder / "b").substr(0, 300));
  expect_refused("merge a cut --out m", 3, "cut:");
  const std::string whole = text_of(folder / "b");
  folder.write("short", whole.substr(0, whole.rfind('\n', whole.size() - 2) + 1));
  expect_refused("merge a short --out m", 3, "short: the row 39 is missing: the file has been cut");
  folder.write("holed",
               whole.substr(0, whole.find("\n3,") + 1) + whole.substr(whole.find("\n5,") + 1));
  expect_refused("merge a holed --out m", 3, "holed: the row 3 is missing");
  expect_refused("merge a b --out a", 2, "is one of the inputs");
}

TEST_F(QueryScale, more_seeds_never_lead_further) {
  folder.write("turned.csv",
               "px,py,pz,qw,qx,qy,qz\n0.02,0.03,0.01,0.8,0.6,0,0\n0.05,0,0.02,0.5,0.5,0.5,0.5\n");
  const Csv one = query("--poses turned.csv --budget-steps 10"),
            five = query("--poses turned.csv --budget-steps 10 --seeds 5");
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LE(five.number(i, "depth"), one.number(i, "depth"));
    EXPECT_GT(five.number(i, "iterations"), one.number(i, "iterations"));
    EXPECT_GE(five.number(i, "lower_bound"), one.number(i, "lower_bound"));
    EXPECT_LE(five.number(i, "lower_bound"), five.number(i, "depth"));
  }
}

// Reference: the file of contacts.
TEST_F(QueryScale, json_holds_the_contacts_that_were_asked_for) {
  folder.write("parts.sonde.json", R"({"probe": {"mesh": "small.off"}, "fixed": [
    {"name": "floor, old \"2\"", "mesh": "large.off"},
    {"name": "wall", "mesh": "large.off", "pose": [1, 0, 0, 1, 0, 0, 0]}]})");
  const std::string rest = " --poses poses.csv --contacts ";
  const json whole = json::parse(expect_done("query parts.sonde.json --json" + rest + "c.csv").out);
  const Csv contacts(text_of(folder / "c.csv"));
  std::size_t next = 0;
  for (const json& row : whole.at("results"))
    for (const json& contact : row.at("contact_rows")) {
      EXPECT_EQ(contact.size(), 8u);
      ASSERT_LT(next, contacts.rows.size());
      EXPECT_EQ(row.at("index").get<double>(), contacts.number(next, "index"));
      for (const std::string key : {"x", "y", "z", "nx", "ny", "nz", "multiplier"})
        EXPECT_EQ(contact.at(key).get<double>(), contacts.number(next, key)) << key;
      EXPECT_EQ(contact.at("part"), "floor, old \"2\"");
      ++next;
    }
  EXPECT_GT(next, 2u);
  EXPECT_EQ(next, contacts.rows.size());
  // Shares are joined to the same.
  for (const std::string i : {"1", "2"})
    expect_done("query parts.sonde.json --json --shard " + i + "/2 --out s" + i + rest + "c" + i);
  expect_done("merge s1 s2 --out joined");
  const json joined = json::parse(text_of(folder / "joined"));
  for (std::size_t i = 0; i < whole.at("results").size(); ++i)
    EXPECT_EQ(joined.at("results")[i].at("contact_rows").size(),
              whole.at("results")[i].at("contact_rows").size());
}

// Reference: boxes that face each other along x, their halves 0.05 and 0.1.
TEST_F(QueryScale, a_sweep_says_how_far_each_motion_is_free) {
  folder.write("way.csv",
               "px,py,pz,qw,qx,qy,qz\n0.35,0,0,1,0,0,0\n0.1,0,0,1,0,0,0\n"
               "0,0.4,0,1,0,0,0\n0,0.3,0,1,0,0,0\n");
  const Csv csv = query("--poses way.csv --sweep");
  EXPECT_EQ(csv.header, "index,status,free,px,py,pz,qw,qx,qy,qz,x,y,z,nx,ny,nz");
  ASSERT_EQ(csv.rows.size(), 3u);
  EXPECT_EQ(csv.text(0, "status"), "hit");
  EXPECT_NEAR(csv.number(0, "free"), 0.8, 1e-6);
  EXPECT_NEAR(csv.number(0, "px"), 0.15, 1e-6);
  EXPECT_NEAR(csv.number(0, "x"), 0.1, 1e-9);
  EXPECT_NEAR(csv.number(0, "nx"), 1, 1e-9);
  EXPECT_EQ(csv.text(1, "status"), "overlapping");
  EXPECT_EQ(csv.text(1, "free"), "0");
  EXPECT_EQ(csv.text(1, "x"), "");
  EXPECT_EQ(csv.text(2, "status"), "free");
  EXPECT_EQ(csv.text(2, "free"), "1");
  EXPECT_NEAR(csv.number(2, "py"), 0.3, 1e-15);
  for (const std::string i : {"1", "2"})
    expect_done("query boxes.sonde.json --poses way.csv --sweep --shard " + i + "/2 --out s" + i);
  expect_done("merge s1 s2 --out joined");
  EXPECT_EQ(Csv(text_of(folder / "joined")).rows, csv.rows);
}

// Reference: the face of a box that moves along x through that of another, with halves of 0.05 and
// 0.1: the gap x - 0.15 on both sides of the contact, and a slope of one between two rows.
TEST_F(QueryScale, clearance_is_one_continuous_number_through_the_contact) {
  std::string path = "px,py,pz,qw,qx,qy,qz\n";
  for (int i = 0; i < 9; ++i) path += std::to_string(0.154 - 0.001 * i) + ",0,0,1,0,0,0\n";
  folder.write("through.csv", path);
  for (const std::string more : {"", " --mode coherent", " --method pdt"}) {
    const Csv csv = query("--poses through.csv --clearance" + more);
    for (std::size_t i = 0; i < 9; ++i)
      EXPECT_NEAR(csv.number(i, "clearance"), 0.004 - 0.001 * static_cast<double>(i), 1e-6)
          << i << more;
  }
}

// Across the way on which they meet, it is far to where they are apart, however little they
// overlap: such a depth does not go on from the clearance.
TEST_F(QueryScale, of_some_motions_only_there_is_no_clearance_below_zero) {
  folder.write("in.csv", "px,py,pz,qw,qx,qy,qz\n0.151,0,0,1,0,0,0\n0.1499,0,0,1,0,0,0\n");
  for (const std::string more : {" --along 0,1,0", " --in-plane 1,0,0"}) {
    const Csv csv = query("--poses in.csv --clearance" + more);
    EXPECT_NEAR(csv.number(0, "clearance"), 0.001, 1e-12) << more;
    EXPECT_GT(csv.number(1, "depth"), 0.01) << more;
    EXPECT_EQ(csv.text(1, "clearance") + csv.text(1, "part"), "") << more;
  }
}

// Reference: the columns that depth and clearance have of their own.
TEST_F(QueryScale, signed_distance_is_one_number_on_both_sides) {
  const Csv csv = query("--poses many.csv --signed-distance --clearance");
  int apart = 0;
  for (std::size_t i = 0; i < csv.rows.size(); ++i) {
    const bool free = csv.text(i, "status") == "separated";
    apart += free;
    EXPECT_EQ(csv.number(i, "signed_distance"), csv.number(i, "clearance"));
    if (!free) {
      EXPECT_EQ(csv.number(i, "clearance"), -csv.number(i, "depth"));
    }
  }
  EXPECT_GT(apart, 5);
  EXPECT_LT(apart, 36);
}

TEST_F(QueryScale, json_states_its_format_and_says_yes_and_no) {
  const json result =
      json::parse(expect_done("query boxes.sonde.json --poses many.csv --time 2ms --json").out);
  EXPECT_EQ(result.at("format"), 1);
  EXPECT_TRUE(result.at("results")[0].at("late").is_boolean());
  const json replayed = json::parse(expect_done("replay boxes.sonde.json --json").out);
  EXPECT_EQ(replayed.at("format"), 1);
  EXPECT_TRUE(replayed.at("results")[0].at("jumped").is_boolean());
}

TEST_F(QueryScale, flags_that_contradict_each_other_are_refused) {
  const std::string query = "query boxes.sonde.json --poses many.csv ";
  for (const std::string flag :
       {"--mode coherent", "--time 1ms", "--claim", "--contacts c.csv", "--seeds 2", "--phases"})
    for (const std::string question : {"--touch", "--sweep"})
      expect_refused(query + question + " " + flag, 2, question + " does no search");
  for (const std::string flag : {"--touch", "--clearance", "--along 1,0,0"})
    expect_refused(query + "--sweep " + flag, 2, "--sweep is a question of its own");
  for (const std::string flag : {"--shard 1/2", "--resume --out r", "--seeds 2"})
    expect_refused(query + "--mode coherent " + flag, 2, "--mode coherent follows");
  for (const std::string flag : {"", "--json ", "--budget-steps 10 "})
    expect_refused(query + "--mode coherent --bound " + flag, 2, "makes no lower bound");
  for (const std::string flag : {"", "--mode coherent ", "--mode static "})
    expect_refused("replay boxes.sonde.json --bound " + flag, 2, "makes no lower bound");
  expect_refused(query + "--resume", 2, "it needs --out");
  expect_refused(query + "--contacts many.csv", 2, "one of the inputs");
  expect_refused(query + "--contacts r --out r", 2, "name the same file");
}

}  // namespace
}  // namespace sonde::test
