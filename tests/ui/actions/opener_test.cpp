// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/opener.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/temp_folder.hpp"
#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

/// With a scene of two tetrahedra, whose questions are answered and complaints kept.
class OpenerTest : public testing::Test {
 protected:
  void SetUp() override {
    need_application();
    // What one agrees to is kept there.
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope,
                       QString::fromStdString((folder / "settings").string()));
    write_mesh("probe.off", 0.1);
    write_mesh("fixed.off", 0.2);
    std::filesystem::create_directory(folder / "sub");
    write_scene("pair.sonde.json", "probe.off");
    write_scene("sub/out.sonde.json", "../probe.off");
    prompts.report_error = [this](const QString& reason) { complaints << reason; };
    prompts.ask_bodies = [this](const MeshPair& pair, const PairSetup&) {
      ++asked_units;
      return unit ? std::optional(same_unit(pair, *unit)) : std::nullopt;
    };
    prompts.ask_paths = [this](const QString& scene, const QStringList& paths) {
      asked_paths << scene << paths;
      return consent;
    };
    window = std::make_unique<QWidget>();
    opener = std::make_unique<Opener>(*window, prompts);
    QObject::connect(opener.get(), &Opener::ready,
                     [this](DrawnSession& drawn) { ready.push_back(std::move(drawn)); });
    QObject::connect(opener.get(), &Opener::failed,
                     [this](const QString& reason) { failed << reason; });
    QObject::connect(opener.get(), &Opener::say, [this](const QString& what) { said << what; });
  }
  void TearDown() override {
    opener.reset();
    ready.clear();
  }
  void write_mesh(const char* name, double side) const {
    const std::string x = std::to_string(side);
    folder.write(name, "OFF\n4 4 0\n0 0 0\n" + x + " 0 0\n0 " + x + " 0\n0 0 " + x +
                           "\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  }
  void write_scene(const char* name, const std::string& probe) const {
    const std::string fixed = probe.substr(0, probe.size() - 9) + "fixed.off";
    folder.write(name, R"({"unit": "m", "probe": {"mesh": ")" + probe +
                           R"(", "pose": [0.5, 0, 0, 1, 0, 0, 0]}, "fixed": {"mesh": ")" + fixed +
                           "\"}}");
  }
  QString path(const char* name) const { return QString::fromStdString((folder / name).string()); }
  bool ends() {
    const auto before = std::exchange(ended, int(ready.size()) + failed.size());
    return wait_until([&] { return int(ready.size()) + failed.size() > before; }) &&
           (ended = int(ready.size()) + failed.size(), true);
  }

  sonde::test::TempFolder folder;
  Prompts prompts;
  std::unique_ptr<QWidget> window;
  std::unique_ptr<Opener> opener;
  std::vector<DrawnSession> ready;
  QStringList failed, said, complaints, asked_paths;
  std::optional<double> unit;
  Consent consent = Consent::refused;
  int asked_units = 0, ended = 0;
};

TEST_F(OpenerTest, a_scene_is_ready_with_its_bodies_and_nothing_is_asked) {
  opener->open_files({path("pair.sonde.json")}, {});
  ASSERT_TRUE(ends());
  ASSERT_EQ(ready.size(), 1u) << complaints.join('\n').toStdString();
  ASSERT_TRUE(ready[0].session);
  EXPECT_EQ(ready[0].session->loaded().probe_file, folder / "probe.off");
  EXPECT_EQ(ready[0].session->loaded().start.p, Vec3(0.5, 0, 0));
  EXPECT_TRUE(asked_paths.isEmpty());
  EXPECT_EQ(asked_units, 0);
}

TEST_F(OpenerTest, what_cannot_be_read_is_told_once_with_its_file) {
  folder.write("bad.sonde.json", "{\"unit\": ");
  for (const char* name : {"bad.sonde.json", "no-such.sonde.json"}) {
    failed.clear();
    complaints.clear();
    opener->open_scene(path(name));
    ASSERT_TRUE(wait_until([this] { return !failed.isEmpty(); }));
    ASSERT_EQ(complaints.size(), 1);
    EXPECT_TRUE(complaints[0].contains(name)) << complaints[0].toStdString();
    EXPECT_EQ(failed, complaints);
  }
  EXPECT_TRUE(ready.empty());
}

TEST_F(OpenerTest, files_are_one_scene_or_two_meshes) {
  const QString mesh = path("probe.off");
  for (const QStringList& files :
       {QStringList(), QStringList(mesh), QStringList({mesh, mesh, mesh})}) {
    opener->open_files(files, {});
    ASSERT_EQ(complaints.size(), 1);
    EXPECT_TRUE(complaints.takeFirst().contains("one scene (NAME.sonde.json), or two meshes"));
  }
  EXPECT_EQ(failed.size(), 3);
}

TEST_F(OpenerTest, a_mesh_that_is_taken_for_a_scene_is_told_how_to_open_it) {
  opener->open_scene(path("probe.off"));
  ASSERT_EQ(complaints.size(), 1);
  EXPECT_TRUE(complaints[0].contains("probe.off is a mesh")) << complaints[0].toStdString();
  EXPECT_TRUE(complaints[0].contains("Open two meshes"));
  EXPECT_EQ(failed, complaints);
}

TEST_F(OpenerTest, two_meshes_are_asked_about_once_both_are_read) {
  unit = 1e-3;
  opener->open_files({path("probe.off"), path("fixed.off")}, {});
  ASSERT_TRUE(ends());
  EXPECT_EQ(asked_units, 1);
  ASSERT_EQ(ready.size(), 1u);
  EXPECT_LT(ready[0].session->probe().mass.radius, 1e-3);
  opener->open_meshes(path("probe.off"), path("fixed.off"), 1.0);
  ASSERT_TRUE(wait_until([this] { return ready.size() == 2; }));
  EXPECT_EQ(asked_units, 1) << "the unit is known";
  EXPECT_GT(ready[1].session->probe().mass.radius, 0.05);
}

TEST_F(OpenerTest, who_gives_no_unit_has_given_up_which_is_no_error) {
  opener->open_meshes(path("probe.off"), path("fixed.off"), {});
  ASSERT_TRUE(ends());
  EXPECT_EQ(failed, QStringList(""));
  EXPECT_TRUE(complaints.isEmpty());
}

TEST_F(OpenerTest, a_mesh_that_cannot_be_read_is_not_asked_about) {
  unit = 1;
  folder.write("bad.off", "OFF\n1 1 0\n0 0\n");
  opener->open_meshes(path("probe.off"), path("bad.off"), {});
  ASSERT_TRUE(ends());
  EXPECT_EQ(asked_units, 0);
  ASSERT_EQ(complaints.size(), 1);
  EXPECT_TRUE(complaints[0].contains("bad.off"));
}

TEST_F(OpenerTest, paths_out_of_a_scenes_folder_are_asked_about_and_remembered_where_one_says_so) {
  const QString scene = path("sub/out.sonde.json");
  opener->open_scene(scene);
  ASSERT_TRUE(wait_until([this] { return !failed.isEmpty(); }));
  EXPECT_EQ(failed, QStringList("")) << "refused is given up";
  EXPECT_TRUE(complaints.isEmpty());
  ASSERT_EQ(asked_paths.size(), 3);
  EXPECT_EQ(asked_paths[0], "out.sonde.json");
  EXPECT_TRUE(asked_paths[1].endsWith("probe.off") || asked_paths[2].endsWith("probe.off"));
  const auto open = [&](Consent answer) {
    consent = answer;
    asked_paths.clear();
    const std::size_t before = ready.size();
    opener->open_scene(scene);
    EXPECT_TRUE(wait_until([&] { return ready.size() > before; }));
    return !asked_paths.isEmpty();
  };
  EXPECT_TRUE(open(Consent::once));
  EXPECT_TRUE(open(Consent::kept)) << "once was for that time alone";
  EXPECT_FALSE(open(Consent::refused)) << "it was agreed to";
}

TEST_F(OpenerTest, what_is_opened_instead_takes_over_and_the_first_is_told) {
  int given_up = 0, done = 0;
  const auto scene = folder / "pair.sonde.json";
  opener->make(
      "Turning", [scene](const Progress& p) { return open_scene(scene, p); },
      [&](DrawnSession) { ++done; }, [&] { ++given_up; });
  opener->open_scene(path("pair.sonde.json"));
  EXPECT_EQ(given_up, 1);
  ASSERT_EQ(said.size(), 1);
  EXPECT_TRUE(said[0].startsWith("Turning: given up")) << said[0].toStdString();
  ASSERT_TRUE(ends());
  EXPECT_EQ(ready.size(), 1u);
  EXPECT_EQ(done, 0);
}

TEST_F(OpenerTest, what_is_abandoned_ends_in_nothing) {
  int given_up = 0;
  const auto scene = folder / "pair.sonde.json";
  opener->make(
      "Turning", [scene](const Progress& p) { return open_scene(scene, p); },
      [&](DrawnSession) { ADD_FAILURE() << "it was abandoned"; }, [&] { ++given_up; });
  opener->abandon();
  wait(500);  // several times what the bodies take to be read
  EXPECT_EQ(given_up, 0);
  EXPECT_TRUE(failed.isEmpty());
  EXPECT_TRUE(ready.empty());
}

TEST_F(OpenerTest, what_is_made_goes_to_who_asked_and_what_fails_is_given_up) {
  int given_up = 0;
  std::vector<DrawnSession> made;
  const auto scene = folder / "pair.sonde.json";
  const auto take = [&](DrawnSession drawn) { made.push_back(std::move(drawn)); };
  opener->make(
      "Turning", [scene](const Progress& p) { return open_scene(scene, p); }, take,
      [&] { ++given_up; });
  ASSERT_TRUE(wait_until([&] { return !made.empty(); }));
  EXPECT_TRUE(made[0].session);
  EXPECT_TRUE(ready.empty()) << "it is no other document";
  opener->make(
      "Turning", [](const Progress&) -> LoadedScene { throw InputError("a.off: no"); }, take,
      [&] { ++given_up; });
  ASSERT_TRUE(wait_until([this] { return !failed.isEmpty(); }));
  EXPECT_EQ(given_up, 1);
  EXPECT_EQ(failed, QStringList("a.off: no"));
  EXPECT_EQ(made.size(), 1u);
  EXPECT_TRUE(said.isEmpty()) << "nothing took its place";
}

TEST_F(OpenerTest, a_mesh_is_read_to_see_that_it_can_be) {
  int done = 0;
  opener->check_mesh(path("probe.off"), [&] { ++done; });
  ASSERT_TRUE(wait_until([&] { return done == 1; }));
  opener->check_mesh(path("pair.sonde.json"), [&] { ++done; });
  ASSERT_TRUE(wait_until([this] { return !failed.isEmpty(); }));
  EXPECT_EQ(done, 1);
  EXPECT_TRUE(complaints[0].contains("pair.sonde.json"));
}

}  // namespace
}  // namespace sonde::ui::test
