// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "tests/app/app_test.hpp"
#include "tests/engine/mesh_io/mesh_files.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class Assembly : public AppTest {
 protected:
  /// A scene whose small box stands over the large one by a gap.
  void stand_over(const std::string& name, double gap) const {
    folder.write(name, R"({"probe": {"mesh": "small.off", "pose": [0, 0, )" +
                           std::to_string(0.15 + gap) +
                           R"(, 1, 0, 0, 0]}, "fixed": {"mesh": "large.off"}})");
  }
};

// Reference: boxes put into each other by a known length.
TEST_F(Assembly, clash_lists_what_overlaps_touches_and_is_near) {
  stand_over("in.sonde.json", -0.002);
  stand_over("over.sonde.json", 0.003);
  const Csv in(expect_done("clash in.sonde.json").out);
  EXPECT_EQ(in.header,
            "a,b,kind,depth,lower_bound,clearance,x,y,z,moved,px,py,pz,qw,qx,qy,qz,reason");
  ASSERT_EQ(in.rows.size(), 1u);
  EXPECT_EQ(in.text(0, "kind"), "overlapping");
  EXPECT_NEAR(in.number(0, "depth"), 0.002, 2e-9);
  EXPECT_EQ(in.text(0, "moved"), "small.off");
  EXPECT_NEAR(in.number(0, "pz"), 0.15, 2e-7);
  EXPECT_EQ(in.text(0, "clearance"), "") << "no number where there is none";
  EXPECT_EQ(Csv(expect_done("clash over.sonde.json").out).rows.size(), 0u);
  const Csv near(expect_done("clash over.sonde.json --within 0.01").out);
  EXPECT_EQ(near.text(0, "kind"), "clear");
  EXPECT_NEAR(near.number(0, "clearance"), 0.003, 1e-15);
  const Outcome all = expect_done("clash in.sonde.json over.sonde.json large.off --json");
  EXPECT_THAT(all.err, HasSubstr("5 parts: "));
  for (const json& row : json::parse(all.out).at("results"))
    EXPECT_EQ(row.at("kind"), "overlapping") << "all stand in one place";
  EXPECT_THAT(all.out, HasSubstr("large.off (3)")) << "a name of its own for each";
}

// Reference: two cubes of one file that overlap by a known length.
TEST_F(Assembly, clash_takes_meshes_apart) {
  std::string off = "OFF\n16 12 0\n", faces;
  for (int k = 0; k < 2; ++k) {
    for (int i = 0; i < 8; ++i)
      off += std::to_string((i & 1) + 0.9 * k) + " " + std::to_string((i >> 1) & 1) + " " +
             std::to_string(i >> 2) + "\n";
    for (const auto& f : {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
                          std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}}) {
      faces += "4";
      for (const int corner : f) faces.append(" ").append(std::to_string(corner + 8 * k));
      faces += "\n";
    }
  }
  folder.write("two.off", off + faces);
  const Csv found(expect_done("clash two.off --components").out);
  ASSERT_EQ(found.rows.size(), 1u);
  EXPECT_EQ(found.text(0, "a"), "two.off:1");
  EXPECT_EQ(found.text(0, "b"), "two.off:2");
  EXPECT_NEAR(found.number(0, "depth"), 0.1, 1e-7);
  folder.write("two.sonde.json", R"({"probe": {"mesh": "small.off", "pose": [5, 0, 0, 1, 0, 0, 0]},
      "fixed": {"mesh": "two.off", "components": true}})");
  EXPECT_EQ(Csv(expect_done("clash two.sonde.json").out).text(0, "b"), "two.off:2");
}

// Reference: by hand, the least way between two boxes in one place is their shortest side.
TEST_F(Assembly, clash_lists_a_part_that_is_there_twice) {
  for (const Vec3& size : {Vec3(1, 1, 1), Vec3(1, 2, 3), Vec3(0.2, 0.1, 0.3)}) {
    const PolygonSoup part = box(size), far = placed(box({1, 1, 1}), {9, 0, 0});
    folder.write("twice.off", as_off(joined(joined(part, far), part)));
    const Csv found(expect_done("clash twice.off --components").out);
    ASSERT_EQ(found.rows.size(), 1u);
    EXPECT_EQ(found.text(0, "a"), "twice.off:1");
    EXPECT_EQ(found.text(0, "b"), "twice.off:3");
    EXPECT_EQ(found.text(0, "kind"), "overlapping");
    EXPECT_NEAR(found.number(0, "depth"), size.minCoeff(), 1e-3 * size.minCoeff());
  }
}

// Reference: by hand, boxes that overlap by known lengths.
TEST_F(Assembly, clash_lists_parts_of_the_probe_too) {
  for (const double over : {0.002, 0.005, 0.03}) {
    folder.write("list.sonde.json",
                 R"({"probe": [{"name": "one", "mesh": "small.off"}, {"name": "two",
                     "mesh": "small.off", "pose": [)" +
                     std::to_string(0.1 - over) + R"(, 0, 0, 1, 0, 0, 0]}],
                     "fixed": {"mesh": "large.off", "pose": [9, 0, 0, 1, 0, 0, 0]}})");
    const Outcome done = expect_done("clash list.sonde.json");
    const Csv found(done.out);
    ASSERT_EQ(found.rows.size(), 1u);
    EXPECT_EQ(found.text(0, "a"), "one");
    EXPECT_EQ(found.text(0, "b"), "two");
    EXPECT_NEAR(found.number(0, "depth"), over, 1e-6);
    EXPECT_THAT(done.err, HasSubstr("3 parts: 1 pair overlaps, 0 touch"));
  }
}

// Reference: by hand, the overlap less the allowance.
TEST_F(Assembly, clash_says_that_a_scene_takes_the_probe_smaller_or_larger) {
  for (const auto& [key, by] :
       {std::pair{"allowance", -0.001}, {"allowance", -0.0005}, {"safety", 0.001}}) {
    folder.write("taken.sonde.json",
                 std::string("{\"") + key + "\": " + std::to_string(std::abs(by)) +
                     R"(, "probe": {"mesh": "small.off", "pose": [0, 0, 0.148, 1, 0, 0, 0]},
                         "fixed": {"mesh": "large.off"}})");
    const Outcome done = expect_done("clash taken.sonde.json --json");
    const json all = json::parse(done.out);
    EXPECT_NEAR(all.at("results").at(0).at("depth").get<double>(), 0.002 + by, 1e-7);
    const std::string word = std::string("small.off: taken ") +
                             (by == -0.0005 ? "500 µm " : "1 mm ") +
                             (by < 0 ? "smaller" : "larger");
    EXPECT_THAT(all.at("remarks").at(0).get<std::string>(), HasSubstr(word));
    EXPECT_THAT(done.err, HasSubstr(word));
    EXPECT_THAT(expect_done("clash taken.sonde.json --quiet").err, testing::IsEmpty());
  }
}

TEST_F(Assembly, clash_draws_each_pair) {
  stand_over("in.sonde.json", -0.002);
  stand_over("over.sonde.json", 0.003);
  const Csv in(
      expect_done("clash in.sonde.json over.sonde.json --within 0.01 --pictures drawn").out);
  std::size_t pictures = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder / "drawn")) {
    EXPECT_EQ(file.path().extension(), ".svg");
    ++pictures;
  }
  EXPECT_EQ(pictures, in.rows.size());
  EXPECT_GT(pictures, 0u);
  expect_refused("clash in.sonde.json --pictures drawn", 3, "is not empty");
  expect_refused("clash in.sonde.json --pictures small.off", 3, "is no folder");
}

TEST_F(Assembly, files_whose_names_are_no_utf8_are_taken) {
  for (const std::string name : {"K\xf6rper.off", "\xff\xfe.off", "a\xe3\x83.off"}) {
    std::filesystem::copy_file(folder / "small.off", folder / name);
    const Outcome done = expect_done("clash " + name + " large.off --json");
    EXPECT_EQ(json::parse(done.out).at("results").at(0).at("kind"), "overlapping");
    EXPECT_THAT(done.out, HasSubstr("\\\\x"));
    const std::string pair = " --probe " + name + " --fixed large.off ";
    for (const char* form : {"", " --json --contacts contacts.csv"})
      expect_done("query" + pair + "--poses poses.csv" + form);
    expect_done("insert" + pair + "--trajectory path.csv --quiet --out in-" + name);
    folder.write("at.csv", "x,y,z\n0,0,0\n");
    const Outcome points = expect_done("points " + name + " --points at.csv --json");
    EXPECT_EQ(json::parse(points.out).at("results").at(0).at("inside"), true);
    const json info = json::parse(expect_done("info " + name + " --json").out);
    EXPECT_THAT(info.dump(), HasSubstr("\\\\x")) << "the byte itself is told";
    const std::string scene = std::filesystem::path(name).stem().string() + ".sonde.json";
    stand_over(scene, -0.01);
    expect_done("compare " + scene + " --trajectory path.csv --quiet --out compared-" + name);
  }
}

/// Two suppliers' files of one name: which is which is told by the folder; twice the same file is
/// counted.
TEST_F(Assembly, files_of_one_name_are_told_apart_by_their_folders) {
  for (const char* folder_name : {"a", "b"}) {
    std::filesystem::create_directory(folder / folder_name);
    std::filesystem::copy_file(folder / "large.off", folder / folder_name / "lid.off");
  }
  const Csv found(expect_done("clash a/lid.off b/lid.off --quiet").out);
  ASSERT_EQ(found.rows.size(), 1u);
  EXPECT_EQ(found.text(0, "a"), "a/lid.off");
  EXPECT_EQ(found.text(0, "b"), "b/lid.off");
  const Csv twice(expect_done("clash a/lid.off a/lid.off --quiet").out);
  ASSERT_EQ(twice.rows.size(), 1u);
  EXPECT_EQ(twice.text(0, "a") + ' ' + twice.text(0, "b"), "lid.off lid.off (2)");
}

TEST_F(Assembly, clash_refuses_what_it_cannot_use) {
  expect_refused("clash small.off", 2, "at least two parts");
  expect_refused("clash small.off missing.off", 3, "missing.off: ");
  expect_refused("clash small.off large.off --within -1", 2, "--within");
  expect_refused("clash small.off large.off --out large.off", 2, "one of the inputs");
}

// Reference: a box that comes down by its gap.
TEST_F(Assembly, insert_says_where_it_binds) {
  stand_over("s.sonde.json", 0.03);
  const std::string run = "insert s.sonde.json --axis 0,0,-1 --travel 0.05 --steps 20 --out r";
  const Outcome done = expect_done(run);
  EXPECT_THAT(done.out, HasSubstr("It binds after 30 mm of 50 mm, at ("));
  EXPECT_THAT(done.out, testing::Not(HasSubstr("room")));
  const json summary = json::parse(text_of(folder / "r" / "summary.json"));
  EXPECT_NEAR(summary.at("first_contact").at("travel").get<double>(), 0.03, 5e-8);
  EXPECT_NEAR(summary.at("largest_depth").get<double>(), 0.02, 2e-6);
  const std::string table = text_of(folder / "r" / "insert.csv");
  expect_done(run);  // all parts are there
  EXPECT_EQ(text_of(folder / "r" / "insert.csv"), table);
}

/// A travel in millimetres is read as metres, which is said; the answer is that of those metres.
TEST_F(Assembly, insert_doubts_lengths_that_were_hardly_meant_in_metres) {
  stand_over("s.sonde.json", 0.03);
  const std::string way = "insert s.sonde.json --axis 0,0,-1 --steps 5 --out ";
  const Outcome far = expect_done(way + "far --travel 45");
  EXPECT_THAT(far.err, HasSubstr("--travel 45 is "));
  EXPECT_THAT(far.err, HasSubstr("lengths are in metres; --travel 0.045 would be millimetres"));
  EXPECT_THAT(far.out, HasSubstr("It binds after 30 mm of 45000 mm"));
  const Outcome wide = expect_done(way + "wide --travel 0.02 --offsets 3 --offset-range 20");
  EXPECT_THAT(wide.err, HasSubstr("--offset-range 0.02 would be millimetres"));
  const Outcome usual = expect_done(way + "usual --travel 0.5 --offsets 3 --offset-range 0.2");
  EXPECT_THAT(usual.err, testing::Not(HasSubstr("metres")));
  expect_refused(way + "x --travel 0.045 --wanted 40", 2,
                 "--wanted 40 m is more than the way's travel of 0.045 m");
}

// Reference: a box that comes down by its gap, with a second part aside.
TEST_F(Assembly, insert_names_the_part_that_binds) {
  folder.write("p.sonde.json", R"({"probe": {"mesh": "small.off", "pose": [0, 0, 0.18, 1, 0, 0, 0]},
      "fixed": [{"name": "bed", "mesh": "large.off"},
                {"name": "aside", "mesh": "large.off", "pose": [9, 0, 0, 1, 0, 0, 0]}]})");
  const Outcome done = expect_done("insert p.sonde.json --axis 0,0,-1 --travel 0.05 --out r");
  EXPECT_THAT(done.out, HasSubstr("It binds after 30 mm of 50 mm, on bed, at ("));
  const json summary = json::parse(text_of(folder / "r" / "summary.json"));
  EXPECT_EQ(summary.at("first_contact").at("part"), "bed");
  const Csv table(text_of(folder / "r" / "insert.csv"));
  EXPECT_EQ(table.text(table.rows.size() - 1, "part"), "bed");
}

// Reference: one run of all.
TEST_F(Assembly, a_map_is_made_in_shares_and_joined) {
  stand_over("s.sonde.json", 0.03);
  const std::string run =
      "insert s.sonde.json --axis 0,0,-1 --travel 0.02 --steps 5 --offsets 7 "
      "--offset-range 0.2 --tilts 3 --tilt-range 20 --quiet --out ";
  expect_done(run + "whole");
  expect_done(run + "a --shard 1/2");
  expect_done(run + "b --shard 2/2");
  expect_done("merge a b --out joined");
  for (const char* file : {"insert.csv", "insert.svg", "map.csv", "map.svg", "summary.json"})
    EXPECT_EQ(text_of(folder / "joined" / file), text_of(folder / "whole" / file)) << file;
  EXPECT_EQ(Csv(text_of(folder / "whole" / "map.csv")).rows.size(), 21u);
}

TEST_F(Assembly, insert_goes_along_a_path_too_and_refuses_what_is_no_way) {
  const Outcome done = expect_done("insert boxes.sonde.json --trajectory path.csv --out p");
  EXPECT_THAT(done.out, HasSubstr("It binds after 20 mm of 39 mm"));
  stand_over("s.sonde.json", 0.03);
  stand_over("in.sonde.json", -0.01);
  for (const char* axis : {"0,0,0", "0 0 0", "nan,0,1", "0,0,inf"})
    expect_refused(std::string("insert s.sonde.json --travel 1 --out x --axis ") + axis, 2,
                   "--axis must be three finite numbers");
  expect_refused("insert s.sonde.json --axis 0,0,1 --travel 1 --twist nan --out x", 2, "--twist");
  expect_refused("insert s.sonde.json --axis 0,0,1 --travel 0 --out x", 2, "above zero");
  expect_refused("insert s.sonde.json --axis 0,0,1 --out x", 2, "--travel");
  expect_refused("insert s.sonde.json --out x", 2, "give either");
  expect_refused("insert in.sonde.json --axis 0,0,1 --travel 1 --out x", 3, "begins where");
  for (const char* far : {"1e9", "1e12", "1e18", "1e151"})
    expect_refused(std::string("insert s.sonde.json --axis 0,0,-1 --out x --travel ") + far, 3,
                   "a million times as long as the probe is large");
  EXPECT_FALSE(std::filesystem::exists(folder / "x"));
  const std::string map =
      "insert s.sonde.json --axis 0,0,1 --travel 1 --out x --offsets 3 --offset-range 0.1 ";
  expect_refused(map + "--lateral 0,0,2", 2, "--lateral must not");
  for (const char* lateral : {"0,0,0", "nan,0,1", "inf,0,0"})
    expect_refused(map + "--lateral " + lateral, 2, "three finite numbers");
  expect_refused(map + "--wanted 2", 2, "more than the way's travel");
  expect_refused(map + "--tilts 3", 2, "--tilt-range above zero");
  const std::string way = "insert s.sonde.json --axis 0,0,1 --travel 1 --out x ";
  expect_refused(way + "--offsets 3", 2, "--offset-range above zero");
  expect_refused(way + "--tilts 3 --tilt-range 1", 2, "give --offsets");
}

}  // namespace
}  // namespace sonde::test
