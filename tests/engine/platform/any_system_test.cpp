// SPDX-License-Identifier: GPL-3.0-or-later
// What callers rely on whatever the system: by the sources of this platform, and by the portable
// ones (two programs). The reference is the standard library, and the other of a pair of functions.
#include <gtest/gtest.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "engine/base/error.hpp"
#include "engine/platform/clock.hpp"
#include "engine/platform/end_signals.hpp"
#include "engine/platform/hid_node.hpp"
#include "engine/platform/processor_time.hpp"
#include "engine/platform/read_stream.hpp"
#include "engine/platform/readable_file.hpp"
#include "engine/platform/real_time.hpp"
#include "engine/platform/shared_library.hpp"
#include "engine/platform/wakeful_processors.hpp"
#include "engine/platform/writable_file.hpp"

namespace sonde {
namespace {

namespace fs = std::filesystem;
using Opening = WritableFile::Opening;

/// Removed with the object.
struct Folder {
  fs::path path =
      fs::temp_directory_path() / ("sonde-platform-" + std::to_string(std::random_device()()));
  Folder() { fs::create_directory(path); }
  ~Folder() { fs::remove_all(path); }
};

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return (std::ostringstream() << stream.rdbuf()).str();
}

TEST(AnySystem, a_new_file_is_written_to_its_end_and_never_over_another) {
  const Folder folder;
  const fs::path file = folder.path / "a";
  WritableFile fresh(file, Opening::anew);
  ASSERT_TRUE(fresh.is_open());
  const std::string much(1'000'000, 'x');
  EXPECT_TRUE(fresh.write("one\n") && fresh.write(much) && fresh.sync() && fresh.close());
  EXPECT_EQ(fresh.error(), 0);
  EXPECT_EQ(text_of(file), "one\n" + much);
  const WritableFile again(file, Opening::anew);
  EXPECT_FALSE(again.is_open());
  EXPECT_EQ(again.error(), EEXIST);
}

TEST(AnySystem, what_is_written_is_there_before_the_file_is_closed) {
  const Folder folder;
  WritableFile open(folder.path / "a", Opening::anew);
  EXPECT_TRUE(open.write("one"));
  EXPECT_EQ(text_of(folder.path / "a"), "one");
}

TEST(AnySystem, a_file_grows_at_its_end_and_one_that_is_not_there_does_not) {
  const Folder folder;
  const fs::path file = folder.path / "a";
  std::ofstream(file) << "one";
  {
    WritableFile open(file, Opening::append);
    EXPECT_TRUE(open.write("two"));
  }
  EXPECT_EQ(text_of(file), "onetwo");
  EXPECT_EQ(WritableFile(folder.path / "none/a", Opening::anew).error(), ENOENT);
}

TEST(AnySystem, a_file_that_is_moved_is_closed_once) {
  const Folder folder;
  WritableFile first(folder.path / "a", Opening::anew);
  WritableFile second = std::move(first);
  WritableFile third(folder.path / "b", Opening::anew);
  third = std::move(second);
  EXPECT_TRUE(third.write("one") && third.close());
  EXPECT_FALSE(third.is_open());
  EXPECT_EQ(text_of(folder.path / "a"), "one");
  EXPECT_EQ(text_of(folder.path / "b"), "");
}

TEST(AnySystem, replacing_takes_the_name_in_one_step_and_says_what_is_missing) {
  const Folder folder;
  std::ofstream(folder.path / "new") << "new";
  std::ofstream(folder.path / "old") << "old";
  EXPECT_EQ(replace_file(folder.path / "new", folder.path / "old"), 0);
  EXPECT_EQ(text_of(folder.path / "old"), "new");
  EXPECT_FALSE(fs::exists(folder.path / "new"));
  EXPECT_EQ(replace_file(folder.path / "none", folder.path / "old"), ENOENT);
  EXPECT_EQ(may_write(folder.path), 0);
  EXPECT_EQ(may_write(folder.path / "old"), 0);
  EXPECT_EQ(may_write(folder.path / "none"), ENOENT);
}

TEST(AnySystem, a_file_is_read_at_any_place_whatever_becomes_of_its_name) {
  const Folder folder;
  const fs::path file = folder.path / "a";
  std::ofstream(file, std::ios::binary) << "0123456789";
  const ReadableFile open(file);
  fs::remove(file);
  EXPECT_EQ(open.size(), 10u);
  EXPECT_EQ(open.read(7, 100), "789");
  EXPECT_EQ(open.read(2, 3), "234");
  EXPECT_EQ(open.read(10, 3), "");
  EXPECT_EQ(open.read(1000, 3), "");
  EXPECT_EQ(open.read(0, 10), "0123456789");
#ifndef _WIN32  // where the name goes once nobody holds the file
  EXPECT_THROW(ReadableFile{file}, InputError);
#endif
  EXPECT_THROW(ReadableFile{folder.path}, InputError);
}

// A space, letters of one byte in some code pages, of three bytes in UTF-8, and of two units of 16
// bits; bytes that a text stream may change.
TEST(AnySystem, names_are_utf8_and_bytes_stay_as_they_are) {
  const Folder folder;
  const fs::path file = folder.path / "a b \u00e9\u6df1\u3055\U0001d6fc.csv";
  const std::string bytes("one\r\ntwo\n\x1a\0three\n", 17);
  WritableFile fresh(file, Opening::anew);
  EXPECT_TRUE(fresh.write(bytes) && fresh.close());
  EXPECT_EQ(may_write(file), 0);
  EXPECT_EQ(ReadableFile(file).read(0, 100), bytes);
  const ReadStream stream = open_to_read(file);
  ASSERT_TRUE(stream);
  std::string read(100, 'x');
  read.resize(std::fread(read.data(), 1, read.size(), stream.get()));
  EXPECT_EQ(read, bytes);
  EXPECT_EQ(fs::directory_iterator(folder.path)->path().filename().string(),
            "a b \u00e9\u6df1\u3055\U0001d6fc.csv");
}

// Lone halves of characters, forms that are too long, bytes that begin none; the references are the
// tables of Unicode 15, 3.9.
TEST(AnySystem, a_name_is_kept_or_refused_whole) {
  for (const char* name : {"plain", "\u00ff", "\u0100", "\u07ff", "\u0800", "\ud7ff", "\uffff",
                           "\U00010000", "\U0010ffff", "x\U0001f600y\u00e9"})
    EXPECT_EQ(fs::path(name).string(), name);
#ifdef _WIN32
  for (const char* name : {"\xc3", "\xc0\x80", "\xe0\x80\x80", "\xed\xa0\x80", "\xf0\x80\x80\x80",
                           "\xf4\x90\x80\x80", "\xff", "\x80", "a\xe6\xb7"})
    EXPECT_THROW(fs::path{name}, std::exception) << name;
#endif
}

TEST(AnySystem, what_cannot_be_opened_to_be_read_says_why) {
  const Folder folder;
  errno = 0;
  EXPECT_FALSE(open_to_read(folder.path / "none"));
  EXPECT_EQ(errno, ENOENT);
}

// Windows refuses.
TEST(AnySystem, a_file_that_is_read_is_replaced_or_stays) {
  const Folder folder;
  std::ofstream(folder.path / "new") << "new";
  std::ofstream(folder.path / "old") << "old";
  const ReadableFile open(folder.path / "old");
  const int error = replace_file(folder.path / "new", folder.path / "old");
#ifdef _WIN32
  EXPECT_EQ(error, EACCES);
#else
  EXPECT_EQ(error, 0);
#endif
  EXPECT_EQ(open.read(0, 10), "old");
  EXPECT_EQ(text_of(folder.path / "old"), error == 0 ? "new" : "old");
}

TEST(AnySystem, what_is_cut_off_is_gone_and_writing_goes_on_there) {
  const Folder folder;
  WritableFile open(folder.path / "a", Opening::anew);
  EXPECT_TRUE(open.write("0123456789"));
#ifdef SONDE_PORTABLE_SOURCES  // the standard library alone cannot
  EXPECT_FALSE(open.truncate(3));
  EXPECT_EQ(text_of(folder.path / "a"), "0123456789");
#else
  EXPECT_TRUE(open.truncate(3) && open.write("x") && open.close());
  EXPECT_EQ(text_of(folder.path / "a"), "012x");
#endif
}

TEST(AnySystem, a_file_that_is_held_is_not_to_be_held_again_and_still_read) {
  const Folder folder;
  WritableFile first(folder.path / "a", Opening::anew);
  EXPECT_TRUE(first.write("one") && first.lock());
  WritableFile second(folder.path / "a", Opening::append);
  ASSERT_TRUE(second.is_open());
#ifndef SONDE_PORTABLE_SOURCES
  EXPECT_FALSE(second.lock());
#endif
  EXPECT_EQ(text_of(folder.path / "a"), "one");
  first.close();
  EXPECT_TRUE(second.lock());
}

TEST(AnySystem, the_clock_goes_on_and_a_sleep_ends_no_sooner_than_asked) {
  const std::int64_t begin = monotonic_ns();
  const auto by_library = std::chrono::steady_clock::now();
  sleep_until_ns(begin + 3'000'000);
  const std::int64_t end = monotonic_ns();
  const auto passed = std::chrono::steady_clock::now() - by_library;
  EXPECT_GE(end, begin + 3'000'000);
  EXPECT_GE(passed, std::chrono::milliseconds(3));
  sleep_until_ns(begin);  // past: at once
}

TEST(AnySystem, processor_time_does_not_fall) {
  double last = processor_time_us();
  for (int i = 0; i < 1000; ++i) {
    const double now = processor_time_us();
    EXPECT_GE(now, last);
    last = now;
  }
}

std::atomic<int> told{0};
extern "C" void count(int) { ++told; }

TEST(AnySystem, a_signal_to_end_calls_the_handler_every_time) {
  on_end_signal(count, HandledSignals::all);
  told = 0;
  std::raise(SIGTERM);
  std::raise(SIGTERM);
  std::raise(SIGINT);
  EXPECT_EQ(told, 3);
  std::signal(SIGTERM, SIG_DFL);
  std::signal(SIGINT, SIG_DFL);
}

TEST(AnySystem, or_the_first_time_alone) {
  on_end_signal(count, HandledSignals::first);
  told = 0;
  std::raise(SIGTERM);
  EXPECT_EQ(told, 1);
  EXPECT_EQ(std::signal(SIGTERM, SIG_DFL), SIG_DFL);
  std::signal(SIGINT, SIG_DFL);
}

TEST(AnySystem, what_is_not_to_be_had_says_so) {
  try {
    SharedLibrary("/no/such/library");
    FAIL() << "it was loaded";
  } catch (const InputError& error) {
    const bool none = std::string(error.what()).find("supports no makers'") != std::string::npos;
    EXPECT_EQ(loads_shared_libraries(), !none) << error.what();
  }
  EXPECT_TRUE(hid_report_descriptor("/no/such/node").empty());
  EXPECT_EQ(hid_port("/no/such/node"), "");
  EXPECT_STRNE(request_processor(LoopThread::servo), "");
  EXPECT_STREQ(WakefulProcessors(false).words(), "");
  const WakefulProcessors wanted(true, "/no/such/file");
  EXPECT_FALSE(wanted.granted());
  EXPECT_STRNE(wanted.words(), "");
  EXPECT_EQ(process_number(), process_number());
}

// Ten processors of which a process may use those.
TEST(AnySystem, the_loop_has_processors_of_its_own_where_there_are_more_than_two) {
  constexpr int allowed[] = {1, 4, 9};
  EXPECT_EQ(processor_for(LoopThread::servo, allowed, 3), 9);
  EXPECT_EQ(processor_for(LoopThread::geometry, allowed, 3), 4);
  EXPECT_EQ(processor_for(LoopThread::servo, allowed, 2), -1);
}

}  // namespace
}  // namespace sonde
