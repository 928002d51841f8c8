// SPDX-License-Identifier: GPL-3.0-or-later
// The references: the C library's own arguments, and the name that it keeps of the program.
#include "engine/platform/program.hpp"

#include <errno.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sonde {
namespace {

TEST(Program, has_its_arguments_without_its_name) {
  const char* const given[] = {"sonde", "query", "a b", "\u6df1", ""};
  EXPECT_THAT(begin_program(5, given), testing::ElementsAre("query", "a b", "\u6df1", ""));
  EXPECT_THAT(begin_program(1, given), testing::IsEmpty());
  EXPECT_THAT(begin_program(0, given), testing::IsEmpty());
}

TEST(Program, knows_its_own_file) {
  EXPECT_EQ(program_file().filename().string(), program_invocation_short_name);
  EXPECT_TRUE(std::filesystem::is_regular_file(program_file()));
}

}  // namespace
}  // namespace sonde
