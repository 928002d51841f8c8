// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/recording/columns.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace sonde::test {
namespace {

TEST(Columns, planes_are_as_the_manual_says) {
  // By hand: 0x0102, then 0x0102 ^ 0x0103 = 1, low bytes first.
  const std::array<std::uint64_t, 2> bits{0x0102, 0x0103};
  std::string out = "x";
  append_planes(out, bits, 4);
  EXPECT_EQ(out, std::string("x\x02\x01\x01\0\0\0\0\0", 9));
}

TEST(Columns, a_number_beyond_what_a_field_can_hold_becomes_the_nearest) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(field_of<int>(3.2e9), std::numeric_limits<int>::max());
  EXPECT_EQ(field_of<int>(-inf), std::numeric_limits<int>::min());
  EXPECT_EQ(field_of<int>(std::nan("")), 0);
  EXPECT_EQ(field_of<int>(-7), -7);
  EXPECT_EQ(field_of<std::uint64_t>(0x1p64), std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(field_of<std::uint64_t>(0x1p63), std::uint64_t{1} << 63);
  EXPECT_EQ(field_of<std::uint8_t>(-1), 0);
  EXPECT_EQ(field_of<double>(inf), inf);
  EXPECT_EQ(bits_of(0x1p64, Stored::u64), std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(bits_of(300, Stored::u8), 255U);
}

TEST(Columns, numbers_of_each_width_come_back_to_the_bit) {
  std::mt19937_64 random(5);
  for (const std::size_t width : {1u, 4u, 8u}) {
    std::vector<std::uint64_t> bits(1000);
    for (std::uint64_t& b : bits) b = random() >> (64 - 8 * width);
    std::string out;
    append_planes(out, bits, width);
    out += "rest";
    std::string_view in = out;
    EXPECT_EQ(take_planes(in, bits.size(), width), bits);
    EXPECT_EQ(in, "rest");
  }
}

TEST(Columns, doubles_are_exact_and_floats_the_nearest) {
  for (const double x :
       {0.0, -0.0, 1.0 / 3, -1e300, 5e-324, std::numeric_limits<double>::infinity()})
    EXPECT_EQ(bits_of(value_of(bits_of(x, Stored::f64), Stored::f64), Stored::f64),
              bits_of(x, Stored::f64));
  EXPECT_TRUE(std::isnan(value_of(bits_of(std::nan(""), Stored::f64), Stored::f64)));
  EXPECT_EQ(value_of(bits_of(1.0 / 3, Stored::f32), Stored::f32), double(1.0f / 3));
  EXPECT_EQ(value_of(bits_of(9007199254740992.0, Stored::u64), Stored::u64), 9007199254740992.0);
  EXPECT_EQ(value_of(bits_of(255, Stored::u8), Stored::u8), 255);
}

TEST(Columns, what_is_cut_anywhere_is_refused) {
  struct Row {
    double x = 0;
  };
  const std::array columns{Column<Row>{"x", "m", Stored::f64, [](const Row& r) { return r.x; },
                                       [](Row& r, double x) { r.x = x; }}};
  const std::array<Row, 3> rows{{{1}, {2}, {3}}};
  std::string out;
  append_table<Row>(out, rows, columns);
  for (std::size_t size = 0; size < out.size(); ++size) {
    std::string_view in = std::string_view(out).substr(0, size);
    EXPECT_THROW(take_table<Row>(in, columns), std::invalid_argument) << size;
  }
  std::string_view whole = out;
  EXPECT_EQ(take_table<Row>(whole, columns)[2].x, 3);
}

TEST(Columns, a_count_beyond_what_is_there_allocates_nothing) {
  std::string_view in("\xff\xff\xff\xff", 4);
  EXPECT_THROW(take_planes(in, std::numeric_limits<std::size_t>::max(), 8), std::invalid_argument);
}

}  // namespace
}  // namespace sonde::test
