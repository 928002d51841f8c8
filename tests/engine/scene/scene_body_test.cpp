// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies of a scene that are joined of several meshes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <random>
#include <set>

#include "engine/base/error.hpp"
#include "engine/queries/body_queries.hpp"
#include "engine/queries/pair_queries.hpp"
#include "engine/scene/scene.hpp"
#include "engine/scene/write_scene.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde {
namespace {

using testing::HasSubstr;

class SceneParts : public testing::Test {
 protected:
  SceneParts() {
    folder.write("box.off", off(test::box({0.1, 0.1, 0.1})));
    folder.write("ring.off", off(test::torus(0.1, 0.03, 16, 10)));
  }
  static std::string off(const PolygonSoup& soup) {
    const Soup all = triangulate(soup).soup;
    std::string text = "OFF\n" + std::to_string(all.vertices.size()) + " " +
                       std::to_string(all.triangles.size()) + " 0\n";
    char line[120];
    for (const Vec3& x : all.vertices)
      std::snprintf(line, sizeof line, "%.17g %.17g %.17g\n", x[0], x[1], x[2]), text += line;
    for (const Triangle& t : all.triangles)
      text += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " +
              std::to_string(t[2]) + "\n";
    return text;
  }
  Scene scene(const std::string& fixed) const {
    folder.write("s.sonde.json", R"({"probe": {"mesh": "box.off"}, "fixed": )" + fixed + "}");
    return read_scene(folder / "s.sonde.json");
  }
  std::string complaint(const std::string& fixed) const {
    try {
      const Scene read = scene(fixed);
      require_meshes(read);
      load(read.fixed, read.unit);
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  }
  const std::string two = R"([
    {"name": "left", "mesh": "box.off", "pose": [-0.3, 0, 0, 1, 0, 0, 0]},
    {"mesh": "ring.off", "scale": 2, "pose": [0.5, 0, 0.1, 0.6, 0.8, 0, 0]}])";
  const test::TempFolder folder;
};

// Reference: each part as a body of its own, at its pose.
TEST_F(SceneParts, a_list_stands_where_each_of_it_does) {
  const Scene read = scene(two);
  ASSERT_EQ(read.fixed.parts.size(), 2u);
  const auto fixed = load(read.fixed, read.unit);
  EXPECT_TRUE(fixed->solid);
  double measure = 0;
  for (const SceneBody& part : read.fixed.parts) measure += load(part, 1)->mass.measure;
  EXPECT_NEAR(fixed->mass.measure, measure, 1e-12);
  const auto probe = load(read.probe, 1);
  const Pair pair(probe, fixed);
  std::vector<Pair> each;
  for (const SceneBody& part : read.fixed.parts) each.emplace_back(probe, load(part, 1));
  std::mt19937_64 random(1);
  int touching = 0;
  for (int i = 0; i < 300; ++i) {
    const Pose X{test::random_rotation(random), test::random_in_ball(random, 0.8)};
    bool expected = false;
    for (std::size_t k = 0; k < each.size(); ++k)
      expected = expected || touch(each[k], inverse(read.fixed.parts[k].pose) * X);
    EXPECT_EQ(touch(pair, X), expected) << i;
    touching += expected;
  }
  EXPECT_GT(touching, 10);
}

TEST_F(SceneParts, a_place_names_its_part) {
  const auto fixed = load(scene(two).fixed, 1);
  EXPECT_EQ(part_at(*fixed, {-0.25, 0, 0}), "left");
  EXPECT_EQ(part_at(*fixed, {0.4, 0, 0}), "ring.off");
  EXPECT_EQ(part_at(*load(scene(two).probe, 1), {0, 0, 0}), load(scene(two).probe, 1)->name);
  EXPECT_EQ(fixed->name, "left, ring") << "none with the ending of its file";
}

TEST_F(SceneParts, a_list_is_written_as_it_was_read) {
  const Scene read = scene(two);
  folder.write("again.sonde.json", scene_text(read, folder.path()));
  const Scene again = read_scene(folder / "again.sonde.json");
  ASSERT_EQ(again.fixed.parts.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const SceneBody &a = read.fixed.parts[i], &b = again.fixed.parts[i];
    EXPECT_EQ(part_name(a), part_name(b));
    EXPECT_EQ(a.mesh, b.mesh);
    EXPECT_EQ(a.scale, b.scale);
    EXPECT_EQ(a.pose.p, b.pose.p);
    EXPECT_EQ(a.pose.q.coeffs(), b.pose.q.coeffs());
  }
  EXPECT_EQ(scene_text(again, folder.path()), scene_text(read, folder.path()));
}

// Reference: the same parts, each larger and further away.
TEST_F(SceneParts, the_scale_of_the_whole_is_that_of_its_parts_and_their_places) {
  Scene read = scene(two);
  read.fixed.scale = 3;
  const auto fixed = load(read.fixed, 1);
  EXPECT_TRUE(inside(*fixed, {-0.9, 0, 0}));
  EXPECT_FALSE(inside(*fixed, {-0.3, 0, 0}));
  folder.write("again.sonde.json", scene_text(read, folder.path()));
  const auto again = load(read_scene(folder / "again.sonde.json").fixed, 1);
  EXPECT_NEAR(again->mass.measure, fixed->mass.measure, 1e-12);
  EXPECT_TRUE(inside(*again, {-0.9, 0, 0}));
}

// Reference: the felt part as a body of its own.
TEST_F(SceneParts, what_is_not_felt_is_no_part_of_the_body) {
  const Scene read = scene(R"([
    {"mesh": "box.off", "colour": "#e97d25", "shown": false},
    {"mesh": "ring.off", "pose": [0.5, 0, 0, 1, 0, 0, 0], "felt": false}])");
  const auto fixed = load(read.fixed, 1), box = load(read.fixed.parts[0], 1);
  EXPECT_EQ(fixed->soup.triangles.size(), box->soup.triangles.size());
  EXPECT_NEAR(fixed->mass.measure, box->mass.measure, 1e-15);
  ASSERT_EQ(fixed->parts.size(), 1u);
  EXPECT_EQ(fixed->name, "box.off");
  ComponentFiles files;
  EXPECT_EQ(load_part(read.fixed, 1, 1, files).body->soup.triangles.size(),
            load(read.fixed.parts[1], 1)->soup.triangles.size());
  folder.write("again.sonde.json", scene_text(read, folder.path()));
  const SceneBody again = read_scene(folder / "again.sonde.json").fixed;
  EXPECT_EQ(again.parts[0].colour, "#e97d25");
  EXPECT_FALSE(again.parts[0].shown);
  EXPECT_TRUE(again.parts[0].felt);
  EXPECT_TRUE(again.parts[1].shown);
  EXPECT_FALSE(again.parts[1].felt);
}

TEST_F(SceneParts, parts_that_are_none_are_refused_with_the_line) {
  EXPECT_THAT(complaint("[]"), HasSubstr("s.sonde.json:1: \"fixed\" has no parts"));
  EXPECT_THAT(complaint(R"([{"mesh": "box.off"}, {"mesh": "box.off"}])"),
              HasSubstr("two parts are named \"box.off\": give each a \"name\" of its own"));
  EXPECT_THAT(complaint("[{\"mesh\": \"box.off\"},\n{\"mesh\": \"gone.off\"}]"),
              HasSubstr("s.sonde.json:2: \"mesh\" names"));
  EXPECT_THAT(complaint(R"([{"mesh": "box.off", "colour": 3}])"), HasSubstr("colour"));
  EXPECT_THAT(complaint(R"([{"mesh": "box.off", "colour": "red"}])"),
              HasSubstr("s.sonde.json:1: \"colour\" is \"red\"; it must be like \"#e97d25\""));
  EXPECT_THAT(complaint(R"([{"mesh": "box.off", "felt": 1}])"), HasSubstr("felt"));
  EXPECT_THAT(complaint(R"([{"mesh": "box.off", "felt": false}])"),
              HasSubstr("s.sonde.json:1: no part of \"fixed\" is felt"));
  EXPECT_THAT(complaint(R"([{"name": "", "mesh": "box.off"}])"), HasSubstr("\"name\" is empty"));
  EXPECT_THAT(complaint(R"([{"mesh": "box.off", "model": "surface"},
                            {"mesh": "ring.off"}])"),
              HasSubstr("s.sonde.json:1: box.off is closed: as one of several parts it cannot be a "
                        "surface"));
  EXPECT_THAT(complaint(R"({"name": "one", "mesh": "box.off"})"), HasSubstr("name"));
}

class SceneComponents : public SceneParts {
 protected:
  SceneComponents() {
    PolygonSoup two = test::box({0.1, 0.1, 0.1}), ring = test::torus(0.1, 0.03, 16, 10);
    const std::size_t first = two.points.size();
    for (const Vec3& x : ring.points) two.points.push_back(x + Vec3(0.5, 0, 0));
    for (Polygon polygon : ring.polygons) {
      for (std::size_t& corner : polygon) corner += first;
      two.polygons.push_back(polygon);
    }
    folder.write("two.off", off(two));
  }
};

// Reference: the same two shapes, each in a file of its own.
TEST_F(SceneComponents, of_a_file_are_parts) {
  const Scene read = scene(R"({"mesh": "two.off", "components": true, "scale": 2})");
  const auto fixed = load(read.fixed, 1);
  ASSERT_EQ(fixed->parts.size(), 2u);
  EXPECT_EQ(fixed->parts[0].name, "two.off:1");
  EXPECT_EQ(fixed->parts[1].name, "two.off:2");
  EXPECT_EQ(part_at(*fixed, {0.1, 0, 0}), "two.off:1");
  EXPECT_EQ(part_at(*fixed, {1.2, 0, 0}), "two.off:2");
  const auto ring = load(scene(R"({"mesh": "ring.off", "scale": 2})").fixed, 1);
  EXPECT_NEAR(fixed->parts[1].body->mass.measure, ring->mass.measure, 1e-12);
  const Scene one = scene(R"([{"mesh": "two.off", "component": 2, "scale": 2}])");
  EXPECT_NEAR(load(one.fixed, 1)->mass.measure, ring->mass.measure, 1e-12);
  EXPECT_EQ(part_name(one.fixed.parts[0]), "two.off:2");
}

TEST_F(SceneComponents, stand_listed_where_their_mesh_is_and_are_written_so) {
  const Scene read = scene(R"([{"mesh": "box.off"},
    {"mesh": "two.off", "name": "pair", "components": true, "felt": false, "colour": "#102030",
     "pose": [0, 0, 3, 1, 0, 0, 0]}])");
  EXPECT_EQ(scene_text(read, folder.path()),
            scene_text(scene_in(scene_text(read, folder.path()), read.file), folder.path()));
  ComponentFiles files;
  Scene listed = read;
  listed.fixed = with_components(read.fixed, 1, files);
  ASSERT_EQ(listed.fixed.parts.size(), 3u);
  folder.write("again.sonde.json", scene_text(listed, folder.path()));
  const SceneBody again = read_scene(folder / "again.sonde.json").fixed;
  ASSERT_EQ(again.parts.size(), 3u);
  for (const std::size_t i : {1u, 2u}) {
    const SceneBody& part = again.parts[i];
    EXPECT_EQ(part_name(part), "pair:" + std::to_string(i));
    EXPECT_EQ(part.component, i);
    EXPECT_FALSE(part.felt);
    EXPECT_EQ(part.colour, "#102030");
    EXPECT_EQ(part.pose.p, Vec3(0, 0, 3));
  }
  EXPECT_EQ(with_components(again, 1, files).parts.size(), 3u);
}

TEST_F(SceneComponents, a_mesh_of_one_stays_whole) {
  const auto fixed = load(scene(R"({"mesh": "box.off", "components": true})").fixed, 1);
  ASSERT_EQ(fixed->parts.size(), 1u);
  EXPECT_EQ(fixed->parts[0].name, "box.off");
}

TEST_F(SceneComponents, that_are_none_are_refused) {
  EXPECT_THAT(complaint(R"([{"mesh": "two.off", "component": 3}])"),
              HasSubstr("s.sonde.json:1: two.off has 2 components, not 3 as a part asks for"));
  EXPECT_THAT(complaint("[{\"mesh\": \"box.off\"},\n{\"mesh\": \"two.off\", \"component\": 3}]"),
              HasSubstr("s.sonde.json:2: two.off has 2 components, not 3"));
  EXPECT_THAT(complaint(R"([{"mesh": "two.off", "component": 0}])"),
              HasSubstr("s.sonde.json:1: \"component\" is 0; it must be a whole number from 1"));
  EXPECT_THAT(complaint(R"([{"mesh": "two.off", "component": 1.5}])"), HasSubstr("whole number"));
  EXPECT_THAT(complaint(R"([{"mesh": "two.off", "component": 1, "components": true}])"),
              HasSubstr("at once"));
  EXPECT_THAT(complaint(R"([{"mesh": "two.off", "components": true},
                            {"mesh": "box.off", "name": "two.off:2"}])"),
              HasSubstr("s.sonde.json:2: box.off is a part named \"two.off:2\" as another is"));
}

// Reference: each part loaded alone.
TEST_F(SceneComponents, that_are_alike_are_loaded_once_and_stand_each_at_its_place) {
  const Scene read = scene(R"([{"mesh": "box.off"}, {"name": "b", "mesh": "ring.off"},
    {"name": "c", "mesh": "box.off", "pose": [3, 0, 0, 1, 0, 0, 0], "colour": "#102030"},
    {"name": "d", "mesh": "box.off", "scale": 2}, {"name": "e", "mesh": "box.off"},
    {"mesh": "two.off", "component": 1}, {"mesh": "two.off", "component": 2}])");
  ComponentFiles files;
  const std::vector<std::size_t> wanted{6, 0, 1, 2, 3, 5};
  const auto parts = load_parts(read.fixed, wanted, 1, files);
  ASSERT_EQ(parts.size(), 7u);
  EXPECT_FALSE(parts[4].body);
  EXPECT_EQ(parts[0].body, parts[2].body);
  EXPECT_EQ(std::set<const Body*>({parts[0].body.get(), parts[1].body.get(), parts[3].body.get(),
                                   parts[5].body.get(), parts[6].body.get()})
                .size(),
            5u);
  for (const std::size_t i : wanted) {
    const BodyPart alone = load_part(read.fixed, i, 1, files);
    EXPECT_EQ(parts[i].name, alone.name);
    EXPECT_EQ(parts[i].X_BP.p, alone.X_BP.p);
    EXPECT_EQ(parts[i].body->soup.triangles, alone.body->soup.triangles);
    EXPECT_EQ(parts[i].body->mass.measure, alone.body->mass.measure);
    EXPECT_EQ(parts[i].body->name, alone.body->name);
  }
}

TEST_F(SceneComponents, of_several_that_are_wrong_the_first_is_told) {
  std::string list = R"([{"mesh": "box.off"})";
  for (int i = 3; i < 40; ++i)
    list += ",\n{\"mesh\": \"two.off\", \"component\": " + std::to_string(i) + "}";
  for (int round = 0; round < 20; ++round)
    ASSERT_THAT(complaint(list + "]"),
                HasSubstr("s.sonde.json:2: two.off has 2 components, not 3"));
}

TEST_F(SceneComponents, say_how_far_they_are_and_end_where_they_are_told_to) {
  const Scene read = scene(R"([{"mesh": "box.off"}, {"mesh": "ring.off"}, {"mesh": "two.off"}])");
  ComponentFiles files;
  double last = 0;
  load_parts(read.fixed, {0, 1, 2}, 1, files, [&last](double fraction) {
    EXPECT_GE(fraction, last - 1e-12);
    last = fraction;
    return true;
  });
  EXPECT_GT(last, 0.5);
  EXPECT_LE(last, 1 + 1e-12);
  EXPECT_THROW(load_parts(read.fixed, {0, 1, 2}, 1, files, [](double) { return false; }),
               Cancelled);
}

// As many as may be, as the window writes them, are read again.
TEST_F(SceneParts, of_a_large_assembly_are_read_and_more_than_there_may_be_are_refused) {
  Scene read = scene(R"([{"mesh": "box.off"}])");
  const SceneBody one = read.fixed.parts[0];
  read.fixed.parts.clear();
  std::mt19937_64 random(3);
  for (std::size_t i = 1; i <= most_parts; ++i) {
    SceneBody part = one;
    part.component = i;
    part.colour = "#102030";
    part.pose = {test::random_rotation(random), test::random_in_ball(random, 1)};
    read.fixed.parts.push_back(part);
  }
  folder.write("many.sonde.json", scene_text(read, folder.path()));
  EXPECT_EQ(read_scene(folder / "many.sonde.json").fixed.parts.size(), most_parts);
  std::string list;
  for (std::size_t i = 0; i <= most_parts; ++i) list += (i == 0 ? "[{}" : ",{}");
  EXPECT_THAT(complaint(list + "]"), HasSubstr("\"fixed\" has 10001 parts; at most 10000"));
}

TEST_F(SceneParts, paths_out_of_a_folder_are_found_in_every_part) {
  folder.write("out.sonde.json", R"({"probe": {"mesh": "box.off"}, "fixed": [
    {"mesh": "box.off"}, {"mesh": "../elsewhere.off"}]})");
  EXPECT_EQ(paths_out_of(folder.path(), folder / "out.sonde.json").size(), 1u);
}

}  // namespace
}  // namespace sonde
