// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/base/progress.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace sonde {
namespace {

TEST(Progress, each_index_once_in_order) {
  for (const std::size_t n : {0u, 1u, 65535u, 65536u, 65537u, 200000u}) {
    std::vector<std::size_t> seen;
    for_each_index(n, {}, [&](std::size_t i) { seen.push_back(i); });
    ASSERT_EQ(seen.size(), n);
    for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(seen[i], i);
  }
}

TEST(Progress, reports_piece_by_piece) {
  std::vector<double> seen;
  const auto keep = [&](double f) {
    seen.push_back(f);
    return true;
  };
  for_each_index(4 << 16, keep, [](std::size_t) {});
  EXPECT_THAT(seen, testing::ElementsAre(0, 0.25, 0.5, 0.75));
}

TEST(Progress, cancelling_ends_the_loop_at_that_piece) {
  std::size_t calls = 0, steps = 0;
  EXPECT_THROW(for_each_index(
                   4 << 16, [&](double) { return ++calls < 3; }, [&](std::size_t) { ++steps; }),
               Cancelled);
  EXPECT_EQ(steps, std::size_t{2} << 16);
}

TEST(Progress, parts_of_parts) {
  double seen = -1;
  const Progress whole = [&](double f) {
    seen = f;
    return f < 0.6;
  };
  const Progress half = part_of(whole, 0.5, 1), quarter = part_of(half, 0, 0.5);
  EXPECT_TRUE(quarter(0));
  EXPECT_EQ(seen, 0.5);
  EXPECT_FALSE(quarter(1));
  EXPECT_EQ(seen, 0.75);
  EXPECT_FALSE(part_of({}, 0, 1));
}

}  // namespace
}  // namespace sonde
