// SPDX-License-Identifier: GPL-3.0-or-later
// The reference is the reader: what is written and read again is the same, field by field, to the
// bit.
#include "engine/scene/write_scene.hpp"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <array>
#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>
#include <random>

#include "engine/base/error.hpp"
#include "engine/queries/pose_numbers.hpp"
#include "engine/settings/device_settings_file.hpp"
#include "engine/settings/settings.hpp"
#include "engine/text/file_unit.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde {
namespace {

using test::TempFolder;
using testing::HasSubstr;

void expect_same(const Pose& a, const Pose& b) {
  EXPECT_EQ(a.p, b.p);
  EXPECT_EQ(a.q.coeffs(), b.q.coeffs());
}

void expect_same(const SceneBody& a, const SceneBody& b) {
  EXPECT_EQ(a.mesh, b.mesh);
  EXPECT_EQ(a.model, b.model);
  EXPECT_EQ(a.scale, b.scale);
  EXPECT_EQ(a.offset, b.offset);
  expect_same(a.pose, b.pose);
}

void expect_same(const Scene& a, const Scene& b) {
  EXPECT_EQ(a.unit, b.unit);
  EXPECT_EQ(a.schema, b.schema);
  EXPECT_EQ(a.format, b.format);
  EXPECT_EQ(a.trajectory, b.trajectory);
  EXPECT_EQ(a.view, b.view);
  {
    SCOPED_TRACE("probe");
    expect_same(a.probe, b.probe);
  }
  {
    SCOPED_TRACE("fixed");
    expect_same(a.fixed, b.fixed);
  }
  EXPECT_EQ(a.coupling.mode, b.coupling.mode);
  for (const Setting& s : coupling_settings())
    EXPECT_EQ(get(a.coupling, s.key), get(b.coupling, s.key)) << s.key;
  for (const Setting& s : servo_settings())
    EXPECT_EQ(get(a.servo, s.key), get(b.servo, s.key)) << s.key;
  EXPECT_EQ(a.device.profile, b.device.profile);
  ASSERT_EQ(a.device.settings.has_value(), b.device.settings.has_value());
  if (a.device.settings) {
    EXPECT_EQ(device_settings_text(*a.device.settings), device_settings_text(*b.device.settings));
  }
}

Scene written_and_read(const Scene& scene, const std::filesystem::path& file) {
  write_scene(scene, file);
  return read_scene(file);
}

constexpr const char* full = R"({
    "$schema": "sonde-scene.schema.json",
    "unit": "mm",
    "probe": {"mesh": "sub/a \"b\".off", "model": "solid", "scale": 2.54,
              "pose": [1.1, 2.2, 3.3, 0.996194698, -0.087155743, 0, 0]},
    "fixed": {"mesh": "/b.off", "model": "surface", "pose": [10, 0, 0, 0.6, 0, 0.8, 0]},
    "trajectory": "../path.csv",
    "coupling": {"mode": "classic", "k": 1.7, "k_t": 2, "k_r": 3, "b_t": 4, "b_r": 0.5,
                 "max_force": 6, "max_torque": 7},
    "device": {"profile": "mine.json", "control": "position", "scaling": 4,
               "axes": {"y": {"from": "z", "inverted": true}}},
    "servo": {"rate_hz": 500, "budget_us": 100, "budget_steps": 5, "accuracy": 0.01,
              "passivity_control": 0},
    "view": {"camera": [1, 2, {"a": null}]}
  })";

TEST(WriteScene, into_the_folder_that_the_program_is_in) {
  const TempFolder folder;
  const Scene scene = read_scene(std::string(SONDE_RESOURCES) + "/scenes/spoon-in-cup.sonde.json");
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  EXPECT_NO_THROW(write_scene(scene, "a.sonde.json"));
  std::filesystem::current_path(before);
  expect_same(read_scene(folder / "a.sonde.json"), scene);
}

TEST(WriteScene, what_was_read_reads_the_same_again) {
  const TempFolder folder;
  const Scene scene = read_scene(folder.write("full.sonde.json", full));
  expect_same(written_and_read(scene, folder / "copy.sonde.json"), scene);
}

TEST(WriteScene, a_format_that_was_said_is_said_again) {
  const std::string bodies = R"("probe": {"mesh": "a.off"}, "fixed": {"mesh": "a.off"}})";
  const Scene said = scene_in(R"({"format": 1, )" + bodies, "/s.sonde.json");
  EXPECT_EQ(scene_in(scene_text(said, "/"), "/s.sonde.json").format, 1);
  const Scene silent = scene_in("{" + bodies, "/s.sonde.json");
  EXPECT_EQ(scene_text(silent, "/").find("format"), std::string::npos);
}

TEST(WriteScene, so_does_an_allowance_in_any_unit) {
  const TempFolder folder;
  for (const char* unit : {"m", "mm", "um", "in", "ft"})
    for (const char* key : {"allowance", "safety"})
      for (const char* length : {"0.01", "1e-5", "0.3333333333333333", "7.1"}) {
        const Scene scene = read_scene(folder.write(
            "a.sonde.json", std::string(R"({"unit": ")") + unit + R"(", "probe": {"mesh": "a.off"},
            "fixed": {"mesh": "b.off"}, ")" +
                                key + "\": " + length + "}"));
        EXPECT_NE(scene.probe.offset, 0);
        EXPECT_EQ(scene.probe.offset < 0, std::string(key) == "allowance");
        expect_same(written_and_read(scene, folder / "copy.sonde.json"), scene);
      }
}

TEST(WriteScene, so_does_a_bundled_scene) {
  const TempFolder folder;
  for (const char* name : {"spoon-in-cup", "torus-knots", "terrain", "crumpled-soup", "peg-in-hole",
                           "nut-on-bolt", "linked-tori"}) {
    SCOPED_TRACE(name);
    const Scene scene = read_scene(std::string(SONDE_RESOURCES "/scenes/") + name + ".sonde.json");
    expect_same(written_and_read(scene, folder / "copy.sonde.json"), scene);
  }
}

TEST(WriteScene, and_one_with_a_profile_alone_or_settings_alone) {
  const TempFolder folder;
  for (const char* device : {R"("sigma.7")", R"({"profile": "sigma.7"})", R"({"scaling": 2})"}) {
    SCOPED_TRACE(device);
    const Scene scene = read_scene(
        folder.write("d.sonde.json",
                     std::string(R"({"probe": {"mesh": "a"}, "fixed": {"mesh": "b"}, "device": )") +
                         device + "}"));
    expect_same(written_and_read(scene, folder / "copy.sonde.json"), scene);
  }
}

TEST(WriteScene, any_pose_made_storable_comes_back_to_the_bit) {
  const TempFolder folder;
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  Scene scene = read_scene(folder.write("full.sonde.json", full));
  for (const char* unit : {"m", "cm", "mm", "um", "in", "ft"}) {
    SCOPED_TRACE(unit);
    scene.unit = *unit_in_metres(unit);
    for (int i = 0; i < 300; ++i) {
      Pose pose{Quat(normal(random), normal(random), normal(random), normal(random)).normalized(),
                Vec3(normal(random), normal(random), normal(random)) *
                    std::pow(10.0, normal(random) * 2)};
      scene.probe.pose = storable(pose, scene.unit);
      EXPECT_LT((scene.probe.pose.p - pose.p).norm(), 1e-11 * pose.p.norm());
      const std::string text = scene_text(scene, folder.path());
      expect_same(scene_in(text, folder / "copy.sonde.json").probe.pose, scene.probe.pose);
    }
  }
}

TEST(WriteScene, so_does_any_quaternion_of_a_few_digits) {
  std::mt19937 random(8);
  std::normal_distribution<double> normal;
  Scene scene = scene_in(full, "/nowhere/full.sonde.json");
  for (const double digits : {1e4, 1e6, 1e9, 1e12, 1e15})
    for (int i = 0; i < 500; ++i) {
      const Quat q =
          Quat(normal(random), normal(random), normal(random), normal(random)).normalized();
      std::array<double, 7> numbers{0, 0, 0, q.w(), q.x(), q.y(), q.z()};
      for (double& number : numbers) number = std::round(number * digits) / digits;
      scene.probe.pose = pose_of_numbers(numbers);
      const std::string text = scene_text(scene, "/nowhere");
      expect_same(scene_in(text, "/nowhere/copy.sonde.json").probe.pose, scene.probe.pose);
    }
}

TEST(WriteScene, its_meshes_are_found_from_another_folder) {
  const TempFolder folder;
  std::filesystem::create_directories(folder / "deep/er");
  const Scene scene = read_scene(folder.write("full.sonde.json", full));
  const Scene moved = written_and_read(scene, folder / "deep/er/copy.sonde.json");
  EXPECT_EQ(moved.probe.mesh, scene.probe.mesh);
  EXPECT_EQ(moved.trajectory, scene.trajectory);
  const auto json = nlohmann::json::parse(test::text_of(folder / "deep/er/copy.sonde.json"));
  EXPECT_EQ(json["probe"]["mesh"], "../../sub/a \"b\".off");
}

TEST(WriteScene, a_name_that_is_no_utf8_is_refused_by_name) {
  const TempFolder folder;
  Scene scene = read_scene(folder.write("full.sonde.json", full));
  scene.fixed.mesh = folder / "b\xff.off";
  try {
    write_scene(scene, folder / "copy.sonde.json");
    FAIL() << "written";
  } catch (const InputError& bad) {
    EXPECT_THAT(bad.what(), HasSubstr("UTF-8"));
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "copy.sonde.json"));
}

std::string reason_of_writing(const Scene& scene, const std::filesystem::path& file) {
  try {
    write_scene(scene, file);
  } catch (const InputError& bad) {
    return bad.what();
  }
  return {};
}

TEST(WriteScene, a_full_disk_and_a_folder_that_is_not_there_are_named) {
  const TempFolder folder;
  const Scene scene = read_scene(folder.write("full.sonde.json", full));
  EXPECT_THAT(reason_of_writing(scene, "/dev/full"), HasSubstr("/dev/full: cannot be written: No "
                                                               "space left"));
  EXPECT_THAT(reason_of_writing(scene, folder / "none/a.sonde.json"), HasSubstr("none/a.sonde"));
}

/// A disk that is full half way through, played by a limit on the size of files.
TEST(WriteScene, what_was_there_stays_where_the_writing_fails_half_way) {
  const TempFolder folder;
  const Scene scene = read_scene(folder.write("full.sonde.json", full));
  folder.write("kept.sonde.json", "as it was");
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{100, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string reason = reason_of_writing(scene, folder / "kept.sonde.json");
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_THAT(reason, HasSubstr("kept.sonde.json: cannot be written: "));
  EXPECT_EQ(test::text_of(folder / "kept.sonde.json"), "as it was");
  EXPECT_EQ(folder.file_count(), 2u) << "nothing half-written lies about";
}

TEST(WriteScene, a_zero_keeps_its_sign) {
  Scene scene;
  scene.unit = 1;
  scene.probe.mesh = scene.fixed.mesh = "/a/a.ply";
  scene.probe.pose = {Quat(-0.6, -0.0, 0.8, 0.0), Vec3(-0.0, 0.0, 1)};
  const Pose again = scene_in(scene_text(scene, "/a"), "/a/a.sonde.json").probe.pose;
  EXPECT_TRUE(std::signbit(again.q.x()));
  EXPECT_FALSE(std::signbit(again.q.z()));
  EXPECT_TRUE(std::signbit(again.p.x()));
  EXPECT_FALSE(std::signbit(again.p.y()));
}

}  // namespace
}  // namespace sonde
