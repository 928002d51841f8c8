// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/text/output_file.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
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

/// What a child process says of a task: it may have no rights, where this one has all.
template <class Task>
int exit_code_of(const Task& task) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(task());
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// As a user that owns nothing but this folder.
int permission_is_lost(const TempFolder& folder) {
  constexpr uid_t nobody = 65534;
  if (::geteuid() == 0 &&
      (::chown(folder.path().c_str(), nobody, nobody) != 0 ||
       ::setresgid(nobody, nobody, nobody) != 0 || ::setresuid(nobody, nobody, nobody) != 0))
    return 2;
  const auto file = folder.write("r.csv", "old");
  PendingFile pending(file, "new");
  ::chmod(folder.path().c_str(), 0500);
  try {
    pending.commit();
  } catch (const InputError& error) {
    const bool said = std::string(error.what()).ends_with("cannot be written: Permission denied");
    ::chmod(folder.path().c_str(), 0700);
    return said && text_of(file) == "old" ? 0 : 3;
  }
  return 4;
}

TEST(OutputFile, a_permission_that_is_lost_on_the_way_leaves_what_was_there) {
  const TempFolder folder;
  EXPECT_EQ(exit_code_of([&] { return permission_is_lost(folder); }), 0);
  EXPECT_EQ(folder.file_count(), 1u);
}

/// The process writes its letter again and again, until it is killed.
pid_t writer_of(const std::filesystem::path& file, char letter, std::size_t length) {
  const pid_t child = ::fork();
  if (child == 0)
    for (;;) write_whole(file, std::string(length, letter));
  return child;
}

bool whole(const std::string& text, std::size_t length) {
  return text.size() == length && text.find_first_not_of(text[0]) == std::string::npos;
}

TEST(OutputFile, killed_while_it_is_written_the_file_is_the_old_one_or_the_new) {
  constexpr std::size_t length = 3'000'000;
  const TempFolder folder;
  const auto file = folder.write("r.csv", std::string(length, 'o'));
  for (int i = 0; i < 20; ++i) {
    const pid_t child = writer_of(file, static_cast<char>('a' + i), length);
    ::usleep(static_cast<useconds_t>(1000 + 1700 * i));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    EXPECT_TRUE(whole(text_of(file), length)) << i;
  }
}

TEST(OutputFile, of_two_processes_on_one_file_one_has_the_last_word) {
  constexpr std::size_t length = 300'000;
  const TempFolder folder;
  const auto file = folder.write("r.csv", std::string(length, 'o'));
  const std::array children{writer_of(file, 'a', length), writer_of(file, 'b', length)};
  for (int i = 0; i < 200; ++i) ASSERT_TRUE(whole(text_of(file), length)) << i;
  for (const pid_t child : children) {
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
  }
  EXPECT_TRUE(whole(text_of(file), length));
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
