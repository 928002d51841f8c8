// SPDX-License-Identifier: GPL-3.0-or-later
// Gains that a person typed are there again: after a save, under another name, with another device,
// and where the window's process was killed.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QCoreApplication>
#include <QProcess>
#include <QPushButton>
#include <QTest>
#include <csignal>

#include "tests/ui/window_fixture.hpp"
#include "ui/actions/document_control.hpp"
#include "ui/actions/stiffness_control.hpp"

namespace sonde::ui::test {
namespace {

constexpr const char* home = "SONDE_TEST_HOME";  // of both processes

class GainsInTheWindow : public WindowTest {
 protected:
  void press(const char* button) {
    QTest::mouseClick(window->findChild<QPushButton*>(button), Qt::LeftButton);
  }
  void hold_by(const char* what) {
    auto* sources = window->findChild<QComboBox*>("holder");
    emit sources->activated(sources->findText(what));
  }
  std::unique_ptr<MainWindow> another_window(const std::filesystem::path& file) {
    auto next = std::make_unique<MainWindow>();
    bool there = false;
    QObject::connect(next.get(), &MainWindow::opened, [&] { there = true; });
    next->prompts().report_error = [this](const QString& text) { complaints.push_back(text); };
    next->open({QString::fromStdString(file.string())});
    EXPECT_TRUE(wait_until([&] { return there; }));
    EXPECT_TRUE(complaints.empty()) << complaints[0].toStdString();
    return next;
  }
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

TEST_F(GainsInTheWindow, both_sets_outlive_a_save_and_what_comes_after) {
  open_cubes();
  type("k_value", "800");
  press("gains_b");
  type("k_value", "650");
  ASSERT_TRUE(window->documents().save());
  type("k_value", "700");
  wait(600);
  const auto next = another_window(scene);
  EXPECT_EQ(next->session()->coupling().k, 700);
  EXPECT_EQ(next->stiffness().sets().active(), 1u);
  EXPECT_EQ(next->stiffness().sets().gains(0).k, 800);
}

TEST_F(GainsInTheWindow, saved_under_another_name_they_are_of_that_scene) {
  open_cubes();
  type("k_value", "800");
  wait(600);
  const auto other = folder / "other.sonde.json";
  window->prompts().ask_save = [&](const QString&) {
    return QString::fromStdString(other.string());
  };
  ASSERT_TRUE(window->documents().save_as());
  press("gains_b");
  type("k_value", "900");
  wait(600);
  EXPECT_EQ(another_window(scene)->session()->coupling().k, 800);
  const auto next = another_window(other);
  EXPECT_EQ(next->session()->coupling().k, 900);
  EXPECT_EQ(next->stiffness().sets().gains(0).k, 800);
}

TEST_F(GainsInTheWindow, undo_after_a_change_of_device_goes_the_same_way_back) {
  open_cubes();
  const auto k = [this] { return window->session()->coupling().k; };
  type("k_value", "800");
  hold_by("omega.7 (simulated)");
  type("k_value", "90");
  press("gains_b");
  type("k_value", "70");
  hold_by("Mouse");
  ASSERT_EQ(k(), 800);
  act("undo");
  EXPECT_EQ(k(), 70) << "the exchange of the sets";
  EXPECT_EQ(window->stiffness().sets().active(), 1u);
  act("undo");
  act("undo");
  EXPECT_EQ(k(), 90) << "what B began with, and A";
  EXPECT_EQ(window->stiffness().sets().active(), 0u);
  act("undo");
  EXPECT_EQ(k(), 500) << "changes of one gain that follow each other are one step";
}

/// The process that is killed, started by the test below alone.
TEST_F(GainsInTheWindow, DISABLED_child) {
  ASSERT_TRUE(qEnvironmentVariableIsSet(home));
  const std::string folder_of_both = qgetenv(home).toStdString();
  keep_settings_in(folder_of_both);
  open({QString::fromStdString(folder_of_both + "/cubes.sonde.json")});
  type("k_value", "800");
  wait(patience_ms);
}

TEST_F(GainsInTheWindow, a_typed_stiffness_is_there_again_after_kill_9) {
  QProcess other;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert(home, QString::fromStdString(folder.path().string()));
  other.setProcessEnvironment(environment);
  other.setProcessChannelMode(QProcess::MergedChannels);
  other.start(QCoreApplication::applicationFilePath(),
              {QStringLiteral("--gtest_filter=GainsInTheWindow.DISABLED_child"),
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
