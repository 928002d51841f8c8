// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/terminal.hpp"

#include <gtest/gtest.h>

#include <string>

namespace sonde::ui::test {
namespace {

/// What a terminal gets to see.
std::string told_of(std::string_view text) {
  testing::internal::CaptureStderr();
  tell_terminal(text);
  return testing::internal::GetCapturedStderr();
}

TEST(Terminal, gets_one_line_behind_the_programs_name) {
  EXPECT_EQ(told_of("cup.off: it is empty"), "sonde-view: cup.off: it is empty\n");
  EXPECT_EQ(told_of(""), "sonde-view: \n");
}

TEST(Terminal, is_told_nothing_that_it_would_obey) {
  EXPECT_EQ(told_of("\x1b]0;title\x07 a\nb\r\x7f"),
            "sonde-view: \\x1b]0;title\\x07 a\\x0ab\\x0d\\x7f\n");
  EXPECT_EQ(told_of("100 %s of 5 µm"), "sonde-view: 100 %s of 5 µm\n") << "no format either";
}

}  // namespace
}  // namespace sonde::ui::test
