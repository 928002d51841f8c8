// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/text/number_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace sonde {
namespace {

TEST(NumberText, seventeen_digits_read_back_to_the_bit) {
  EXPECT_EQ(number_text(0.1, 17), "0.10000000000000001");
  for (const double x : {0.1, 1.0 / 3, -2e-308, 5e-324, 1.7976931348623157e308, 0.0, 123456789.0}) {
    EXPECT_EQ(parse_number(number_text(x, 17)), x);
    EXPECT_EQ(parse_number(number_text(x)), x);
  }
  EXPECT_TRUE(std::signbit(*parse_number(number_text(-0.0, 17))));
}

TEST(NumberText, few_digits_for_people) {
  EXPECT_EQ(number_text(1.0 / 3, 6), "0.333333");
  EXPECT_EQ(number_text(1000), "1000");
}

TEST(NumberText, what_is_too_small_for_a_double_is_zero_and_what_is_too_large_is_none) {
  const std::string zeros(400, '0');
  for (const std::string& small :
       {std::string("1e-400"), std::string("-1E-400"), "0." + zeros + "1", "0." + zeros + "1e+3",
        std::string("1e-99999999999999999999"), std::string("12.5e-340")})
    EXPECT_EQ(parse_number(small), 0) << small;
  for (const std::string& large : {std::string("1e400"), "1" + zeros, "1" + zeros + "e-20",
                                   std::string("1e99999999999999999999")})
    EXPECT_FALSE(parse_number(large)) << large;
  EXPECT_EQ(parse_number("1" + zeros + "e-400"), 1);
}

TEST(NumberText, the_whole_text_must_be_a_number) {
  EXPECT_EQ(parse_number("+1.5"), 1.5);
  for (const char* text : {"", "+", "+-1", "1 ", " 1", "1,5", "1e999", "0x1p3", "one"})
    EXPECT_FALSE(parse_number(text)) << text;
}

}  // namespace
}  // namespace sonde
