// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/base/thread_pair.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace sonde {
namespace {

// Reference: a loop. Each piece of work is done once, and is done when each() returns.
TEST(ThreadPair, does_each_piece_once_on_any_number_of_threads) {
  for (const bool two_threads : {false, true}) {
    ThreadPair threads(two_threads);
    for (std::size_t call = 0; call < 2000; ++call) {
      const std::size_t count = call % 9;
      std::vector<int> done(count, 0);
      threads.each(count, [&](std::size_t k, std::size_t lane) {
        EXPECT_EQ(lane, k % 2);
        ++done[k];
      });
      EXPECT_EQ(done, std::vector<int>(count, 1));
    }
  }
}

TEST(ThreadPair, ends_without_work) { const ThreadPair threads(true); }

}  // namespace
}  // namespace sonde
