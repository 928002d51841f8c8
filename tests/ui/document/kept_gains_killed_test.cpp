// SPDX-License-Identifier: GPL-3.0-or-later
// A window in a process of its own is killed: what was typed there is there in the next one.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QProcess>
#include <csignal>

#include "tests/ui/window_fixture.hpp"
#include "ui/document/kept_gains.hpp"

namespace sonde::ui::test {
namespace {

constexpr const char* home = "SONDE_TEST_HOME";  // of both processes

class KilledGains : public WindowTest {
 protected:
  /// The file of the scene that is open, held by the mouse.
  static std::filesystem::path kept(const std::filesystem::path& home_folder) {
    std::error_code none;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(home_folder, none))
      if (entry.path().parent_path().filename() == "gains" && entry.path().extension() == ".json" &&
          entry.path().filename().string()[0] != '.')
        return entry.path();
    return {};
  }
};

/// The process that is killed, started by the test below alone.
TEST_F(KilledGains, DISABLED_child) {
  ASSERT_TRUE(qEnvironmentVariableIsSet(home));
  const std::string folder_of_both = qgetenv(home).toStdString();
  keep_settings_in(folder_of_both);
  open({QString::fromStdString(folder_of_both + "/cubes.sonde.json")});
  type("k_value", "800");
  wait(2 * patience_ms);
}

TEST_F(KilledGains, a_typed_stiffness_is_there_again_after_kill_9) {
  QProcess other;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert(home, QString::fromStdString(folder.path().string()));
  other.setProcessEnvironment(environment);
  other.setProcessChannelMode(QProcess::MergedChannels);
  other.start(QCoreApplication::applicationFilePath(),
              {QStringLiteral("--gtest_filter=KilledGains.DISABLED_child"),
               QStringLiteral("--gtest_also_run_disabled_tests")});
  ASSERT_TRUE(other.waitForStarted());
  const bool written = wait_until([this] { return !kept(folder.path()).empty(); });
  ::kill(static_cast<pid_t>(other.processId()), SIGKILL);
  other.waitForFinished();
  ASSERT_TRUE(written) << other.readAll().toStdString();
  EXPECT_EQ(other.exitStatus(), QProcess::CrashExit);
  open_cubes();
  EXPECT_EQ(window->session()->coupling().k, 800);
}

}  // namespace
}  // namespace sonde::ui::test
