// SPDX-License-Identifier: GPL-3.0-or-later
// The files that a scene names: within a folder, out of it, or not there.
#include <gmock/gmock.h>

#include "engine/base/error.hpp"
#include "engine/scene/scene.hpp"
#include "tests/engine/scene/scene_texts.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde {
namespace {

using test::smallest;
using test::TempFolder;
using test::with_line;
using test::with_probe_line;
using testing::HasSubstr;

/// The complaint about a scene whose paths are to stay in the folder "own" beside a folder "other".
std::string complaint_within(const std::string& scene) {
  const TempFolder folder;
  std::filesystem::create_directories(folder / "own/meshes");
  std::filesystem::create_directory(folder / "other");
  folder.write("other/b.off", "");
  std::filesystem::create_symlink(folder / "other/b.off", folder / "own/link.off");
  try {
    read_scene_within(folder / "own", folder.write("own/a.sonde.json", scene));
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(ScenePaths, its_paths_stay_in_a_folder_where_that_is_asked) {
  EXPECT_EQ(complaint_within(smallest), "");
  EXPECT_EQ(complaint_within(R"({"probe": {"mesh": "meshes/../a.off"},
                                 "fixed": {"mesh": "meshes/b.off"}, "device": "touch"})"),
            "");
  for (const char* out : {"../other/b.off", "/etc/b.off", "meshes/../../b.off", "link.off", ".."})
    EXPECT_THAT(complaint_within("{\"probe\": {\"mesh\": \"a.off\"},\n\"fixed\": {\"mesh\": \"" +
                                 std::string(out) + "\"}}"),
                HasSubstr("a.sonde.json:2: \"mesh\" leads out of the folder "))
        << out;
  for (const char* line : {R"("trajectory": "../a.csv")", R"("coupling": "../a.json")",
                           R"("device": "../a.json")", R"("device": {"profile": "/a.json"})"})
    EXPECT_THAT(complaint_within(with_line(line)),
                testing::ContainsRegex("json:4: .* leads out of the folder"))
        << line;
}

/// The names of what a scene in the folder "own" names outside of it.
std::vector<std::string> names_out_of(const std::string& scene) {
  const TempFolder folder;
  for (const char* name : {"own", "own/meshes", "other"})
    std::filesystem::create_directory(folder / name);
  folder.write("other/b.off", "");
  std::filesystem::create_symlink(folder / "other/b.off", folder / "own/link.off");
  std::vector<std::string> out;
  for (const auto& path : paths_out_of(folder / "own", folder.write("own/a.sonde.json", scene)))
    out.push_back(path.lexically_relative(folder.path()).generic_string());
  return out;
}

TEST(ScenePaths, its_paths_out_of_a_folder_are_listed_and_not_read) {
  EXPECT_THAT(names_out_of(smallest), testing::IsEmpty());
  EXPECT_THAT(names_out_of(R"({"probe": {"mesh": "meshes/../a.off"}, "device": "touch",
                               "fixed": {"mesh": "meshes/b.off"}, "coupling": {"k": 100}})"),
              testing::IsEmpty());
  EXPECT_THAT(names_out_of(R"({"probe": {"mesh": "link.off"}, "fixed": {"mesh": "../other/b.off"},
                               "trajectory": "../none.csv", "coupling": "../none.json",
                               "device": {"profile": "../other/none.json"}})"),
              testing::ElementsAre("own/link.off", "other/b.off", "none.csv", "none.json",
                                   "other/none.json"));
  EXPECT_THROW(names_out_of("{"), InputError);
}

TEST(ScenePaths, a_mesh_that_is_not_there_is_told_with_the_scenes_line) {
  const TempFolder folder;
  folder.write("b.off", "OFF");
  const auto file = folder.write("a.json", with_probe_line("\"scale\": 2"));
  try {
    require_meshes(read_scene(file));
    FAIL() << "there is no a.off";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), file.string() + ":3: \"mesh\" names " + (folder / "a.off").string() +
                                ": no such file");
  }
  folder.write("a.off", "OFF");
  EXPECT_NO_THROW(require_meshes(read_scene(file)));
}

TEST(ScenePaths, so_is_a_file_of_gains_or_a_trajectory) {
  const TempFolder folder;
  const auto reason_of = [](const std::filesystem::path& file) -> std::string {
    try {
      require_trajectory(read_scene(file));
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  };
  const std::string bodies =
      "{\"probe\": {\"mesh\": \"a.off\"},\n\"fixed\": {\"mesh\": \"b.off\"},\n";
  const auto path = folder.write("path.json", bodies + "\"trajectory\": \"none.csv\"}");
  EXPECT_EQ(reason_of(path), path.string() + ":3: \"trajectory\" names " +
                                 (folder / "none.csv").string() + ": no such file");
  const auto gains = folder.write("gains.json", bodies + "\"coupling\": \"none.json\"}");
  EXPECT_EQ(reason_of(gains), gains.string() + ":3: \"coupling\" names " +
                                  (folder / "none.json").string() + ": no such file");
  folder.write("none.csv", "");
  folder.write("none.json", "{}");
  EXPECT_EQ(reason_of(path), "");
  EXPECT_EQ(reason_of(gains), "");
}

TEST(ScenePaths, a_key_with_a_null_character_does_not_cut_the_reason) {
  const TempFolder folder;
  const auto file = folder.write("a.json", "{\"prob\\u0000e\": 1}");
  try {
    read_scene(file);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("unknown key \"prob\\x00e\"; the nearest"));
  }
}

}  // namespace
}  // namespace sonde
