// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene names outside of its folder is asked for before any of it is read.

#include "ui/document/paths_asked_for.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <filesystem>

#include "engine/recording/recording_header.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/actions/document_control.hpp"
#include "ui/actions/history_control.hpp"

namespace sonde::ui::test {
namespace {

class PathsAskedFor : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    for (const char* name : {"own", "other"}) std::filesystem::create_directory(folder / name);
    folder.write("own/cube.off", cube(0.1));
    cube_elsewhere = folder.write("other/cube.off", cube(0.1));
    gains = folder.write("other/gains.json", R"({"k": 321})");
  }
  std::filesystem::path write_scene(const std::string& fixed, const std::string& more = {}) {
    return folder.write("own/pair.sonde.json", R"({"unit": "m", "probe": {"mesh": "cube.off",
        "pose": [0.09, 0.02, 0.013, 1, 0, 0, 0]}, "fixed": {"mesh": ")" +
                                                   fixed + "\"}" + more + '}');
  }
  void open_file(const std::filesystem::path& file) {
    paths_asked_for.clear();
    open({QString::fromStdString(file.string())});
  }
  static QString canonical(const std::filesystem::path& path) {
    return QString::fromStdString(std::filesystem::canonical(path).string());
  }
  std::filesystem::path cube_elsewhere, gains;
};

TEST_F(PathsAskedFor, files_of_its_own_folder_and_sondes_own_scenes_are_not) {
  open_file(write_scene("cube.off"));
  EXPECT_EQ(opened, 1);
  EXPECT_TRUE(paths_asked_for.isEmpty());
  open_file(std::filesystem::path(SONDE_RESOURCES) / "scenes" / "torus-knots.sonde.json");
  EXPECT_EQ(opened, 2);
  EXPECT_TRUE(paths_asked_for.isEmpty()) << paths_asked_for[0].toStdString();
}

TEST_F(PathsAskedFor, refused_nothing_is_read_and_what_was_open_stays) {
  open_file(write_scene("cube.off"));
  consent = Consent::refused;
  // Were the gains read, they would be complained about.
  const auto bad = folder.write("other/bad.json", "none");
  open_file(write_scene("../other/cube.off", R"(, "coupling": "../other/bad.json")"));
  EXPECT_EQ(paths_asked_for, QStringList({canonical(cube_elsewhere), canonical(bad)}));
  EXPECT_EQ(opened, 1);
  EXPECT_EQ(failed, 1);
  EXPECT_TRUE(complaints.empty());
  EXPECT_TRUE(window->shown().has_value());
}

TEST_F(PathsAskedFor, agreed_to_once_it_is_asked_again_kept_it_is_not) {
  const auto scene = write_scene("../other/cube.off", R"(, "coupling": "../other/gains.json")");
  consent = Consent::once;
  open_file(scene);
  EXPECT_EQ(paths_asked_for.size(), 2);
  EXPECT_EQ(window->session()->coupling().k, 321);
  consent = Consent::kept;
  open_file(scene);
  EXPECT_EQ(paths_asked_for.size(), 2);
  open_file(scene);
  EXPECT_TRUE(paths_asked_for.isEmpty());
  EXPECT_EQ(opened, 3);
}

TEST_F(PathsAskedFor, only_what_is_new_is_asked_for_and_only_for_that_scene) {
  open_file(write_scene("../other/cube.off"));
  open_file(write_scene("../other/cube.off", R"(, "coupling": "../other/gains.json")"));
  EXPECT_EQ(paths_asked_for, QStringList(canonical(gains)));
  const auto copy = folder / "own/copy.sonde.json";
  std::filesystem::copy_file(folder / "own/pair.sonde.json", copy);
  open_file(copy);
  EXPECT_EQ(paths_asked_for.size(), 2);
}

TEST_F(PathsAskedFor, a_link_is_what_it_leads_to) {
  std::filesystem::create_symlink(cube_elsewhere, folder / "own/link.off");
  const auto scene = write_scene("link.off");
  open_file(scene);
  EXPECT_EQ(paths_asked_for, QStringList(canonical(cube_elsewhere)));
  std::filesystem::remove(folder / "own/link.off");
  std::filesystem::create_symlink(folder / "large.off", folder / "own/link.off");
  open_file(scene);
  EXPECT_EQ(paths_asked_for, QStringList(canonical(folder / "large.off")));
}

TEST_F(PathsAskedFor, what_the_user_saves_is_the_users) {
  answered_unit = 1;
  open({QString::fromStdString(cube_elsewhere.string()),
        QString::fromStdString((folder / "cube.off").string())});
  ASSERT_EQ(opened, 1);
  const auto file = folder / "own/saved.sonde.json";
  window->prompts().ask_save = [&](const QString&) {
    return QString::fromStdString(file.string());
  };
  ASSERT_TRUE(window->documents().save_as());
  open_file(file);
  EXPECT_EQ(opened, 2);
  EXPECT_TRUE(paths_asked_for.isEmpty());
}

/// The header of a recording, whose scene names a file of gains, which Sonde never writes there.
std::string with_gains_in(const std::string& gains, const std::string& header) {
  constexpr std::size_t head = 20, count = 4;
  QJsonObject json =
      QJsonDocument::fromJson(QByteArray::fromStdString(header.substr(head))).object();
  QJsonObject scene = QJsonDocument::fromJson(json["scene"].toString().toUtf8()).object();
  scene["coupling"] = QString::fromStdString(gains);
  json["scene"] = QString::fromUtf8(QJsonDocument(scene).toJson());
  const std::string text = QJsonDocument(json).toJson().toStdString();
  const auto crc = crc32_z(0, reinterpret_cast<const Bytef*>(text.data()), text.size());
  std::string out = header.substr(0, head - 2 * count);
  for (const std::uint64_t number : {std::uint64_t(text.size()), std::uint64_t(crc)})
    for (std::size_t byte = 0; byte < count; ++byte)
      out += static_cast<char>(number >> (8 * byte) & 0xffU);
  return out + text;
}

TEST_F(PathsAskedFor, gains_that_a_recording_names_are_not_read_unasked) {
  const auto recording = folder / "own/hostile.sonderec";
  const std::string honest =
      header_bytes(header_of(read_scene(write_scene("cube.off")), 0.05), recording);
  const auto bad = folder.write("other/bad.json", "none");
  folder.write("own/hostile.sonderec", with_gains_in("../other/bad.json", honest));
  consent = Consent::refused;
  window->history().open_recording(QString::fromStdString(recording.string()));
  ASSERT_TRUE(wait_until([this] { return failed == 1; }));
  EXPECT_EQ(paths_asked_for, QStringList(canonical(bad)));
  EXPECT_TRUE(complaints.empty()) << complaints[0].toStdString();
  consent = Consent::once;
  window->history().open_recording(QString::fromStdString(recording.string()));
  ASSERT_TRUE(wait_until([this] { return failed == 2; }));
  EXPECT_TRUE(complaints.at(0).contains("bad.json")) << complaints[0].toStdString();
}

TEST_F(PathsAskedFor, what_is_no_recording_is_said_and_nothing_asked) {
  const auto scene = write_scene("../other/cube.off");
  window->history().open_recording(QString::fromStdString(scene.string()));
  ASSERT_TRUE(wait_until([this] { return failed == 1; }));
  EXPECT_TRUE(complaints.at(0).contains("no recording begins here")) << complaints[0].toStdString();
  EXPECT_TRUE(paths_asked_for.isEmpty());
}

TEST_F(PathsAskedFor, what_the_scene_of_a_recording_names_is_too) {
  const auto recording = folder / "own/hostile.sonderec";
  Scene scene = read_scene(write_scene("../other/cube.off"));
  const std::string honest = header_bytes(header_of(scene, 0.05), recording);
  folder.write("own/hostile.sonderec", honest);
  consent = Consent::refused;
  paths_asked_for.clear();
  window->history().open_recording(QString::fromStdString(recording.string()));
  ASSERT_TRUE(wait_until([this] { return failed == 1; }));
  EXPECT_EQ(paths_asked_for, QStringList(canonical(cube_elsewhere)));
  EXPECT_FALSE(window->shown().has_value());
  consent = Consent::kept;
  window->history().open_recording(QString::fromStdString(recording.string()));
  ASSERT_TRUE(wait_until([this] { return !complaints.empty(); }));
  EXPECT_TRUE(complaints[0].contains("holds no tick")) << "it has been opened";
  EXPECT_EQ(paths_asked_for.size(), 2);
}

TEST_F(PathsAskedFor, what_the_user_records_is_the_users) {
  open_file(write_scene("../other/cube.off"));
  const auto file = folder / "own/mine.sonderec";
  window->history().record(QString::fromStdString(file.string()));
  wait(50);
  window->history().set_recording(false);
  ASSERT_TRUE(wait_until([this] { return !window->history().recorder().ending(); }));
  paths_asked_for.clear();
  window->history().open_recording(QString::fromStdString(file.string()));
  ASSERT_TRUE(wait_until([this] { return window->history().looking_back(); }));
  EXPECT_TRUE(paths_asked_for.isEmpty());
}

TEST_F(PathsAskedFor, a_scene_that_changes_to_name_others_is_not_read_again_unasked) {
  open_file(write_scene("cube.off"));
  write_scene("../other/cube.off");
  ASSERT_TRUE(wait_until([this] { return !complaints.empty(); }));
  EXPECT_NE(complaints[0].indexOf("outside of its folder"), -1) << complaints[0].toStdString();
  EXPECT_TRUE(paths_asked_for.isEmpty());
  EXPECT_TRUE(window->shown().has_value());
}

}  // namespace
}  // namespace sonde::ui::test
