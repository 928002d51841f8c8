// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/base/triple_buffer.hpp"

#include <gtest/gtest.h>

#include <array>
#include <thread>

namespace sonde {
namespace {

TEST(TripleBuffer, has_nothing_fresh_before_the_first_publish) {
  TripleBuffer<int> buffer(7);
  EXPECT_FALSE(buffer.update());
  EXPECT_EQ(buffer.front(), 7);
}

TEST(TripleBuffer, hands_over_each_value_once) {
  TripleBuffer<int> buffer;
  for (int i = 1; i < 20; ++i) {
    buffer.write(i);
    EXPECT_TRUE(buffer.update());
    EXPECT_EQ(buffer.front(), i);
    EXPECT_FALSE(buffer.update());
    EXPECT_EQ(buffer.front(), i);
  }
}

TEST(TripleBuffer, the_newest_wins) {
  TripleBuffer<int> buffer;
  for (int i = 1; i <= 7; ++i) buffer.write(i);
  EXPECT_TRUE(buffer.update());
  EXPECT_EQ(buffer.front(), 7);
  EXPECT_FALSE(buffer.update());
}

TEST(TripleBuffer, the_reader_keeps_its_value_while_the_writer_goes_on) {
  TripleBuffer<int> buffer;
  buffer.write(1);
  buffer.update();
  for (int i = 2; i < 50; ++i) {
    buffer.back() = i;  // half a write, not published
    EXPECT_EQ(buffer.front(), 1);
    buffer.publish();
    EXPECT_EQ(buffer.front(), 1);
  }
}

TEST(TripleBuffer, fill_starts_over) {
  TripleBuffer<int> buffer;
  buffer.write(1);
  buffer.fill(5);
  EXPECT_FALSE(buffer.update());
  EXPECT_EQ(buffer.front(), 5);
  buffer.write(6);
  EXPECT_TRUE(buffer.update());
  EXPECT_EQ(buffer.front(), 6);
}

/// As large as a snapshot, every word the same: half a value would show.
using Block = std::array<std::uint64_t, 600>;

TEST(TripleBuffer, two_threads_never_see_half_a_value_nor_an_older_one) {
  constexpr std::uint64_t writes = 100'000;
  TripleBuffer<Block> buffer;
  std::thread writer([&buffer] {
    for (std::uint64_t i = 1; i <= writes; ++i) {
      buffer.back().fill(i);
      buffer.publish();
    }
  });
  std::uint64_t last = 0, updates = 0, torn = 0, backwards = 0;
  while (last < writes) {
    if (!buffer.update()) {
      std::this_thread::yield();
      continue;
    }
    ++updates;
    const Block& block = buffer.front();
    for (const std::uint64_t word : block) torn += word != block[0];
    backwards += block[0] <= last;
    last = block[0];
  }
  writer.join();
  EXPECT_EQ(torn, 0u);
  EXPECT_EQ(backwards, 0u);
  EXPECT_GT(updates, 1u);
  EXPECT_EQ(last, writes);
}

}  // namespace
}  // namespace sonde
