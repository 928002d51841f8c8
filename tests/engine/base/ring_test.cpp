// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/base/ring.hpp"

#include <gtest/gtest.h>

#include <array>
#include <thread>

#include "tests/support/allocation_counter.hpp"

namespace sonde {
namespace {

TEST(Ring, gives_back_what_went_in_in_order) {
  Ring<int> ring(3);
  int x = 0;
  EXPECT_FALSE(ring.pop(x));
  for (int round = 0; round < 10; ++round) {
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(ring.push(10 * round + i));
    for (int i = 0; i < 3; ++i) {
      ASSERT_TRUE(ring.pop(x));
      EXPECT_EQ(x, 10 * round + i);
    }
    EXPECT_FALSE(ring.pop(x));
  }
  EXPECT_EQ(ring.lost(), 0u);
}

TEST(Ring, drops_the_new_and_counts_the_losses_where_it_is_full) {
  Ring<int> ring(2);
  EXPECT_TRUE(ring.push(1));
  EXPECT_TRUE(ring.push(2));
  EXPECT_FALSE(ring.push(3));
  EXPECT_FALSE(ring.push(4));
  EXPECT_EQ(ring.lost(), 2u);
  int x = 0;
  EXPECT_TRUE(ring.pop(x));
  EXPECT_EQ(x, 1);
  EXPECT_TRUE(ring.push(5));
  EXPECT_TRUE(ring.pop(x));
  EXPECT_TRUE(ring.pop(x));
  EXPECT_EQ(x, 5);
  ring.clear();
  EXPECT_EQ(ring.lost(), 0u);
  EXPECT_FALSE(ring.pop(x));
}

TEST(Ring, push_and_pop_do_not_allocate) {
  Ring<int> ring(16);
  int x = 0;
  test::AllocationCounter counter;
  for (int i = 0; i < 100; ++i) ring.push(i);
  while (ring.pop(x)) {
  }
  counter.stop();
  EXPECT_EQ(counter.allocations() + counter.frees(), 0u);
  EXPECT_EQ(x, 15);
}

TEST(Ring, two_threads_lose_nothing_uncounted) {
  using Block = std::array<std::uint64_t, 40>;
  constexpr std::uint64_t writes = 20'000;
  Ring<Block> ring(64);
  std::atomic<bool> done{false};
  std::thread writer([&] {
    Block block;
    for (std::uint64_t i = 1; i <= writes; ++i) {
      block.fill(i);
      ring.push(block);
      if (i % 200 == 0) std::this_thread::yield();
    }
    done.store(true, std::memory_order_release);
  });
  std::uint64_t got = 0, last = 0, torn = 0, backwards = 0;
  Block block;
  for (;;) {
    const bool was_done = done.load(std::memory_order_acquire);
    while (ring.pop(block)) {
      ++got;
      for (const std::uint64_t word : block) torn += word != block[0];
      backwards += block[0] <= last;
      last = block[0];
    }
    if (was_done) break;
  }
  writer.join();
  EXPECT_EQ(torn, 0u);
  EXPECT_EQ(backwards, 0u);
  EXPECT_GE(got, 64u);  // what the ring still held when the writer was done, at least
  EXPECT_EQ(got + ring.lost(), writes);
}

}  // namespace
}  // namespace sonde
