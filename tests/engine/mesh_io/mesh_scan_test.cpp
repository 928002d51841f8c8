// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/mesh_scan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/base/progress.hpp"

namespace sonde {
namespace {

const std::string scanned_file = "made-up.mesh";
const Progress no_progress;

MeshScanner scan_of(std::string_view text, char comment = '#', bool continues = false) {
  return {scanned_file, text, comment, continues, no_progress};
}
/// A scanner on its first line.
MeshScanner first_line_of(std::string_view text) {
  MeshScanner scan = scan_of(text);
  scan.next_line();
  return scan;
}

using Words = std::vector<std::vector<std::string>>;

/// The words of each line, after the line's number.
Words words_of(MeshScanner scan) {
  Words out;
  while (scan.next_line()) {
    out.push_back({std::to_string(scan.line())});
    while (scan.has_word()) out.back().emplace_back(scan.word());
    EXPECT_EQ(scan.word(), "");
  }
  return out;
}

template <class Act>
std::string refusal_by(Act act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(MeshScanner, skips_blank_lines_and_comments_and_counts_them) {
  EXPECT_EQ(words_of(scan_of("a b\n\n  \t\n# no\n c # d\n")), (Words{{"1", "a", "b"}, {"5", "c"}}));
  EXPECT_EQ(words_of(scan_of("a # b", '\0')), (Words{{"1", "a", "#", "b"}}));
  EXPECT_TRUE(words_of(scan_of("")).empty());
  EXPECT_TRUE(words_of(scan_of("\n\n # only")).empty());
}

TEST(MeshScanner, lines_end_as_they_come) {
  const Words wanted{{"1", "a"}, {"2", "b"}, {"4", "c"}};
  EXPECT_EQ(words_of(scan_of("a\nb\n\nc\n")), wanted);
  EXPECT_EQ(words_of(scan_of("a\r\nb\r\n\r\nc")), wanted);
  EXPECT_EQ(words_of(scan_of("a\rb\r\rc\r")), wanted);
  EXPECT_EQ(words_of(scan_of("a\r\r\nb\n\r\nc")), wanted);
}

TEST(MeshScanner, a_backslash_joins_lines_where_it_may) {
  EXPECT_EQ(words_of(scan_of("a \\\n b\nc", '#', true)), (Words{{"1", "a", "b"}, {"3", "c"}}));
  EXPECT_EQ(words_of(scan_of("a \\ \r\n\\\r\nb\nc", '#', true)),
            (Words{{"1", "a", "b"}, {"4", "c"}}));
  EXPECT_EQ(words_of(scan_of("a # \\\nb", '#', true)), (Words{{"1", "a"}, {"2", "b"}}));
  EXPECT_EQ(words_of(scan_of("a \\\nb")), (Words{{"1", "a", "\\"}, {"2", "b"}}));
}

TEST(MeshScanner, knows_what_is_left_and_where_binary_data_begins) {
  MeshScanner scan = scan_of("one two\nrest");
  ASSERT_TRUE(scan.next_line());
  EXPECT_EQ(scan.bytes_in_line(), 7u);
  EXPECT_EQ(scan.word(), "one");
  EXPECT_EQ(scan.bytes_in_line(), 4u);
  EXPECT_EQ(scan.bytes_left(), 4u);
  EXPECT_EQ(scan.position(), 8u);
  EXPECT_EQ(scan.skip_words(), 1u);
  EXPECT_EQ(scan.skip_words(), 0u);
  // After a first line that ends in CR LF so does the last; where it ends in CR alone, a LF is
  // data.
  MeshScanner windows = scan_of("a\r\nb\r\n\nx");
  windows.next_line(), windows.next_line();
  EXPECT_EQ(windows.position(), 6u);
  MeshScanner mac = scan_of("a\rb\r\nx");
  mac.next_line(), mac.next_line();
  EXPECT_EQ(mac.position(), 4u);
}

// Reference: C++'s own literals.
TEST(MeshScanner, numbers_are_those_of_c_with_a_plus_sign_too) {
  EXPECT_EQ(number("1.5"), 1.5);
  EXPECT_EQ(number("+1.5e-3"), 1.5e-3);
  EXPECT_EQ(number("-0.1"), -0.1);
  EXPECT_EQ(number("1e999"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(number("1e-999"), 0);
  EXPECT_EQ(number("1E-999"), 0);
  for (const char* word : {"", "+", "+-1", "1,5", "1.5x", "x", "0x10"}) EXPECT_FALSE(number(word));
}

TEST(MeshScanner, a_point_is_three_finite_coordinates_in_order) {
  MeshScanner scan = first_line_of("1 -2.5 +3e1 4");
  EXPECT_EQ(scan.point(), Vec3(1, -2.5, 30));
  EXPECT_EQ(scan.skip_words(), 1u);
  const auto refused = [](std::string_view text) {
    return refusal_by([&] { first_line_of(text).point(); });
  };
  EXPECT_THAT(refused("1 2"), testing::HasSubstr("three coordinates expected"));
  EXPECT_THAT(refused("\n1 2 nan"), testing::HasSubstr("not finite"));
  EXPECT_THAT(refused("\n1 2 1e999"), testing::HasSubstr("made-up.mesh:2:"));
  EXPECT_THAT(refused("1 2 abc"), testing::HasSubstr("\"abc\" is not a number"));
  EXPECT_THAT(refused("1 2 3,5"), testing::HasSubstr("no comma"));
  EXPECT_THAT(refused("1 2 3,"), testing::Not(testing::HasSubstr("no comma")));
  EXPECT_EQ(first_line_of("1 2 1e-999").point().z(), 0);
}

TEST(MeshScanner, whole_numbers_may_be_written_with_a_point_which_is_told) {
  MeshScanner scan = first_line_of("7 +8 9.0 -3 1e2");
  EXPECT_EQ(scan.count("a number"), 7u);
  EXPECT_EQ(scan.count("a number"), 8u);
  Remarks before;
  scan.remark_to(before);
  EXPECT_TRUE(before.empty());
  EXPECT_EQ(scan.count("a number"), 9u);
  EXPECT_EQ(scan.integer(scan.word(), "a number"), -3);
  EXPECT_EQ(scan.integer(scan.word(), "a number"), 100);
  Remarks remarks;
  scan.remark_to(remarks);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_EQ(remarks[0], "line 1: 2 whole numbers written with a point");
  const auto refused = [](std::string_view text) {
    return refusal_by([&] { first_line_of(text).count("a number of corners"); });
  };
  for (const char* text : {"-1", "1.5", "1e300", "x", "9007199254740992.0"})
    EXPECT_THAT(refused(text), testing::HasSubstr("is not a number of corners")) << text;
  MeshScanner at_end = first_line_of("a");
  at_end.word();
  EXPECT_THAT(refusal_by([&] { at_end.count("a number of corners"); }),
              testing::HasSubstr("the line ends where a number of corners is expected"));
}

TEST(MeshScanner, the_exponent_sign_of_fortran_is_told) {
  MeshScanner scan = first_line_of("1D0 -2.5d-1 3");
  EXPECT_EQ(scan.point(), Vec3(1, -0.25, 3));
  Remarks remarks;
  scan.remark_to(remarks);
  EXPECT_EQ(remarks, (Remarks{"line 1: 2 numbers with the exponent sign D of Fortran"}));
}

TEST(MeshScanner, an_index_is_below_the_number_of_vertices) {
  EXPECT_EQ(first_line_of("0").index(3), 0u);
  EXPECT_EQ(first_line_of("2").index(3), 2u);
  for (const char* text : {"3", "-1"})
    EXPECT_THAT(refusal_by([&] { first_line_of(text).index(3); }),
                testing::HasSubstr("is out of range (0 to 2)"));
}

TEST(MeshScanner, a_number_that_is_passed_over_has_to_be_one) {
  MeshScanner scan = first_line_of("nan 2 x");
  scan.check_number();
  scan.check_number();
  EXPECT_THAT(refusal_by([&] { scan.check_number(); }), testing::HasSubstr("is not a number"));
  EXPECT_THAT(refusal_by([&] { scan.check_number(); }), testing::HasSubstr("ends too early"));
}

TEST(MeshScanner, what_fills_a_file_up_is_no_line) {
  MeshScanner scan = scan_of(std::string_view("a\nb\n\x1a\0\0\0", 8));
  scan.drop_end_marks();
  EXPECT_EQ(words_of(scan), (Words{{"1", "a"}, {"2", "b"}}));
  Remarks remarks;
  scan.remark_to(remarks);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_THAT(remarks[0], testing::StartsWith("4 bytes"));
}

TEST(MeshScanner, a_refusal_names_file_line_and_word) {
  MeshScanner scan = scan_of("\n\nabc");
  EXPECT_THAT(refusal_by([&] { scan.refuse("why"); }), testing::HasSubstr(":1: why"));
  scan.next_line();
  const std::string what = refusal_by([&] { scan.refuse("why"); });
  EXPECT_THAT(what, testing::StartsWith(scanned_file));
  EXPECT_THAT(what, testing::HasSubstr(":3: why"));
  EXPECT_EQ(shown("a\tb\x80"), "\"a\\x09b\\x80\"");
  EXPECT_EQ(shown(std::string(41, 'x')), "\"" + std::string(40, 'x') + "...\"");
  EXPECT_EQ(shown(std::string(40, 'x')), "\"" + std::string(40, 'x') + "\"");
}

TEST(MeshScanner, long_text_can_be_cancelled) {
  std::string text;
  for (int i = 0; i < 40000; ++i) text += "x\n";
  std::vector<double> told;
  const Progress note = [&](double share) { return told.push_back(share), told.size() < 2; };
  MeshScanner scan(scanned_file, text, '\0', false, note);
  EXPECT_THROW(while (scan.next_line()){}, Cancelled);
  ASSERT_EQ(told.size(), 2u);
  EXPECT_GT(told[0], 0);
  EXPECT_GT(told[1], told[0]);
  EXPECT_LT(told[1], 1);
}

}  // namespace
}  // namespace sonde
