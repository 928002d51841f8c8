// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/export_menu.hpp"

#include <gtest/gtest.h>

#include <QAction>
#include <map>
#include <string>

#include "tests/ui/window_fixture.hpp"
#include "ui/actions/export_control.hpp"
#include "ui/actions/history_control.hpp"

namespace sonde::ui::test {
namespace {

constexpr const char* exports[] = {
    "export_picture", "export_animation",        "export_tables",
    "export_vtk",     "export_series",           "export_recording_pictures",
    "export_gltf",    "export_recording_tables", "export_recording_series"};

/// A window whose questions about exports are written down, and given up.
class ExportMenuTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (HasFatalFailure()) return;
    window->exporter().ask_file = [this](const QString& title, const QString& name,
                                         const QString&) {
      asked += (title + '|' + name + ' ').toStdString();
      return QString();
    };
    window->exporter().ask_picture = [this](ExportDialog::Of of) {
      asked += "of " + std::to_string(static_cast<int>(of)) + ' ';
      return std::optional(PictureWanted{});
    };
  }
  std::string asked;
};

TEST_F(ExportMenuTest, each_command_asks_for_its_own) {
  open_cubes();
  ASSERT_TRUE(wait_until([this] {
    const auto ticks = window->history().ticks_on_show();
    return ticks && ticks->last > ticks->first;
  }));
  window->set_paused(true);
  std::map<std::string, std::string> questions;
  for (const char* name : exports) {
    asked.clear();
    act(name);
    EXPECT_FALSE(asked.empty()) << name;
    for (const auto& [other, question] : questions)
      EXPECT_NE(asked, question) << name << " asks as " << other;
    questions[name] = asked;
  }
  EXPECT_NE(questions["export_tables"].find(".csv"), std::string::npos);
  EXPECT_NE(questions["export_gltf"].find(".gltf"), std::string::npos);
  EXPECT_NE(questions["export_picture"].find(".png"), std::string::npos);
  for (const char* name : {"export_vtk", "export_series", "export_recording_series"})
    EXPECT_NE(questions[name].find("ParaView"), std::string::npos) << questions[name];
  for (const char* name : exports)
    if (std::string(name).find("recording") != std::string::npos) {
      EXPECT_NE(questions[name].find("recording"), std::string::npos) << questions[name];
    }
  EXPECT_TRUE(complaints.empty());
  EXPECT_FALSE(window->exporter().busy()) << "an empty name: nothing is written";
}

TEST_F(ExportMenuTest, where_nothing_is_open_nothing_is_asked) {
  for (const char* name : exports) act(name);
  EXPECT_EQ(asked, "");
  EXPECT_TRUE(complaints.empty());
}

TEST_F(ExportMenuTest, a_picture_has_a_key) {
  open_cubes();
  activate();
  key(Qt::Key_E, Qt::ControlModifier);
  EXPECT_NE(asked.find("Export a picture"), std::string::npos) << asked;
}

}  // namespace
}  // namespace sonde::ui::test
