// SPDX-License-Identifier: GPL-3.0-or-later
// What is open when the program is killed is offered by the next one: with a real process.

#include "ui/document/recovery.hpp"

#include <gtest/gtest.h>
#include <signal.h>

#include <QProcess>

#include "engine/base/error.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/actions/document_control.hpp"

namespace sonde::ui::test {
namespace {

Recovered sample(const std::filesystem::path& folder) {
  Recovered one;
  one.scene.file = folder / "a b.sonde.json";
  one.scene.name = "a b";
  one.scene.unit = 1e-3;
  one.scene.probe.mesh = folder / "x.off";
  one.scene.fixed.mesh = "/y.off";
  one.scene.coupling.k = 123.456;
  one.saved_text = "what the file holds";
  one.here = {Quat(0.6, 0, 0.8, 0), Vec3(0.1, 0.2, 0.3)};
  one.camera = CameraPlace{Vec3(1, 2, 3), Vec3(0, 0, 0.1), Vec3(0, 0, 1)};
  one.when = QDateTime::fromString("2026-01-02T03:04:05", Qt::ISODate);
  return one;
}

TEST(Recovery, its_file_reads_the_same_again) {
  const sonde::test::TempFolder folder;
  const Recovered one = sample(folder.path());
  const Recovered back = recovered_from(folder.write("r.json", recovery_text(one)));
  EXPECT_EQ(recovery_text(back), recovery_text(one));
  EXPECT_EQ(back.scene.file, one.scene.file);
  EXPECT_EQ(back.scene.probe.mesh, one.scene.probe.mesh);
  EXPECT_EQ(back.here.p, one.here.p);
  EXPECT_EQ(back.camera->position, one.camera->position);
}

TEST(Recovery, a_file_that_is_none_is_named) {
  const sonde::test::TempFolder folder;
  for (const char* text : {"", "{}", "{\"version\": 99}", "rubbish"}) {
    try {
      recovered_from(folder.write("r.json", text));
      ADD_FAILURE() << "taken: " << text;
    } catch (const InputError& bad) {
      EXPECT_NE(std::string(bad.what()).find("r.json"), std::string::npos) << bad.what();
    }
  }
}

TEST(Recovery, one_that_lives_keeps_its_file_to_itself) {
  need_application();
  const sonde::test::TempFolder folder;
  {
    Recovery alive(folder.path());
    ASSERT_TRUE(alive.keep(sample(folder.path())));
    EXPECT_TRUE(Recovery(folder.path()).left_over().empty());
  }
  EXPECT_EQ(folder.file_count(), 0u) << "who ends as it should leaves nothing";
}

class KilledTest : public WindowTest {
 protected:
  /// A sonde-view that has a gain other than the scene's to lose is not to be had from outside: it
  /// plays the scene's path, so that the probe is elsewhere.
  void run_and_kill(const std::filesystem::path& recoveries) {
    QProcess program;
    program.setProcessChannelMode(QProcess::MergedChannels);
    program.start(QStringLiteral(SONDE_VIEW_PROGRAM),
                  {QStringLiteral(SONDE_RESOURCES "/scenes/linked-tori.sonde.json"),
                   QStringLiteral("--device"), QStringLiteral("path")});
    ASSERT_TRUE(program.waitForStarted());
    const bool kept = wait_until([&] {
      std::error_code none;
      for (const auto& entry : std::filesystem::directory_iterator(recoveries, none))
        if (entry.path().extension() == ".json" && entry.path().filename().string()[0] != '.')
          return true;
      return false;
    });
    EXPECT_TRUE(kept) << program.readAll().toStdString();
    ::kill(static_cast<pid_t>(program.processId()), SIGKILL);
    program.waitForFinished();
  }
};

TEST_F(KilledTest, the_next_one_offers_it_and_takes_it_up) {
  const std::filesystem::path data = folder / "data/sonde/sonde-view/recovery";
  run_and_kill(data);
  ASSERT_FALSE(HasFatalFailure());
  Recovery next(data);
  const auto left = next.left_over();
  ASSERT_EQ(left.size(), 1u);
  const Recovered found = recovered_from(left[0]);
  EXPECT_EQ(found.scene.name, "linked-tori");
  EXPECT_TRUE(found.camera);

  // The window of the tests has a name and a folder of its own.
  std::filesystem::create_directories(recovery_folder());
  std::filesystem::rename(left[0], recovery_folder() / "left.json");
  QString offered;
  window->prompts().ask_recover = [&](const QString& what) {
    offered = what;
    return Recovering::later;
  };
  EXPECT_FALSE(window->documents().offer_recovery());
  EXPECT_TRUE(offered.startsWith("linked-tori")) << offered.toStdString();
  window->prompts().ask_recover = [](const QString&) { return Recovering::open; };
  EXPECT_TRUE(window->documents().offer_recovery());
  ASSERT_TRUE(wait_until([this] { return opened == 1 && window->shown(); }));
  EXPECT_LT((window->session()->device_pose().p - found.here.p).norm(), 1e-12);
  EXPECT_LT((window->viewport().place().position - found.camera->position).norm(), 1e-9);
  EXPECT_FALSE(std::filesystem::exists(recovery_folder() / "left.json"));
  EXPECT_FALSE(window->documents().offer_recovery()) << "once";
}

TEST_F(KilledTest, a_change_of_gains_is_kept_within_seconds_and_gone_when_saved) {
  open_cubes();
  Content changed = window->documents().document().content();
  changed.scene.coupling.k = 777;
  window->documents().document().change("k", changed);
  const auto files = [] {
    std::vector<std::filesystem::path> found;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(recovery_folder(), none))
      if (entry.path().extension() == ".json" && entry.path().filename().string()[0] != '.')
        found.push_back(entry.path());
    return found;
  };
  ASSERT_TRUE(wait_until([&] { return files().size() == 1; }));
  const Recovered found = recovered_from(files()[0]);
  EXPECT_EQ(found.scene.coupling.k, 777);
  EXPECT_NE(found.saved_text, "");
  ASSERT_TRUE(window->documents().save());
  EXPECT_TRUE(files().empty());
}

}  // namespace
}  // namespace sonde::ui::test
