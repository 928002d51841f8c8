// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/text/output_file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

#include "engine/base/error.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde {
namespace {

using test::TempFolder;
using test::text_of;

TEST(OutputFile, it_is_written_and_replaced_and_nothing_else_is_left) {
  const TempFolder folder;
  const auto file = folder / "r.csv";
  write_whole(file, "one");
  EXPECT_EQ(text_of(file), "one");
  write_whole(file, std::string(1000000, 'x'));
  EXPECT_EQ(text_of(file).size(), 1000000u);
  write_whole(file, "");
  EXPECT_EQ(text_of(file), "");
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(OutputFile, a_folder_that_is_not_there_is_an_error) {
  const TempFolder folder;
  EXPECT_THROW(check_writable(folder / "none/r.csv"), InputError);
  EXPECT_THROW(write_whole(folder / "none/r.csv", "x"), InputError);
  EXPECT_THROW(write_whole(folder.path(), "x"), InputError) << "a folder";
  EXPECT_EQ(folder.file_count(), 0u);
}

TEST(OutputFile, check_writable_leaves_everything_as_it_is) {
  const TempFolder folder;
  check_writable(folder / "r.csv");
  EXPECT_EQ(folder.file_count(), 0u);
}

TEST(OutputFile, a_failure_halfway_leaves_what_was_there) {
  const TempFolder folder;
  const auto file = folder.write("r.csv", "old");
  rlimit before = {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small = {1000, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  EXPECT_THROW(write_whole(file, std::string(100000, 'x')), InputError);
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(text_of(file), "old");
  EXPECT_EQ(folder.file_count(), 1u) << "a temporary file is left";
}

TEST(OutputFile, a_full_device_is_an_error) {
  EXPECT_THROW(write_whole("/dev/full", "x"), InputError);
  write_whole("/dev/null", "x");
}

TEST(OutputFile, a_symbolic_link_stays_one) {
  const TempFolder folder;
  const auto target = folder.write("target", "old");
  std::filesystem::create_symlink(target, folder / "link");
  write_whole(folder / "link", "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_EQ(text_of(target), "new");
}

}  // namespace
}  // namespace sonde
