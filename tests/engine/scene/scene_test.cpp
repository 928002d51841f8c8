// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/scene/scene.hpp"

#include <gmock/gmock.h>

#include <random>

#include "engine/settings/settings.hpp"
#include "tests/engine/scene/scene_texts.hpp"
#include "tests/support/complaint.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde {
namespace {

using test::smallest;
using test::TempFolder;
using test::with_line;
using test::with_probe_line;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

/// The complaint about a scene of this text; empty where there is none.
std::string scene_complaint(const std::string& text) {
  return test::complaint_of(text, "a.sonde.json", read_scene);
}

TEST(Scene, the_smallest_one_has_the_defaults) {
  const TempFolder folder;
  const Scene scene = read_scene(folder.write("pegs.sonde.json", smallest));
  EXPECT_EQ(scene.name, "pegs");
  EXPECT_EQ(scene.unit, 1);
  EXPECT_EQ(scene.probe.mesh, folder / "a.off");
  EXPECT_EQ(scene.fixed.mesh, folder / "b.off");
  EXPECT_EQ(scene.probe.model, Model::automatic);
  EXPECT_EQ(scene.probe.scale, 1);
  EXPECT_EQ(scene.probe.pose.p, Vec3(0, 0, 0));
  EXPECT_EQ(scene.probe.pose.q.w(), 1);
  EXPECT_FALSE(scene.trajectory);
  EXPECT_EQ(scene.coupling.k, Coupling{}.k);
  EXPECT_EQ(scene.servo.rate_hz, 1000);
  EXPECT_EQ(scene.view, "{}");
  EXPECT_EQ(scene.device.profile, "");
  EXPECT_FALSE(scene.device.settings);
}

TEST(Scene, everything_is_read) {
  const TempFolder folder;
  const Scene scene = read_scene(folder.write("full.sonde.json", R"({
    "$schema": "sonde-scene.schema.json",
    "unit": "mm",
    "probe": {"mesh": "sub/a.off", "model": "solid", "scale": 2,
              "pose": [1, 2, 3, 0.5, 0.5, 0.5, 0.5]},
    "fixed": {"mesh": "/b.off", "model": "surface", "pose": [10, 0, 0, 1, 0, 0, 0]},
    "trajectory": "../path.csv",
    "coupling": {"mode": "classic", "k": 1, "k_t": 2, "k_r": 3, "b_t": 4, "b_r": 0.5,
                 "max_force": 6, "max_torque": 7},
    "device": {"profile": "mine.json", "control": "position", "scaling": 4,
               "axes": {"y": {"from": "z", "inverted": true}}},
    "servo": {"rate_hz": 500, "budget_us": 100, "budget_steps": 5, "accuracy": 0.01},
    "view": {"camera": [1, 2, {"a": null}]}
  })"));
  EXPECT_EQ(scene.unit, 1e-3);
  EXPECT_EQ(scene.probe.mesh, folder / "sub/a.off");
  EXPECT_EQ(scene.fixed.mesh, "/b.off");
  EXPECT_EQ(scene.probe.model, Model::solid);
  EXPECT_EQ(scene.fixed.model, Model::surface);
  EXPECT_EQ(scene.probe.scale, 2);
  EXPECT_LT((scene.probe.pose.p - Vec3(1e-3, 2e-3, 3e-3)).norm(), 1e-18) << "lengths in the unit";
  EXPECT_EQ(scene.trajectory, folder.path().parent_path() / "path.csv");
  EXPECT_EQ(scene.coupling.mode, Coupling::Mode::classic);
  EXPECT_EQ(scene.coupling.max_torque, 7);
  EXPECT_EQ(scene.servo.rate_hz, 500);
  EXPECT_EQ(scene.servo.budget.microseconds, 100);
  EXPECT_EQ(scene.servo.budget.steps, 5);
  EXPECT_EQ(scene.servo.accuracy, 0.01);
  EXPECT_EQ(scene.device.profile, (folder / "mine.json").string()) << "relative to the scene";
  ASSERT_TRUE(scene.device.settings);
  EXPECT_EQ(scene.device.settings->control, DeviceSettings::Control::position);
  EXPECT_EQ(scene.device.settings->scaling, 4);
  EXPECT_EQ(scene.device.settings->axes.axes[1].source, 2);
  EXPECT_EQ(scene.view, R"({"camera": [1, 2, {"a": null}]})");

  const Pose relative = relative_pose(scene);
  EXPECT_LT((relative.p - Vec3(-9e-3, 2e-3, 3e-3)).norm(), 1e-15);
}

// Reference: the manual. The same part at the same place, with poses in its own frame or in the
// world.
TEST(Scene, poses_are_in_the_frame_of_a_fixed_mesh_or_in_the_world_of_a_list_of_parts) {
  const TempFolder folder;
  const auto probe_in_fixed = [&](const std::string& fixed) {
    return relative_pose(read_scene(folder.write(
        "s.sonde.json",
        R"({"probe": {"mesh": "a.off", "pose": [1, 2, 3, 1, 0, 0, 0]}, "fixed": )" + fixed + "}")));
  };
  const std::string turned = R"({"mesh": "b.off", "pose": [10, 0, 0, 0, 0, 0, 1]})";
  const Pose in_mesh = probe_in_fixed(turned), in_world = probe_in_fixed("[" + turned + "]");
  EXPECT_LT((in_mesh.p - Vec3(9, -2, 3)).norm(), 1e-15) << "half a turn about z";
  EXPECT_LT((in_world.p - Vec3(1, 2, 3)).norm(), 1e-15);
  for (const char* whole : {R"({"mesh": "b.off"})", R"([{"mesh": "b.off"}])"})
    EXPECT_LT((probe_in_fixed(whole).p - in_world.p).norm(), 1e-15) << whole;
}

TEST(Scene, an_allowance_takes_the_probe_smaller_and_a_safety_larger) {
  const TempFolder folder;
  const auto offset = [&](const std::string& line) {
    const std::string text = with_line(line + ", \"unit\": \"mm\"");
    const Scene scene = read_scene(folder.write("s.sonde.json", text));
    EXPECT_EQ(scene.fixed.offset, 0);
    return scene.probe.offset;
  };
  EXPECT_EQ(offset("\"allowance\": 0.01"), -1e-5);
  EXPECT_EQ(offset("\"safety\": 0.25"), 2.5e-4);
  EXPECT_EQ(offset("\"safety\": 0"), 0);
  EXPECT_EQ(offset("\"allowance\": 0.01, \"safety\": 0"), -1e-5);
  EXPECT_THAT(scene_complaint(with_line("\"allowance\": -1")),
              AllOf(HasSubstr("4: "), HasSubstr("it must be zero or more")));
  EXPECT_THAT(scene_complaint(with_line("\"allowance\": 1, \"safety\": 2")),
              AllOf(HasSubstr("4: "), HasSubstr("at once")));
  EXPECT_THAT(scene_complaint(with_line("\"safety\": \"1 mm\"")), HasSubstr("4: "));
  EXPECT_THAT(scene_complaint(with_probe_line("\"allowance\": 1")), HasSubstr("allowance"));
}

TEST(Scene, the_bodies_are_loaded_with_it) {
  const TempFolder folder;
  folder.write("a.off",
               "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
               "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  folder.write("b.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const Scene scene = read_scene(folder.write("s.sonde.json", with_line("\"allowance\": 0.01")));
  const auto probe = load(scene.probe, scene.unit), fixed = load(scene.fixed, scene.unit);
  EXPECT_EQ(probe->offset.by, -0.01);
  EXPECT_EQ(fixed->offset.by, 0);
  SceneBody surface = scene.fixed;
  surface.offset = -0.01;
  EXPECT_THROW(load(surface, 1), InputError);
}

TEST(Scene, a_device_is_a_profile_or_an_object) {
  const TempFolder folder;
  const auto device =
      [&](const std::string& value) {
        return read_scene(folder.write("s.sonde.json", R"({"probe": {"mesh": "a.off"},
        "fixed": {"mesh": "b.off"}, "device": )" + value + "}"))
            .device;
      };
  EXPECT_EQ(device("\"sigma.7\"").profile, "sigma.7");
  EXPECT_EQ(device("\"my/own.json\"").profile, (folder / "my/own.json").string());
  EXPECT_FALSE(device("{\"profile\": \"sigma.7\"}").settings) << "those kept for it";
  EXPECT_TRUE(device("{\"profile\": \"sigma.7\", \"turn\": 2}").settings);
  const SceneDevice any = device("{\"turn\": 2}");
  EXPECT_EQ(any.profile, "");
  EXPECT_EQ(any.settings->turn, 2);
}

TEST(Scene, each_setting_of_the_table_is_a_key) {
  const TempFolder folder;
  for (const Setting& setting : coupling_settings()) {
    const std::string line = std::string("\"coupling\": {\"") + setting.key + "\": ";
    for (const double value : {setting.minimum, setting.maximum}) {
      const Scene scene =
          read_scene(folder.write("a.json", with_line(line + std::to_string(value) + "}")));
      EXPECT_EQ(get(scene.coupling, setting.key), value);
    }
    EXPECT_THAT(scene_complaint(with_line(line + std::to_string(setting.maximum * 2) + "}")),
                AllOf(StartsWith("4: "), HasSubstr(setting.key), HasSubstr("between")));
    EXPECT_THAT(scene_complaint(with_line(line + "\"1\"}")),
                HasSubstr("a string; expected a number"));
  }
  for (const Setting& setting : servo_settings()) {
    const std::string line = std::string("\"servo\": {\"") + setting.key + "\": ";
    const auto most = static_cast<int>(setting.maximum);
    const Scene scene =
        read_scene(folder.write("a.json", with_line(line + std::to_string(most) + "}")));
    EXPECT_EQ(get(scene.servo, setting.key), most);
    EXPECT_THAT(scene_complaint(with_line(line + "-1}")),
                AllOf(StartsWith("4: "), HasSubstr(setting.key), HasSubstr("between")));
  }
}

TEST(Scene, coupling_may_be_a_file_of_its_own) {
  const TempFolder folder;
  folder.write("gains.json", "{\n\"k\": 900}");
  const auto file = folder.write("a.sonde.json", with_line("\"coupling\": \"gains.json\""));
  EXPECT_EQ(read_scene(file).coupling.k, 900);
  folder.write("gains.json", "{\n\"kk\": 900}");
  try {
    read_scene(file);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), StartsWith((folder / "gains.json").string() + ":2: unknown key"));
  }
  std::filesystem::remove(folder / "gains.json");
  EXPECT_THROW(read_scene(file), InputError);
}

TEST(Scene, unknown_keys_are_named_with_the_nearest_known) {
  EXPECT_THAT(scene_complaint(with_line("\"trajektory\": \"a.csv\"")),
              AllOf(StartsWith("4: "), HasSubstr("\"trajektory\""), HasSubstr("\"trajectory\"")));
  EXPECT_THAT(scene_complaint(with_probe_line("\"sclae\": 2")),
              AllOf(StartsWith("4: "), HasSubstr("\"sclae\""), HasSubstr("\"scale\"")));
  EXPECT_THAT(scene_complaint(with_line("\"coupling\":\n {\"kt\": 2}")),
              AllOf(StartsWith("5: "), HasSubstr("\"kt\""), HasSubstr("\"k_t\"")));
  EXPECT_THAT(scene_complaint(with_line("\"servo\": {\n\n\"rate\": 2}")),
              AllOf(StartsWith("6: "), HasSubstr("\"rate\""), HasSubstr("\"rate_hz\"")));
}

/// By that word, whatever else it may hold that is not known here.
TEST(Scene, a_newer_format_is_refused_as_such) {
  EXPECT_THAT(scene_complaint(with_line("\"parts\": [],\n\"format\": 2")),
              AllOf(StartsWith("5: "), HasSubstr("\"format\" is 2: the scene is of a newer format"),
                    Not(HasSubstr("parts"))));
  EXPECT_THAT(scene_complaint(with_line("\"format\": 0")), HasSubstr("there is only 1"));
  EXPECT_THAT(scene_complaint(with_line("\"format\": \"1\"")),
              HasSubstr("\"format\" is a string; expected a number"));
  EXPECT_NO_THROW(scene_in(with_line("\"format\": 1"), "a.sonde.json"));
}

TEST(Scene, missing_keys_are_named) {
  EXPECT_THAT(scene_complaint("\n{\"probe\": {\"mesh\": \"a.off\"}}"),
              AllOf(StartsWith("2: "), HasSubstr("\"fixed\" is missing")));
  EXPECT_THAT(scene_complaint("{\n\"fixed\":\n{}, \"probe\": {\"mesh\": \"a.off\"}}"),
              AllOf(StartsWith("3: "), HasSubstr("\"mesh\" is missing from \"fixed\"")));
}

TEST(Scene, keys_given_twice_are_refused) {
  EXPECT_THAT(scene_complaint(with_line("\"unit\": \"m\",\n\"unit\": \"mm\"")),
              AllOf(StartsWith("5: "), HasSubstr("\"unit\" is given twice"), HasSubstr("line 4")));
  EXPECT_THAT(scene_complaint(with_line("\"view\": {\"a\": 1, \"a\": 2}")),
              HasSubstr("given twice"));
}

TEST(Scene, wrong_types_are_refused) {
  EXPECT_THAT(scene_complaint("[]"),
              StartsWith("1: the file's value is a list; expected an object"));
  EXPECT_THAT(scene_complaint(with_line("\"unit\": 3")),
              StartsWith("4: \"unit\" is a number; expected a string"));
  EXPECT_THAT(scene_complaint(with_line("\"view\": []")), HasSubstr("a list; expected an object"));
  EXPECT_THAT(scene_complaint(with_line("\"device\": true")), HasSubstr("expected an object"));
  EXPECT_THAT(scene_complaint(with_line("\"device\": {\"scalling\": 2}")),
              AllOf(HasSubstr("unknown key \"scalling\""), HasSubstr("\"scaling\"")));
  EXPECT_THAT(scene_complaint(with_line("\"coupling\": null")),
              HasSubstr("null; expected an object"));
  EXPECT_THAT(scene_complaint(with_line("\"trajectory\": 1")), HasSubstr("expected a string"));
  EXPECT_THAT(scene_complaint(with_line("\"trajectory\": \"\"")), HasSubstr("empty path"));
  EXPECT_THAT(scene_complaint(with_probe_line("\"scale\": \"2\"")),
              StartsWith("4: \"scale\" is a string; expected a number"));
  EXPECT_THAT(scene_complaint(with_probe_line("\"pose\": {}")), HasSubstr("expected a list"));
}

TEST(Scene, unknown_words_are_refused) {
  EXPECT_THAT(scene_complaint(with_line("\"unit\": \"km\"")),
              AllOf(StartsWith("4: "), HasSubstr("\"km\""), HasSubstr("nearest")));
  EXPECT_THAT(scene_complaint(with_probe_line("\"model\": \"soild\"")),
              AllOf(StartsWith("4: "), HasSubstr("\"soild\""), HasSubstr("\"solid\"")));
  EXPECT_THAT(scene_complaint(with_line("\"coupling\": {\"mode\": \"clasic\"}")),
              AllOf(StartsWith("4: "), HasSubstr("\"clasic\""), HasSubstr("\"classic\"")));
}

TEST(Scene, numbers_out_of_range_are_refused) {
  for (const char* scale : {"0", "-1"})
    EXPECT_THAT(scene_complaint(with_probe_line(std::string("\"scale\": ") + scale)),
                AllOf(StartsWith("4: "), HasSubstr("above zero")));
  for (const char* number : {"1e999", "NaN", "Infinity", "-Infinity", "0x10", "1,5"})
    EXPECT_THAT(scene_complaint(with_probe_line(std::string("\"scale\": ") + number)),
                StartsWith("4: "))
        << number;
}

TEST(Scene, poses_are_checked) {
  EXPECT_THAT(scene_complaint(with_probe_line("\"pose\": [0, 0, 0]")),
              AllOf(StartsWith("4: "), HasSubstr("3 numbers; expected 7")));
  EXPECT_THAT(scene_complaint(with_probe_line("\"pose\": [0, 0, 0, 1,\n\"0\", 0, 0]")),
              AllOf(StartsWith("5: "), HasSubstr("a string; expected numbers")));
  EXPECT_THAT(scene_complaint(with_probe_line("\"pose\": [0, 0, 0, 1, 0.1, 0, 0]")),
              AllOf(StartsWith("4: "), HasSubstr("length 1.00499")));
  EXPECT_THAT(scene_complaint(with_probe_line("\"pose\": [0, 0, 0, 0, 0, 0, 0]")),
              HasSubstr("length 0"));
  EXPECT_EQ(scene_complaint(with_probe_line("\"pose\": [0, 0, 0, 1.0009, 0, 0, 0]")), "");
}

TEST(Scene, a_quaternion_near_unit_is_normalised) {
  const TempFolder folder;
  const auto file =
      folder.write("a.sonde.json", with_probe_line("\"pose\": [0, 0, 0, 0.6003, 0, 0.8004, 0]"));
  EXPECT_NEAR(read_scene(file).probe.pose.q.norm(), 1, 1e-15);
}

TEST(Scene, text_that_is_no_json_is_refused_with_its_line) {
  EXPECT_THAT(scene_complaint("{\n\"unit\": \"m\",\n\"probe\""), StartsWith("3: not JSON: "));
  EXPECT_THAT(scene_complaint("{\n\"unit\": \"m\"\n\"probe\": 1}"), StartsWith("3: not JSON: "));
  EXPECT_THAT(scene_complaint("{\n\"unit\": m}"), StartsWith("2: not JSON: "));
  EXPECT_THAT(scene_complaint(std::string(smallest) + "\n}"), StartsWith("2: not JSON: "));
  EXPECT_THAT(scene_complaint("{\n\"unit\": \"\xFF\"}"), StartsWith("2: not JSON: "));
  EXPECT_THAT(scene_complaint("\n\n"), HasSubstr("not JSON"));
  EXPECT_THAT(scene_complaint(std::string(1000, '[')), HasSubstr("nested too deeply"));
  EXPECT_THAT(scene_complaint(""), HasSubstr("the file is empty"));
  EXPECT_THAT(scene_complaint(std::string(5 << 20, ' ')), HasSubstr("longer than"));
  // The library's own codes and columns stay out of the message.
  EXPECT_THAT(scene_complaint("{"), testing::Not(HasSubstr("exception")));
}

TEST(Scene, every_beginning_of_a_scene_is_an_error_and_no_crash) {
  const std::string whole = smallest;
  for (std::size_t n = 0; n < whole.size(); ++n)
    EXPECT_NE(scene_complaint(whole.substr(0, n)), "") << n;
  EXPECT_EQ(scene_complaint(whole), "");
  EXPECT_EQ(scene_complaint("\xEF\xBB\xBF" + whole), "") << "a byte-order mark";
}

TEST(Scene, damaged_text_is_read_or_refused_and_never_worse) {
  const std::string whole = with_line(
      R"("unit": "mm", "coupling": {"mode": "classic", "k_t": 2.5e1}, "view": {"a": [1, {}]})");
  std::mt19937_64 random(1);
  const TempFolder folder;
  for (int i = 0; i < 300; ++i) {
    std::string text = whole;
    for (int n = 0; n <= i % 4; ++n) text[random() % text.size()] = static_cast<char>(random());
    const auto file = folder.write("a.sonde.json", text);
    try {
      read_scene(file);
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), StartsWith(file.string() + ":"));
    }
  }
}

TEST(Scene, a_file_that_is_not_there_or_a_folder_is_refused) {
  const TempFolder folder;
  EXPECT_THROW(read_scene(folder / "none.sonde.json"), InputError);
  EXPECT_THROW(read_scene(folder.path()), InputError);
}

TEST(Scene, a_file_of_gains_is_an_object_not_another_name) {
  const TempFolder folder;
  const auto gains = folder.write("gains.json", "\"gains.json\"");
  EXPECT_THROW(read_coupling(gains), InputError);
}

TEST(Scene, load_applies_unit_and_scale) {
  const TempFolder folder;
  const auto mesh = folder.write("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const auto body = load({.mesh = mesh, .scale = 2, .pose = {}}, 1e-3);
  EXPECT_NEAR(body->mass.measure, 2e-6, 1e-18) << "half of a square of 2 mm";
}

}  // namespace
}  // namespace sonde
