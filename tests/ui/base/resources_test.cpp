// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/resources.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/support/temp_folder.hpp"
#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

/// Another value for a variable of the environment, as long as it lives.
class Variable {
 public:
  Variable(const char* name, const std::filesystem::path& value)
      : name_(name), before_(qgetenv(name)) {
    qputenv(name, QByteArray::fromStdString(value.string()));
  }
  ~Variable() { qputenv(name_, before_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  QByteArray before_;
};

TEST(Resources, are_found_beside_the_program_by_their_whole_path) {
  need_application();
  const std::filesystem::path scenes = resource("scenes").toStdString();
  ASSERT_TRUE(scenes.is_absolute());
  EXPECT_TRUE(std::filesystem::is_directory(scenes));
  EXPECT_EQ(scenes, std::filesystem::canonical(scenes)) << "links are resolved";
  EXPECT_TRUE(std::filesystem::is_regular_file(resource("docs/index.md").toStdString()));
}

TEST(Resources, that_are_not_there_are_empty) {
  need_application();
  EXPECT_EQ(resource("scenes/no-such.sonde.json"), "");
  EXPECT_EQ(resource("no/such/folder"), "");
}

TEST(Resources, profiles_of_the_user_come_before_those_of_the_program) {
  need_application();
  const sonde::test::TempFolder data;
  const Variable home("XDG_DATA_HOME", data.path());
  const std::vector<std::filesystem::path> folders = device_profile_folders();
  ASSERT_EQ(folders.size(), 2u);
  EXPECT_EQ(folders[0], data / "sonde" / "devices");
  EXPECT_EQ(folders[1], resource("devices").toStdString());
  EXPECT_TRUE(std::filesystem::is_directory(folders[1])) << "those came with the program";
}

TEST(Resources, settings_of_devices_are_in_the_users_settings_and_not_in_the_data) {
  need_application();
  const sonde::test::TempFolder data, config;
  const Variable data_home("XDG_DATA_HOME", data.path());
  const Variable config_home("XDG_CONFIG_HOME", config.path());
  EXPECT_EQ(device_settings_folder(), config / "sonde" / "devices");
  EXPECT_FALSE(std::filesystem::exists(config / "sonde")) << "asking makes no folder";
}

}  // namespace
}  // namespace sonde::ui::test
