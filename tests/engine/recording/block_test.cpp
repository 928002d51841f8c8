// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/recording/block.hpp"

#include <limits>
#include <stdexcept>

#include "tests/engine/recording/made_up_ticks.hpp"

namespace sonde::test {
namespace {

TEST(Block, the_head_says_what_follows) {
  const std::vector<Snapshot> ticks = made_up_ticks(100);
  const std::string block = tick_block(ticks);
  const BlockHead head = head_of(block);
  EXPECT_EQ(head.kind, BlockKind::ticks);
  EXPECT_EQ(head.rows, 100u);
  EXPECT_EQ(head.first, ticks.front().time);
  EXPECT_EQ(head.last, ticks.back().time);
  EXPECT_EQ(block.size(), BlockHead::size + head.packed);
  EXPECT_EQ(content_of(head, block), tick_content(ticks));
  EXPECT_EQ(head_of(end_block(7)).rows, 7u);
  EXPECT_EQ(head_of(end_block(7)).kind, BlockKind::end);
}

TEST(Block, any_bit_that_is_another_is_noticed) {
  const std::string block = tick_block(made_up_ticks(8));
  for (std::size_t bit = 0; bit < 8 * block.size(); ++bit) {
    std::string damaged = block;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
    EXPECT_THROW(content_of(head_of(damaged), damaged), std::invalid_argument) << bit;
  }
}

// Reference: the widths of a row's columns, added up.
TEST(Block, of_more_rows_than_it_can_hold_is_none) {
  std::string block = tick_block(made_up_ticks(8));
  std::size_t row = 0;
  for (const auto& column : tick_columns()) row += width(column.as);
  const std::size_t most = head_of(block).raw / row;
  ASSERT_LT(most, 0x7fu);
  const auto with_rows = [&](std::size_t rows) {
    block[12] = static_cast<char>(rows);  // the lowest byte of the rows
    return block;
  };
  EXPECT_NO_THROW(head_of(with_rows(most)));
  for (const std::size_t rows : {std::size_t{0}, most + 1, std::size_t{0x7f}})
    EXPECT_THROW(head_of(with_rows(rows)), std::invalid_argument) << rows;
}

// The head's layout is that of block.hpp: sizes at 4 and 8, times at 16 and 24.
TEST(Block, larger_than_any_of_ours_is_none) {
  const std::string block = tick_block(made_up_ticks(8));
  for (const std::size_t highest_byte : {std::size_t{7}, std::size_t{11}}) {
    std::string damaged = block;
    damaged.replace(highest_byte - 3, 4, std::string("\x01\x00\x00\x10", 4));  // 2^28 + 1
    EXPECT_THROW(head_of(damaged), std::invalid_argument) << highest_byte;
    damaged[highest_byte - 3] = '\0';
    EXPECT_NO_THROW(head_of(damaged)) << highest_byte;
  }
}

TEST(Block, whose_times_fall_or_are_none_is_none) {
  const auto with_times = [](double first, double last) {
    std::string out = tick_block(made_up_ticks(8));
    out.replace(16, 8, reinterpret_cast<const char*>(&first), 8);
    out.replace(24, 8, reinterpret_cast<const char*>(&last), 8);
    return out;
  };
  EXPECT_NO_THROW(head_of(with_times(1, 2)));
  EXPECT_NO_THROW(head_of(with_times(1, 1)));
  EXPECT_THROW(head_of(with_times(2, 1)), std::invalid_argument);
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_THROW(head_of(with_times(1, infinite)), std::invalid_argument);
  EXPECT_THROW(head_of(with_times(-infinite, 1)), std::invalid_argument);
  EXPECT_THROW(head_of(with_times(std::numeric_limits<double>::quiet_NaN(), 1)),
               std::invalid_argument);
}

TEST(Block, what_is_there_is_smaller_where_nothing_moves) {
  const std::vector<Snapshot> moving = made_up_ticks(500);
  std::vector<Snapshot> still(500, moving[6]);
  for (std::size_t i = 0; i < still.size(); ++i) still[i].time = moving[i].time;
  EXPECT_LT(tick_block(still).size(), tick_block(moving).size() / 10);
}

}  // namespace
}  // namespace sonde::test
