// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/new_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "engine/base/error.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde::ui::test {
namespace {

/// What making a folder there complains of; empty where it can be made.
std::string complaint_about(const std::filesystem::path& folder) {
  try {
    const NewFolder made(folder);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(NewFolderTest, appears_with_all_that_it_holds_when_it_is_finished) {
  const sonde::test::TempFolder home;
  NewFolder made(home / "frames");
  std::ofstream(made.path() / "0001.png") << "one";
  std::filesystem::create_directory(made.path() / "more");
  EXPECT_FALSE(std::filesystem::exists(home / "frames"));
  EXPECT_EQ(made.path().parent_path(), home.path()) << "on the same disk";
  made.commit();
  EXPECT_EQ(sonde::test::text_of(home / "frames" / "0001.png"), "one");
  EXPECT_TRUE(std::filesystem::is_directory(home / "frames" / "more"));
  EXPECT_EQ(home.file_count(), 1u);
}

TEST(NewFolderTest, stays_after_its_maker_is_gone) {
  const sonde::test::TempFolder home;
  {
    NewFolder made(home / "frames");
    made.commit();
  }
  EXPECT_TRUE(std::filesystem::is_directory(home / "frames"));
}

TEST(NewFolderTest, given_up_leaves_nothing_of_it) {
  const sonde::test::TempFolder home;
  {
    const NewFolder made(home / "frames");
    std::filesystem::create_directories(made.path() / "a" / "b");
    std::ofstream(made.path() / "a" / "b" / "c") << "text";
  }
  EXPECT_EQ(home.file_count(), 0u);
}

TEST(NewFolderTest, takes_the_place_of_nothing) {
  const sonde::test::TempFolder home;
  std::filesystem::create_directory(home / "frames");
  home.write("frames/mine", "text");
  home.write("file", "text");
  for (const char* name : {"frames", "frames/", "file"})
    EXPECT_THAT(complaint_about(home.path() / name), testing::HasSubstr("it is there already"))
        << name;
  EXPECT_EQ(sonde::test::text_of(home / "frames/mine"), "text");
  EXPECT_EQ(home.file_count(), 2u) << "nothing was left behind";
}

/// Somebody else has made it in the meantime.
TEST(NewFolderTest, that_cannot_get_its_name_is_named_and_leaves_nothing) {
  const sonde::test::TempFolder home;
  {
    NewFolder made(home / "frames");
    std::filesystem::create_directory(home / "frames");
    home.write("frames/theirs", "text");
    try {
      made.commit();
      FAIL() << "it took the place of another";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::StartsWith((home / "frames").string() + ":"));
    }
  }
  EXPECT_EQ(sonde::test::text_of(home / "frames/theirs"), "text");
  EXPECT_EQ(home.file_count(), 1u);
}

TEST(NewFolderTest, is_refused_by_its_name_where_none_can_be_made) {
  const sonde::test::TempFolder home;
  home.write("file", "text");
  for (const char* name : {"nowhere/frames", "file/frames"}) {
    const std::filesystem::path folder = home.path() / name;
    EXPECT_THAT(complaint_about(folder),
                testing::StartsWith(folder.string() + ": cannot be written: "));
  }
}

TEST(NewFolderTest, a_second_one_of_that_name_is_refused_while_the_first_is_filled) {
  const sonde::test::TempFolder home;
  NewFolder first(home / "frames");
  std::ofstream(first.path() / "0001.png") << "one";
  EXPECT_THAT(complaint_about(home / "frames"), testing::HasSubstr("going on"));
  first.commit();
  EXPECT_EQ(sonde::test::text_of(home / "frames" / "0001.png"), "one");
}

/// File systems allow a name of 255 bytes, and what it is filled under has more in it.
TEST(NewFolderTest, may_have_a_name_as_long_as_any) {
  const sonde::test::TempFolder home;
  const std::string name(255, 'n');
  NewFolder made(home / name);
  made.commit();
  EXPECT_TRUE(std::filesystem::is_directory(home / name));
}

TEST(NewFolderTest, a_slash_at_the_end_changes_nothing) {
  const sonde::test::TempFolder home;
  NewFolder made(home.path() / "frames/");
  made.commit();
  EXPECT_TRUE(std::filesystem::is_directory(home / "frames"));
  EXPECT_EQ(home.file_count(), 1u);
}

}  // namespace
}  // namespace sonde::ui::test
