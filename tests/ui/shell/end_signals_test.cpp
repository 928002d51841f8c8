// SPDX-License-Identifier: GPL-3.0-or-later
// The real sonde-view is told to end, as by Ctrl-C or by whoever shuts the machine down.

#include "ui/shell/end_signals.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <string.h>

#include <QProcess>

#include "tests/ui/window_fixture.hpp"
#include "ui/document/recovery.hpp"

namespace sonde::ui::test {
namespace {

using testing::HasSubstr;

class ToldToEnd : public ::testing::Test {
 protected:
  /// The copies that are kept in case the program does not come to save them.
  std::vector<std::filesystem::path> copies() const {
    std::vector<std::filesystem::path> found;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(recoveries, none))
      if (entry.path().extension() == ".json" && !entry.path().filename().string().starts_with('.'))
        found.push_back(entry.path());
    return found;
  }

  /// Started with the path of a scene leading the probe, so that there is something to lose.
  void start() {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("XDG_CONFIG_HOME", QString::fromStdString(folder.path().string()));
    environment.insert("XDG_DATA_HOME", QString::fromStdString((folder / "data").string()));
    program.setProcessEnvironment(environment);
    program.start(QStringLiteral(SONDE_VIEW_PROGRAM),
                  {QStringLiteral(SONDE_RESOURCES "/scenes/linked-tori.sonde.json"),
                   QStringLiteral("--device"), QStringLiteral("path")});
    ASSERT_TRUE(program.waitForStarted());
    ASSERT_TRUE(wait_until([this] { return !copies().empty(); }))
        << program.readAllStandardError().toStdString();
  }

  void SetUp() override { need_application(); }

  sonde::test::TempFolder folder;
  std::filesystem::path recoveries = folder / "data/sonde/sonde-view/recovery";
  QProcess program;
};

TEST_F(ToldToEnd, it_ends_as_it_should_and_the_next_one_offers_what_was_not_saved) {
  for (const int signal : {SIGTERM, SIGINT}) {
    start();
    ASSERT_FALSE(HasFatalFailure());
    ::kill(static_cast<pid_t>(program.processId()), signal);
    ASSERT_TRUE(program.waitForFinished(patience_ms)) << strsignal(signal);
    EXPECT_EQ(program.exitStatus(), QProcess::NormalExit) << strsignal(signal);
    EXPECT_EQ(program.exitCode(), 130) << strsignal(signal);
    EXPECT_THAT(program.readAllStandardError().toStdString(), HasSubstr("the loop has ended"))
        << strsignal(signal);
    const auto left = Recovery(recoveries).left_over();
    ASSERT_EQ(left.size(), 1u) << strsignal(signal);
    EXPECT_EQ(recovered_from(left[0]).scene.name, "linked-tori");
    std::filesystem::remove_all(recoveries);
  }
}

TEST_F(ToldToEnd, two_windows_on_one_scene_keep_a_copy_each) {
  start();
  ASSERT_FALSE(HasFatalFailure());
  QProcess second;
  second.setProcessEnvironment(program.processEnvironment());
  second.start(program.program(), program.arguments());
  ASSERT_TRUE(second.waitForStarted());
  EXPECT_TRUE(wait_until([this] { return copies().size() == 2; }));
  EXPECT_TRUE(Recovery(recoveries).left_over().empty()) << "both live";
  for (QProcess* one : {&program, &second}) {
    ::kill(static_cast<pid_t>(one->processId()), SIGTERM);
    EXPECT_TRUE(one->waitForFinished(patience_ms));
    EXPECT_EQ(one->exitCode(), 130);
  }
  EXPECT_EQ(Recovery(recoveries).left_over().size(), 2u);
}

}  // namespace
}  // namespace sonde::ui::test
