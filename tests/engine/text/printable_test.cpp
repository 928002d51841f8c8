// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/text/printable.hpp"

#include <gtest/gtest.h>

namespace sonde {
namespace {

TEST(Printable, letters_of_any_script_stay) {
  for (const char* text : {"", "a b.off", "Körper Ä.ply", "プローブ", "\xff\xfe"})
    EXPECT_EQ(printable(text), text);
}

TEST(Printable, what_a_terminal_would_obey_is_written_out) {
  EXPECT_EQ(printable("\x1b[2Jcup\n.off"), "\\x1b[2Jcup\\x0a.off");
  EXPECT_EQ(printable("\x7f\t"), "\\x7f\\x09");
  EXPECT_EQ(printable(std::string_view("\0", 1)), "\\x00");
}

TEST(Printable, of_bytes_only_what_is_typed_as_it_is_stays) {
  EXPECT_EQ(typeable("solid ~"), "solid ~");
  EXPECT_EQ(typeable(std::string_view("a\0\xff\x7f", 4)), "a\\x00\\xff\\x7f");
}

// Reference: table 3-7 of the Unicode standard, for what is no character: a byte of Latin-1, one
// that only goes on, one cut short, overlong ones, a surrogate, what is beyond U+10FFFF.
TEST(Printable, bytes_that_are_no_utf8_are_written_out) {
  for (const char* text :
       {"", "a b.off", "K\u00f6rper \u00c4.ply", "\u30d7", "\U0001f600\U0010ffff"})
    EXPECT_EQ(utf8_text(text), text);
  EXPECT_EQ(utf8_text("\xe4.off"), "\\xe4.off");
  EXPECT_EQ(utf8_text("\x80g\xc3"), "\\x80g\\xc3");
  EXPECT_EQ(utf8_text("\xe3\x83 \xf0\x9f\x98"), "\\xe3\\x83 \\xf0\\x9f\\x98");
  EXPECT_EQ(utf8_text("\xc0\xaf\xe0\x80\xaf"), "\\xc0\\xaf\\xe0\\x80\\xaf");
  EXPECT_EQ(utf8_text("\xed\xa0\x80\xf4\x90\x80\x80"), "\\xed\\xa0\\x80\\xf4\\x90\\x80\\x80");
}

/// U+009B begins a sequence as ESC [ does; U+00A0 is a space, and U+011B ends in a byte as C1 has.
TEST(Printable, so_are_those_of_two_bytes) {
  EXPECT_EQ(printable("\xc2\x9b"
                      "2J"),
            "\\x9b2J");
  EXPECT_EQ(printable("\xc2\xa0\xc4\x9b"), "\xc2\xa0\xc4\x9b");
}

}  // namespace
}  // namespace sonde
