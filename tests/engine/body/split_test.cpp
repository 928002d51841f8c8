// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/body/split.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

SplitItem item_at(const Vec3& middle, double half, std::uint32_t triangle) {
  SplitItem out{};
  out.triangle = triangle;
  for (int i = 0; i < 3; ++i) {
    out.low[i] = static_cast<float>(middle[i] - half);
    out.high[i] = static_cast<float>(middle[i] + half);
  }
  return out;
}
std::vector<SplitItem> random_items(std::mt19937_64& random, std::size_t count) {
  std::vector<SplitItem> out;
  for (std::size_t i = 0; i < count; ++i)
    out.push_back(item_at(test::random_in_ball(random, 1), test::uniform(random, 0, 0.1),
                          static_cast<std::uint32_t>(i)));
  return out;
}
std::set<std::uint32_t> triangles_of(std::span<const SplitItem> items) {
  std::set<std::uint32_t> out;
  for (const SplitItem& item : items) out.insert(item.triangle);
  return out;
}

// Reference: by hand.
TEST(Split, bounds_and_half_area_are_those_of_the_box_around_all) {
  const std::vector<SplitItem> items{item_at({0, 0, 0}, 0.5, 0), item_at({1.5, 0, -1}, 0.5, 1),
                                     item_at({0, 2, 0}, 0.25, 2)};
  const auto [low, high] = bounds(items);
  EXPECT_EQ(low, Eigen::Vector3f(-0.5f, -0.5f, -1.5f));
  EXPECT_EQ(high, Eigen::Vector3f(2, 2.25f, 0.5f));
  EXPECT_EQ(half_area(items), 2.5 * 2.75 + 2.75 * 2 + 2 * 2.5);
  EXPECT_EQ(half_area({}), 0);
}

TEST(Split, neither_side_is_empty_and_no_item_is_lost) {
  std::mt19937_64 random(1);
  for (const std::size_t count : {2u, 3u, 16u, 17u, 100u, 512u, 513u, 3000u})
    for (const std::size_t whole : {1u, 4u, 16u})
      for (const SplitBy by : {SplitBy::cost, SplitBy::half}) {
        std::vector<SplitItem> items = random_items(random, count);
        const std::size_t left = split(items, by, whole);
        EXPECT_GT(left, 0u) << count;
        EXPECT_LT(left, count);
        EXPECT_EQ(triangles_of(items).size(), count);
        if (count <= 512 && count > whole) {
          EXPECT_EQ(left % whole, 0u) << count << " " << whole;
        }
      }
}

TEST(Split, items_at_one_place_are_split_by_count) {
  for (const SplitBy by : {SplitBy::cost, SplitBy::half}) {
    std::vector<SplitItem> items;
    for (std::uint32_t i = 0; i < 600; ++i) items.push_back(item_at({1, 2, 3}, 0.1, i));
    EXPECT_EQ(split(items, by, 16), 300u);
  }
}

// Reference: by hand. Along the longest axis, the lower half of the middles goes to the left.
TEST(Split, a_half_is_cut_along_the_longest_axis) {
  std::mt19937_64 random(2);
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<SplitItem> items = random_items(random, 1000);
    for (SplitItem& item : items) item.low[axis] *= 3, item.high[axis] *= 3;
    const std::size_t left = split(items, SplitBy::half, 16);
    EXPECT_EQ(left, 500u);
    const auto middle = [&](const SplitItem& item) { return item.low[axis] + item.high[axis]; };
    float highest = -1e9f, lowest = 1e9f;
    for (std::size_t i = 0; i < items.size(); ++i)
      if (i < left)
        highest = std::max(highest, middle(items[i]));
      else
        lowest = std::min(lowest, middle(items[i]));
    EXPECT_LE(highest, lowest);
  }
}

// Reference: by hand. Two heaps of different size, far apart along an axis that is not the longest
// of the whole, are the cheapest two sides.
TEST(Split, by_cost_two_heaps_come_apart) {
  std::mt19937_64 random(3);
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<SplitItem> items;
    for (std::uint32_t i = 0; i < 900; ++i) {
      Vec3 at = test::random_in_ball(random, 1);
      at[axis] = 0.01 * at[axis] + (i < 300 ? -0.8 : 0.8);
      items.push_back(item_at(at, 0.01, i));
    }
    std::shuffle(items.begin(), items.end(), random);
    const std::size_t left = split(items, SplitBy::cost, 16);
    ASSERT_EQ(left, 300u);
    for (std::size_t i = 0; i < left; ++i) EXPECT_LT(items[i].triangle, 300u);
  }
}

// Reference: the cost at every cut between two neighbouring middles along each axis. The sixteen
// bins come near to the cheapest.
TEST(Split, by_cost_is_little_dearer_than_the_cheapest_cut) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 10; ++i) {
    std::vector<SplitItem> items = random_items(random, 600);
    for (SplitItem& item : items)
      for (int k = 0; k < 3; ++k) {
        const float stretch = i % 3 == k ? 4.0f : 1.0f;
        item.low[k] *= stretch, item.high[k] *= stretch;
      }
    const auto cost_of = [](std::span<const SplitItem> all, std::size_t left) {
      return half_area(all.first(left)) * double(left) +
             half_area(all.subspan(left)) * double(all.size() - left);
    };
    double cheapest = 1e300;
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<SplitItem> sorted = items;
      std::ranges::sort(sorted, {},
                        [axis](const SplitItem& item) { return item.low[axis] + item.high[axis]; });
      for (std::size_t left = 1; left < sorted.size(); ++left)
        cheapest = std::min(cheapest, cost_of(sorted, left));
    }
    const std::size_t left = split(items, SplitBy::cost, 16);
    EXPECT_GE(cost_of(items, left), cheapest * (1 - 1e-12));
    EXPECT_LE(cost_of(items, left), 1.03 * cheapest);
  }
}

}  // namespace
}  // namespace sonde
