// SPDX-License-Identifier: GPL-3.0-or-later
// The reference is what the words of the standard ask for; with GCC's library, its arrangement of
// equal elements as well.
#include "engine/base/ordering.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <queue>
#include <random>
#include <set>
#include <vector>

namespace sonde {
namespace {

struct Item {
  long key = 0;
  std::size_t place = 0;
  bool operator==(const Item&) const = default;
  bool operator<(const Item& o) const { return key < o.key; }
};

/// Of few and many different keys, in disorder, in order, backwards, and as a mountain.
std::vector<std::vector<Item>> sequences() {
  std::mt19937 random(1);
  std::vector<std::vector<Item>> out;
  for (const std::size_t size : {0u, 1u, 2u, 3u, 4u, 15u, 16u, 17u, 40u, 333u, 2000u})
    for (const int keys : {1, 2, 7, 100, 1'000'000})
      for (int shape = 0; shape < 4; ++shape) {
        std::vector<Item> items(size);
        for (Item& item : items)
          item.key = static_cast<long>(random() % static_cast<unsigned>(keys));
        if (shape > 0) std::ranges::stable_sort(items, {}, &Item::key);
        if (shape == 2) std::ranges::reverse(items);
        if (shape == 3) std::reverse(items.begin() + std::ptrdiff_t(size / 2), items.end());
        for (std::size_t i = 0; i < size; ++i) items[i].place = i;
        out.push_back(items);
      }
  return out;
}

std::vector<long> keys(const std::vector<Item>& items) {
  std::vector<long> out;
  for (const Item& item : items) out.push_back(item.key);
  return out;
}

void expect_the_same_items(const std::vector<Item>& got, const std::vector<Item>& given) {
  std::set<std::size_t> places;
  for (const Item& item : got) {
    EXPECT_TRUE(places.insert(item.place).second);
    EXPECT_EQ(given[item.place].key, item.key);
  }
  EXPECT_EQ(got.size(), given.size());
}

void expect_gcc_s([[maybe_unused]] const std::vector<Item>& got,
                  [[maybe_unused]] const std::vector<Item>& with_std) {
#ifdef __GLIBCXX__
  EXPECT_EQ(got, with_std);
#endif
}

TEST(Ordering, sorts) {
  for (const std::vector<Item>& given : sequences()) {
    std::vector<Item> got = given, with_std = given;
    ordering::sort(got.begin(), got.end());
    std::sort(with_std.begin(), with_std.end());
    EXPECT_EQ(keys(got), keys(with_std));
    expect_the_same_items(got, given);
    expect_gcc_s(got, with_std);
    got = given, with_std = given;
    ordering::sort(got, std::greater<>(), &Item::key);
    std::ranges::sort(with_std, std::greater<>(), &Item::key);
    EXPECT_EQ(keys(got), keys(with_std));
    expect_gcc_s(got, with_std);
  }
}

TEST(Ordering, selects) {
  for (const std::vector<Item>& given : sequences())
    for (const std::size_t part : {0u, 1u, 2u, 3u, 4u}) {
      const auto nth = static_cast<std::ptrdiff_t>(given.size() * part / 4);
      std::vector<Item> got = given, with_std = given;
      ordering::nth_element(got.begin(), got.begin() + nth, got.end());
      std::nth_element(with_std.begin(), with_std.begin() + nth, with_std.end());
      expect_the_same_items(got, given);
      expect_gcc_s(got, with_std);
      if (nth == std::ssize(got)) continue;
      const long key = got[static_cast<std::size_t>(nth)].key;
      EXPECT_TRUE(
          std::all_of(got.begin(), got.begin() + nth, [&](auto& x) { return x.key <= key; }));
      EXPECT_TRUE(std::all_of(got.begin() + nth, got.end(), [&](auto& x) { return x.key >= key; }));
    }
}

TEST(Ordering, sorts_the_least) {
  for (const std::vector<Item>& given : sequences())
    for (const std::size_t part : {0u, 1u, 2u, 3u, 4u}) {
      const auto middle = static_cast<std::ptrdiff_t>(given.size() * part / 4);
      std::vector<Item> got = given, with_std = given;
      ordering::partial_sort(got.begin(), got.begin() + middle, got.end(), std::less<>());
      std::partial_sort(with_std.begin(), with_std.begin() + middle, with_std.end());
      expect_the_same_items(got, given);
      for (std::ptrdiff_t i = 0; i < middle; ++i)
        EXPECT_EQ(got[static_cast<std::size_t>(i)].key, with_std[static_cast<std::size_t>(i)].key);
      if (middle > 0) expect_gcc_s(got, with_std);
    }
}

TEST(Ordering, parts) {
  for (const std::vector<Item>& given : sequences()) {
    const auto fits = [](const Item& x) { return x.key % 2 == 0; };
    std::vector<Item> got = given, with_std = given;
    const auto cut = ordering::partition(got.begin(), got.end(), fits);
    std::partition(with_std.begin(), with_std.end(), fits);
    EXPECT_TRUE(std::all_of(got.begin(), cut, fits));
    EXPECT_TRUE(std::none_of(cut, got.end(), fits));
    expect_the_same_items(got, given);
    expect_gcc_s(got, with_std);
  }
}

TEST(Ordering, queues_the_greatest_first) {
  for (const std::vector<Item>& given : sequences()) {
    ordering::Queue<Item> queue;
    std::priority_queue<Item> with_std;
    std::vector<Item> got, of_std;
    const auto pop = [&] {
      got.push_back(queue.top()), of_std.push_back(with_std.top());
      queue.pop(), with_std.pop();
    };
    for (std::size_t i = 0; i < given.size(); ++i) {
      queue.push(given[i]), with_std.push(given[i]);
      if (i % 3 == 2) pop();
    }
    while (!queue.empty()) pop();
    EXPECT_EQ(keys(got), keys(of_std));
    expect_the_same_items(got, given);
    expect_gcc_s(got, of_std);
  }
}

}  // namespace
}  // namespace sonde
