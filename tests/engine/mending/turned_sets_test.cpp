// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/turned_sets.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace sonde {
namespace {

// Reference: colours that are drawn first; every pair is joined by whether these differ.
TEST(TurnedSets, keep_what_is_turned_against_what) {
  std::mt19937 random(3);
  constexpr std::uint32_t n = 500;
  std::vector<bool> colour(n);
  for (std::uint32_t i = 0; i < n; ++i) colour[i] = random() % 2 == 0;
  TurnedSets sets(n);
  for (int k = 0; k < 2000; ++k) {
    const auto a = static_cast<std::uint32_t>(random() % n);
    const auto b = static_cast<std::uint32_t>(random() % n);
    EXPECT_TRUE(sets.join(a, b, colour[a] != colour[b]));
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const TurnedSets::Place place = sets.find(i);
    EXPECT_LE(place.set, i);
    EXPECT_EQ(place.turned, colour[i] != colour[place.set]);
  }
}

TEST(TurnedSets, a_circle_that_comes_back_turned_is_told) {
  TurnedSets sets(3);
  EXPECT_TRUE(sets.join(0, 1, true));
  EXPECT_TRUE(sets.join(1, 2, false));
  EXPECT_FALSE(sets.join(2, 0, false));
  EXPECT_TRUE(sets.join(2, 0, true));
}

}  // namespace
}  // namespace sonde
