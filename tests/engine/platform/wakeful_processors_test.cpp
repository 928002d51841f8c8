// SPDX-License-Identifier: GPL-3.0-or-later
// A file stands in for the system's, which only root may open. The reference is its kernel manual:
// what is written is a 32-bit number of microseconds, in force while the file is open.
#include "engine/platform/wakeful_processors.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <string>

#include "tests/support/temp_folder.hpp"

namespace sonde {
namespace {

/// Files that this process has open.
int files_open() {
  int count = 0;
  for (int i = 0; i < 256; ++i) count += fcntl(i, F_GETFD) != -1;
  return count;
}

TEST(WakefulProcessors, holds_zero_microseconds_while_it_lives) {
  const test::TempFolder folder;
  const std::string file = folder.write("latency", "").string();
  const int before = files_open();
  {
    const WakefulProcessors awake(true, file.c_str());
    EXPECT_TRUE(awake.granted());
    EXPECT_STREQ(awake.words(), "processors stay awake");
    EXPECT_EQ(test::text_of(file), std::string(4, '\0'));
    EXPECT_EQ(files_open(), before + 1);
  }
  EXPECT_EQ(files_open(), before);
}

TEST(WakefulProcessors, says_why_not) {
  const test::TempFolder folder;
  const WakefulProcessors missing(true, (folder / "none").c_str());
  EXPECT_FALSE(missing.granted());
  EXPECT_NE(std::string(missing.words()).find("no /dev/cpu_dma_latency"), std::string::npos);
  const WakefulProcessors full(true, "/dev/full");
  EXPECT_FALSE(full.granted());
  EXPECT_NE(std::string(full.words()).find("refused"), std::string::npos);
}

TEST(WakefulProcessors, not_wanted_it_opens_nothing) {
  const int before = files_open();
  const WakefulProcessors none(false);
  EXPECT_EQ(files_open(), before);
  EXPECT_STREQ(none.words(), "");
}

}  // namespace
}  // namespace sonde
