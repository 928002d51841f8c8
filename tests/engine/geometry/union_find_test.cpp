// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/union_find.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

namespace sonde {
namespace {

/// Reference: a label for each number, changed one by one at every join.
TEST(UnionFind, finds_the_least_of_what_is_joined) {
  constexpr std::uint32_t n = 60;
  std::mt19937 random(3);
  std::uniform_int_distribution<std::uint32_t> any(0, n - 1);
  UnionFind sets(n);
  std::vector<std::uint32_t> label(n);
  std::iota(label.begin(), label.end(), 0u);
  for (int join = 0; join < 40; ++join) {
    const std::uint32_t a = any(random), b = any(random);
    sets.join(a, b);
    const std::uint32_t from = std::max(label[a], label[b]), to = std::min(label[a], label[b]);
    std::replace(label.begin(), label.end(), from, to);
    for (std::uint32_t i = 0; i < n; ++i) ASSERT_EQ(sets.find(i), label[i]) << join;
  }
}

}  // namespace
}  // namespace sonde
